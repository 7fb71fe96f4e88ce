// SPDX-License-Identifier: BSD-3-Clause
#include "CellMutations.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace fuzz
{
namespace
{
/// Cells of one kind, and the number of their first one.
struct Group
{
  vtkCellArray* cells;
  vtkIdType first;
};

std::vector<Group> groupsOf(vtkPointSet* data)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    return { { grid->GetCells(), 0 } };
  }
  auto* surface = vtkPolyData::SafeDownCast(data);
  const vtkIdType lines = surface->GetNumberOfVerts();
  const vtkIdType polys = lines + surface->GetNumberOfLines();
  return { { surface->GetVerts(), 0 }, { surface->GetLines(), lines },
    { surface->GetPolys(), polys } };
}

/// Puts a cell array in the place of another one.
void replace(vtkPointSet* data, vtkCellArray* old, vtkCellArray* made)
{
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(data))
  {
    grid->SetCells(VTK_TETRA, made);
    return;
  }
  auto* surface = vtkPolyData::SafeDownCast(data);
  if (old == surface->GetVerts())
  {
    surface->SetVerts(made);
  }
  else if (old == surface->GetLines())
  {
    surface->SetLines(made);
  }
  else
  {
    surface->SetPolys(made);
  }
}

/// Makes the data hold these cells of a group, in this order, each with its values where `withArrays`.
void choose(
  vtkPointSet* data, const Group& group, const std::vector<vtkIdType>& chosen, bool withArrays)
{
  const vtkIdType allBefore = data->GetNumberOfCells();
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < group.first; ++cell)
  {
    ids->InsertNextId(cell);
  }
  vtkNew<vtkCellArray> made;
  for (const vtkIdType cell : chosen)
  {
    vtkNew<vtkIdList> corners;
    group.cells->GetCellAtId(cell, corners);
    made->InsertNextCell(corners);
    ids->InsertNextId(group.first + cell);
  }
  for (vtkIdType cell = group.first + group.cells->GetNumberOfCells(); cell < allBefore; ++cell)
  {
    ids->InsertNextId(cell);
  }
  replace(data, group.cells, made);
  for (int i = 0; withArrays && i < data->GetCellData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetCellData()->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != allBefore)
    {
      continue; // another mutation came before
    }
    vtkSmartPointer<vtkAbstractArray> values;
    values.TakeReference(array->NewInstance());
    values->SetName(array->GetName());
    values->SetNumberOfComponents(array->GetNumberOfComponents());
    values->SetNumberOfTuples(ids->GetNumberOfIds());
    array->GetTuples(ids, values);
    data->GetCellData()->AddArray(values);
  }
}

std::string changeChoice(vtkPointSet* data, const Group& group, Random& random)
{
  const vtkIdType count = group.cells->GetNumberOfCells();
  std::vector<vtkIdType> chosen(static_cast<std::size_t>(count));
  std::iota(chosen.begin(), chosen.end(), 0);
  const vtkIdType place = random.below(count);
  const bool withArrays = !random.isTime(6);
  std::string what;
  switch (random.below(5))
  {
    case 0:
      chosen.erase(chosen.begin() + place);
      what = "cell " + std::to_string(place) + " is dropped";
      break;
    case 1:
      chosen.push_back(place);
      what = "cell " + std::to_string(place) + " is doubled";
      break;
    case 2:
      std::swap(chosen[static_cast<std::size_t>(place)],
        chosen[static_cast<std::size_t>(random.below(count))]);
      what = "two cells are swapped";
      break;
    case 3:
      chosen.resize(static_cast<std::size_t>(place));
      what = "all cells from " + std::to_string(place) + " are dropped";
      break;
    default:
      chosen.clear();
      what = "all cells are dropped";
  }
  choose(data, group, chosen, withArrays);
  return what + (withArrays ? " with their values" : " without their values");
}

std::string changeCorner(vtkPointSet* data, const Group& group, Random& random)
{
  vtkDataArray* corners = group.cells->GetConnectivityArray();
  const vtkIdType place = random.below(corners->GetNumberOfTuples());
  const double own = corners->GetComponent(place, 0);
  const auto points = static_cast<double>(data->GetNumberOfPoints());
  const std::vector<double> values = { -1, 0, own + 1, own - 1, points, points - 1, 2e9, -2e9,
    static_cast<double>(random.below(data->GetNumberOfPoints())),
    corners->GetComponent(random.below(corners->GetNumberOfTuples()), 0) };
  const double value = random.oneOf(values);
  corners->SetComponent(place, 0, value);
  return "corner " + std::to_string(place) + " becomes " + std::to_string(value);
}

std::string turnCell(const Group& group, Random& random)
{
  vtkNew<vtkIdList> corners;
  const vtkIdType cell = random.below(group.cells->GetNumberOfCells());
  group.cells->GetCellAtId(cell, corners);
  if (corners->GetNumberOfIds() > 1)
  {
    const vtkIdType first = corners->GetId(0);
    corners->SetId(0, corners->GetId(1));
    corners->SetId(1, first);
  }
  group.cells->ReplaceCellAtId(cell, corners);
  return "cell " + std::to_string(cell) + " is turned";
}

std::string changeOffset(const Group& group, Random& random)
{
  vtkDataArray* offsets = group.cells->GetOffsetsArray();
  const vtkIdType place = random.below(offsets->GetNumberOfTuples());
  const double own = offsets->GetComponent(place, 0);
  const std::vector<double> values = { own + 1, own - 1, 0, -1, 2 * own, 2e9 };
  const double value = random.oneOf(values);
  offsets->SetComponent(place, 0, value);
  return "offset " + std::to_string(place) + " becomes " + std::to_string(value);
}

std::string changeTypes(vtkPointSet* data, Random& random)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(data);
  if (!grid)
  {
    auto* surface = vtkPolyData::SafeDownCast(data);
    surface->SetStrips(surface->GetPolys());
    return "triangles are strips too";
  }
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  if (random.isTime(2) || types->GetNumberOfTuples() == 0)
  {
    types->Resize(types->GetNumberOfTuples() / 2);
    return "there are types for half of the cells";
  }
  const vtkIdType place = random.below(types->GetNumberOfTuples());
  const std::vector<unsigned char> others = { VTK_EMPTY_CELL, VTK_QUAD, VTK_VOXEL, VTK_POLYHEDRON,
    255 };
  types->SetValue(place, random.oneOf(others));
  return "type of cell " + std::to_string(place) + " becomes another one";
}
}

std::string mutateCells(vtkPointSet* data, Random& random)
{
  std::vector<Group> groups = groupsOf(data);
  groups.erase(
    std::remove_if(groups.begin(), groups.end(),
      [](const Group& group) { return !group.cells || group.cells->GetNumberOfCells() <= 0; }),
    groups.end());
  if (groups.empty() || data->GetNumberOfPoints() == 0)
  {
    return "nothing";
  }
  const Group group = random.oneOf(groups);
  switch (group.cells->IsValid() ? random.below(12) : 11)
  {
    case 0:
    case 1:
    case 2:
    case 3:
      return "cells: " + changeChoice(data, group, random);
    case 4:
    case 5:
      return "cells: " + turnCell(group, random);
    case 6:
      return "cells: " + changeOffset(group, random);
    case 7:
      return "cells: " + changeTypes(data, random);
  }
  return "cells: " + changeCorner(data, group, random);
}
}
