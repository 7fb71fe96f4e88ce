// SPDX-License-Identifier: BSD-3-Clause
#include "PartMeshes.h"

#include "Errors.h"
#include "ResultNames.h"
#include "Tables.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFeatureEdges.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>

namespace
{
vtkDataArray* cellArrayOf(vtkPolyData* data, const char* name)
{
  vtkDataArray* array = data->GetCellData()->GetArray(name);
  if (!array)
  {
    throw InputError(std::string("a stage gave no array ") + name);
  }
  return array;
}

std::vector<PartMesh> partsOf(vtkPolyData* axis)
{
  std::vector<PartMesh> result(static_cast<std::size_t>(fieldValue(axis, "NumberOfParts")));
  for (std::size_t part = 0; part < result.size(); ++part)
  {
    result[part].part = static_cast<vtkIdType>(part);
    result[part].patch = vtkSmartPointer<vtkPolyData>::New();
  }
  vtkDataArray *parts = cellArrayOf(axis, "PartId"), *volumes = cellArrayOf(axis, "RelativeVolume");
  for (vtkIdType cell = 0; cell < axis->GetNumberOfCells(); ++cell)
  {
    result.at(static_cast<std::size_t>(parts->GetComponent(cell, 0))).relativeVolume =
      volumes->GetComponent(cell, 0);
  }
  return result;
}

/// The triangles of the surface by their parts.
std::vector<std::vector<vtkIdType>> trianglesOfParts(vtkPolyData* surface, std::size_t partCount)
{
  std::vector<std::vector<vtkIdType>> result(partCount);
  vtkDataArray* parts = cellArrayOf(surface, "PartId");
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    const auto part = static_cast<vtkIdType>(parts->GetComponent(cell, 0));
    if (part >= 0)
    {
      result.at(static_cast<std::size_t>(part)).push_back(cell);
    }
  }
  return result;
}

/// Fills a patch with triangles of the surface.
/// @param newIds  of the surface's points; all -1, before and after
void fill(vtkPolyData* patch, vtkPolyData* surface, const std::vector<vtkIdType>& triangles,
  std::vector<vtkIdType>& newIds)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> cells;
  std::vector<vtkIdType> used;
  for (const vtkIdType triangle : triangles)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    surface->GetPolys()->GetCellAtId(triangle, size, corners);
    cells->InsertNextCell(static_cast<int>(size));
    for (vtkIdType k = 0; k < size; ++k)
    {
      vtkIdType& point = newIds[static_cast<std::size_t>(corners[k])];
      if (point < 0)
      {
        point = points->InsertNextPoint(surface->GetPoint(corners[k]));
        used.push_back(corners[k]);
      }
      cells->InsertCellPoint(point);
    }
  }
  for (const vtkIdType point : used)
  {
    newIds[static_cast<std::size_t>(point)] = -1;
  }
  patch->SetPoints(points);
  patch->SetPolys(cells);
}

bool hasNoOpenEdge(vtkPolyData* patch)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(patch);
  edges->FeatureEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ManifoldEdgesOff();
  edges->BoundaryEdgesOn();
  edges->ColoringOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells() == 0;
}

template <typename Array, typename Value>
void addColumn(
  vtkTable* table, const char* name, const std::vector<PartMesh>& meshes, const Value& value)
{
  vtkNew<Array> column;
  column->SetName(name);
  for (const PartMesh& mesh : meshes)
  {
    column->InsertNextValue(value(mesh));
  }
  table->AddColumn(column);
}
}

std::string PartMesh::file() const
{
  return this->patch->GetNumberOfPolys() > 0 ? partFileName(this->part) : std::string();
}

std::vector<PartMesh> partMeshes(vtkPolyData* prunedAxis, vtkPolyData* surface)
{
  std::vector<PartMesh> result = partsOf(prunedAxis);
  const auto triangles = trianglesOfParts(surface, result.size());
  std::vector<vtkIdType> newIds(static_cast<std::size_t>(surface->GetNumberOfPoints()), -1);
  for (std::size_t part = 0; part < result.size(); ++part)
  {
    fill(result[part].patch, surface, triangles[part], newIds);
    result[part].isClosed = !triangles[part].empty() && hasNoOpenEdge(result[part].patch);
  }
  std::stable_sort(result.begin(), result.end(),
    [](const PartMesh& a, const PartMesh& b) { return a.relativeVolume > b.relativeVolume; });
  return result;
}

vtkSmartPointer<vtkTable> tableOf(const std::vector<PartMesh>& meshes)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  addColumn<vtkIdTypeArray>(
    table, "PartId", meshes, [](const PartMesh& mesh) { return mesh.part; });
  addColumn<vtkStringArray>(
    table, "File", meshes, [](const PartMesh& mesh) { return mesh.file(); });
  addColumn<vtkDoubleArray>(
    table, "RelativeVolume", meshes, [](const PartMesh& mesh) { return mesh.relativeVolume; });
  addColumn<vtkIdTypeArray>(table, "Triangles", meshes,
    [](const PartMesh& mesh) { return mesh.patch->GetNumberOfPolys(); });
  addColumn<vtkIdTypeArray>(
    table, "Closed", meshes, [](const PartMesh& mesh) { return vtkIdType(mesh.isClosed); });
  return table;
}
