// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMedialMeshWriter
 * @brief   writes a medial axis as a .ma file, the form in which programs exchange medial axes
 *
 * Input: vtkPolyData of vertices, lines and triangles, such as the output of vtkMedialAxis, vtkMedialPrune or
 * vtkMedialPartDecomposition, with the point array
 *  - `Radius` (any number): of the ball centred there;
 *
 * and, where wanted, the point array and the cell array
 *  - `Type` (whole numbers): as vtkMedialMeshReader gives them. Of cells, those of the lines count.
 *
 * The file has a line `nv ne nf`, then lines `v x y z r`, `e i j` and `f i j k`, in this order, where points are
 * counted from 0 and numbers have as many digits as it takes to read the same ones back. Points that
 * no cell uses are left out, so those after them get other numbers. Edges are first the lines, then
 * all sides of triangles, since importers count on them. Where points or lines have types, these
 * follow, as in `v x y z r t` and `e i j t`; of a side that is no line the type is 0. Other arrays are
 * not written; `.vtp` files have them.
 *
 * vtkMedialMeshReader reads the same points, lines and triangles back, in the same order and to the last bit,
 * and the vertices at points that nothing else uses, in the order of their points.
 *
 * An error (other cells, no radii, numbers that are not finite, a file that can't be written) sets the error
 * code, and Write() returns 0. No part of a file is left. Under MPI write on one rank.
 *
 * @sa vtkMedialMeshReader vtkMedialAxis
 */

#ifndef vtkMedialMeshWriter_h
#define vtkMedialMeshWriter_h

#include "vtkFiltersMedialModule.h" // for export macro
#include "vtkWriter.h"

#include <string> // for OutputString

class VTKFILTERSMEDIAL_EXPORT vtkMedialMeshWriter : public vtkWriter
{
public:
  static vtkMedialMeshWriter* New();
  vtkTypeMacro(vtkMedialMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to be written; an older one is replaced.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Put the text into OutputString instead of a file. Default off.
   */
  vtkSetMacro(WriteToOutputString, bool);
  vtkGetMacro(WriteToOutputString, bool);
  vtkBooleanMacro(WriteToOutputString, bool);
  ///@}

  /**
   * The text, after it was written there; empty after an error.
   */
  std::string GetOutputString() const { return this->OutputString; }

  /**
   * How the writer is stopped, see vtkPolarBalls. Write() is 0 then, and an older file stays.
   */
  void SetAbortExecute(vtkTypeBool stop) override;
  int ComputePipelineMTime(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port, vtkMTimeType* mtime) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

protected:
  vtkMedialMeshWriter() = default;
  ~vtkMedialMeshWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkMedialMeshWriter(const vtkMedialMeshWriter&) = delete;
  void operator=(const vtkMedialMeshWriter&) = delete;

  char* FileName = nullptr;
  bool WriteToOutputString = false;
  std::string OutputString;
};

#endif
