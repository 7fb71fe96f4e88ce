// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/MedialMesh.h"

#include "Base/Errors.h"
#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Cells.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace medial
{
namespace
{
constexpr const char* TakeMesh =
  "give vertices, lines and triangles, as vtkTriangleFilter makes of other cells, and points with "
  "the array 'Radius'";

/// The types of edges, those of a file between the vertices and the triangles, which have none.
std::vector<Index> typesOfCells(const MedialMesh& mesh)
{
  std::vector<Index> result(mesh.cells.vertices.size(), None);
  result.insert(result.end(), mesh.edgeTypes.begin(), mesh.edgeTypes.end());
  result.resize(mesh.cells.size(), None);
  return result;
}

/// Types may be of either sign.
std::vector<Index> readTypes(vtkFieldData* data, const char* kind, Index count)
{
  const Arrays arrays(data, kind, "leave the array out, or give types as whole numbers");
  return arrays.has(names::Type)
    ? arrays.indices(names::Type, count, std::numeric_limits<Index>::min(), Largest)
    : std::vector<Index>();
}
}

void write(const MedialMesh& mesh, vtkPolyData* output)
{
  std::vector<std::array<Index, 1>> vertices;
  for (const Index point : mesh.cells.vertices)
  {
    vertices.push_back({ point });
  }
  output->SetPoints(points(mesh.points));
  output->SetVerts(cellArray(vertices));
  output->SetLines(cellArray(mesh.cells.edges));
  output->SetPolys(cellArray(mesh.cells.triangles));
  add<vtkDoubleArray>(output->GetPointData(), names::Radius, mesh.radii);
  if (!mesh.pointTypes.empty())
  {
    add<vtkIntArray>(output->GetPointData(), names::Type, mesh.pointTypes);
  }
  if (!mesh.edgeTypes.empty())
  {
    add<vtkIntArray>(output->GetCellData(), names::Type, typesOfCells(mesh));
  }
}

MedialMesh readMedialMesh(vtkPolyData* input)
{
  if (input->GetNumberOfStrips() > 0)
  {
    throw InvalidInput("there are triangle strips: ", TakeMesh);
  }
  const Index pointCount = toIndex(input->GetNumberOfPoints(), "points");
  const Index cellCount = toIndex(input->GetNumberOfCells(), "cells");
  MedialMesh result;
  result.points = readFinitePoints(input, "leave it out");
  result.radii =
    Arrays(input->GetPointData(), "point", TakeMesh).reals(names::Radius, pointCount, 0);
  for (const std::array<Index, 1>& vertex : readCells<1>(input->GetVerts(), pointCount, TakeMesh))
  {
    result.cells.vertices.push_back(vertex[0]);
  }
  result.cells.edges = readCells<2>(input->GetLines(), pointCount, TakeMesh);
  result.cells.triangles = readCells<3>(input->GetPolys(), pointCount, TakeMesh);
  result.pointTypes = readTypes(input->GetPointData(), "point", pointCount);
  const std::vector<Index> types = readTypes(input->GetCellData(), "cell", cellCount);
  if (!types.empty())
  {
    result.edgeTypes.assign(
      types.begin() + result.cells.firstEdge(), types.begin() + result.cells.firstTriangle());
  }
  return result;
}
}
