// SPDX-License-Identifier: BSD-3-Clause
#ifndef Results_h
#define Results_h

#include "Compressor.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

struct Arguments;
class OutputFolder;
class vtkAlgorithm;
class vtkDataObject;
class vtkPolyData;
class vtkSimplifyShape;

/// Writes what the stages of a filter make. The axis and its parts are written as soon as they are made,
/// and need no memory after that.
class Results
{
public:
  /// @param arguments  tell which files are wanted beside those that are always written
  Results(vtkSimplifyShape* simplify, OutputFolder& folder, const Arguments& arguments);
  ~Results();

  /// How many triangles the axis has that was written.
  vtkIdType axisTriangles() const { return this->AxisTriangles; }

  /// How long it took to write what was written while the filter ran.
  double seconds() const { return this->Seconds; }

  /// Is to be called when the filter has run.
  /// @throw InputError  a file could not be written while it ran, so that it was stopped
  void check() const;

  /// Writes the other files.
  /// @throw InputError  a file can't be written
  void writeRest();

private:
  class Writing;

  void writeAfter(vtkAlgorithm* stage, const std::function<void()>& files);
  template <typename Writer>
  void write(vtkDataObject* data, const std::string& name);
  void writeAxis();
  void writeParts();
  void writePruned();
  void writeMedialMesh(vtkPolyData* axis, const std::string& name);
  void writeStl(vtkPolyData* triangles, const std::string& name);
  void writePartMeshes();

  vtkSimplifyShape* Simplify;
  OutputFolder& Folder;
  bool HasMedialMeshes, HasPartMeshes;
  vtkSmartPointer<Compressor> Compression = vtkSmartPointer<Compressor>::New();
  std::vector<std::unique_ptr<Writing>> Writings;
  std::exception_ptr Error;
  vtkIdType AxisTriangles = 0;
  double Seconds = 0;
};

#endif
