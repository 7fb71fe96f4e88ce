// SPDX-License-Identifier: BSD-3-Clause
#ifndef Polygons_h
#define Polygons_h

#include "Resolution.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <string_view>
#include <vector>

/// Collects the points and polygons that a reader finds. It grows with what is there, never by a count that a
/// file announces.
class Polygons
{
public:
  /// @param type  of coordinates, VTK_FLOAT or VTK_DOUBLE: as the file has them
  explicit Polygons(int type)
  {
    this->Points->SetDataType(type);
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
  }

  vtkIdType addPoint(const std::array<double, 3>& point)
  {
    return this->Points->InsertNextPoint(point.data());
  }

  /// Says how the coordinates of a point were written in a text.
  /// @param first  which of the words is x
  void noteWords(const std::vector<std::string_view>& words, std::size_t first)
  {
    for (std::size_t k = first; k < first + 3; ++k)
    {
      this->Unit.add(words[k]);
    }
  }

  /// The same of one coordinate.
  void noteWord(std::string_view word) { this->Unit.add(word); }

  /// Adds the normal of the point that was added last; to be called for all points, or for none.
  void addNormal(const std::array<double, 3>& normal)
  {
    this->Normals->InsertNextTuple(normal.data());
  }

  vtkIdType points() const { return this->Points->GetNumberOfPoints(); }

  /// Begins a polygon.
  void begin() { this->Corners.clear(); }

  /// Adds a corner to it; the caller has checked that the point exists or will exist.
  void add(vtkIdType point) { this->Corners.push_back(point); }

  /// Ends it. Polygons of less than three corners are left out.
  void end()
  {
    if (this->Corners.size() >= 3)
    {
      this->Cells->InsertNextCell(
        static_cast<vtkIdType>(this->Corners.size()), this->Corners.data());
    }
  }

  /// With the point array `Normals`, and the field array `SampleResolution` of vtkPolarBalls, where they
  /// are known.
  vtkSmartPointer<vtkPolyData> take()
  {
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->SetPoints(this->Points);
    result->SetPolys(this->Cells);
    if (this->Normals->GetNumberOfTuples() > 0)
    {
      result->GetPointData()->SetNormals(this->Normals);
    }
    if (this->Unit.value() > 0)
    {
      vtkNew<vtkDoubleArray> unit;
      unit->SetName("SampleResolution");
      unit->InsertNextValue(this->Unit.value());
      result->GetFieldData()->AddArray(unit);
    }
    return result;
  }

private:
  Resolution Unit;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Normals;
  vtkNew<vtkCellArray> Cells;
  std::vector<vtkIdType> Corners;
};

#endif
