// SPDX-License-Identifier: BSD-3-Clause
#include "Triangles.h"

#include <vtkCellArray.h>

vtkSmartPointer<vtkPolyData> inTriangles(vtkPolyData* surface)
{
  vtkNew<vtkCellArray> triangles;
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  vtkCellArray* polygons = surface->GetPolys();
  for (polygons->InitTraversal(); polygons->GetNextCell(size, corners);)
  {
    for (vtkIdType i = 2; i < size; ++i)
    {
      triangles->InsertNextCell({ corners[0], corners[i - 1], corners[i] });
    }
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(surface->GetPoints());
  result->SetPolys(triangles);
  return result;
}
