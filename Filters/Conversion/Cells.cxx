// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Cells.h"

#include "Base/Errors.h"

#include "vtkPointSet.h"
#include "vtkPoints.h"

namespace medial
{
vtkSmartPointer<vtkCellArray> vertexForEach(Index pointCount)
{
  std::vector<std::array<Index, 1>> vertices(pointCount);
  for (Index p = 0; p < pointCount; ++p)
  {
    vertices[p] = { p };
  }
  return cellArray(vertices);
}

std::vector<Point> readPoints(vtkPointSet* input)
{
  std::vector<Point> result(toIndex(input->GetNumberOfPoints(), "points"));
  if (!result.empty() && input->GetPoints()->GetData()->GetNumberOfComponents() != 3)
  {
    throw InvalidInput("the points have ", input->GetPoints()->GetData()->GetNumberOfComponents(),
      " coordinates each instead of 3: give points in space");
  }
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    input->GetPoint(static_cast<vtkIdType>(i), result[i].data());
  }
  return result;
}

std::vector<Point> readFinitePoints(vtkPointSet* input, const char* remedy)
{
  std::vector<Point> result = readPoints(input);
  const auto bad = std::find_if(
    result.begin(), result.end(), [](const Point& point) { return !point.allFinite(); });
  if (bad != result.end())
  {
    throw InvalidInput(
      "point ", bad - result.begin(), " has a coordinate that is not finite: ", remedy);
  }
  return result;
}
}
