// SPDX-License-Identifier: BSD-3-Clause
#include "Sense.h"

#include "vtkMedialPrune.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <map>
#include <utility>

namespace fuzz
{
namespace
{
bool isFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(array->GetComponent(i, c)))
      {
        return false;
      }
    }
  }
  return true;
}

std::string badCells(vtkCellArray* cells, vtkIdType pointCount)
{
  if (cells && !cells->IsValid())
  {
    return "cells whose offsets don't fit";
  }
  for (vtkIdType cell = 0; cells && cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(cell, size, corners);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (corners[i] < 0 || corners[i] >= pointCount)
      {
        return "a corner that is no point";
      }
    }
  }
  return "";
}

std::string badColumns(vtkTable* table)
{
  for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
  {
    if (table->GetColumn(column)->GetNumberOfTuples() != table->GetNumberOfRows() ||
      !isFinite(vtkDataArray::SafeDownCast(table->GetColumn(column))))
    {
      return std::string("column ") + table->GetColumnName(column) + " makes no sense";
    }
  }
  return "";
}

double fieldValue(vtkPolyData* surface, const char* name)
{
  vtkDataArray* array = surface->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() == 1 ? array->GetComponent(0, 0) : std::nan("");
}
}

std::string leftOver(vtkDataObject* output)
{
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::ROW })
  {
    if (output->GetNumberOfElements(kind) != 0)
    {
      return "an error, and something is left";
    }
  }
  for (const int kind :
    { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::ROW, vtkDataObject::FIELD })
  {
    vtkFieldData* data = output->GetAttributesAsFieldData(kind);
    if (data && data->GetNumberOfArrays() != 0)
    {
      return "an error, and arrays are left";
    }
  }
  return "";
}

std::string nonsense(vtkDataObject* output)
{
  if (auto* table = vtkTable::SafeDownCast(output))
  {
    return badColumns(table);
  }
  auto* surface = vtkPolyData::SafeDownCast(output);
  if (surface->GetPoints() && !isFinite(surface->GetPoints()->GetData()))
  {
    return "points that are not finite";
  }
  for (vtkCellArray* cells : { surface->GetVerts(), surface->GetLines(), surface->GetPolys() })
  {
    const std::string bad = badCells(cells, surface->GetNumberOfPoints());
    if (!bad.empty())
    {
      return bad;
    }
  }
  return "";
}

std::string badMeasures(vtkDataObject* output)
{
  vtkFieldData* cells = output->GetAttributesAsFieldData(vtkDataObject::CELL);
  for (int measure = 0; vtkMedialPrune::GetMeasureArray(measure); ++measure)
  {
    const char* name = vtkMedialPrune::GetMeasureArray(measure);
    if (!isFinite(cells->GetArray(name)))
    {
      return std::string("values of ") + name + " that are not finite";
    }
  }
  return "";
}

std::string notSolid(vtkPolyData* surface)
{
  std::map<std::pair<vtkIdType, vtkIdType>, int> uses; // of each edge in each direction
  vtkCellArray* triangles = surface->GetPolys();
  for (vtkIdType cell = 0; cell < triangles->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    triangles->GetCellAtId(cell, size, corners);
    for (vtkIdType i = 0; i < size; ++i)
    {
      ++uses[{ corners[i], corners[(i + 1) % size] }];
    }
  }
  bool isClosed = !uses.empty();
  for (const auto& [edge, count] : uses)
  {
    const auto back = uses.find({ edge.second, edge.first });
    isClosed = isClosed && count == 1 && back != uses.end();
  }
  if (!isClosed || fieldValue(surface, "Closed") != 1)
  {
    return uses.empty() ? "is empty" : "isn't closed";
  }
  const double volume = fieldValue(surface, "Volume");
  return volume > 0 && std::isfinite(volume) ? "" : "encloses no volume";
}
}
