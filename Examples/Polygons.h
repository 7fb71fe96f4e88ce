// SPDX-License-Identifier: BSD-3-Clause
#ifndef Polygons_h
#define Polygons_h

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

/// Collects the points and polygons that a reader finds. It grows with what is there, never by a count that a
/// file announces.
class Polygons
{
public:
  /// @param type  of coordinates, VTK_FLOAT or VTK_DOUBLE: as the file has them
  explicit Polygons(int type) { this->Points->SetDataType(type); }

  vtkIdType addPoint(const std::array<double, 3>& point)
  {
    return this->Points->InsertNextPoint(point.data());
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

  vtkSmartPointer<vtkPolyData> take()
  {
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->SetPoints(this->Points);
    result->SetPolys(this->Cells);
    return result;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  std::vector<vtkIdType> Corners;
};

#endif
