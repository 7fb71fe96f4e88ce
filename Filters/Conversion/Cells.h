// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Cells_h
#define Conversion_Cells_h

#include "Base/Errors.h"
#include "Conversion/Arrays.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <vector>

class vtkPointSet;

/// Points and cells, to and from VTK.
namespace medial
{
template <typename Values, typename Field = Itself>
vtkSmartPointer<vtkPoints> points(const Values& values, Field field = {})
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetData(tuples<vtkDoubleArray>("Points", 3, values, field));
  return result;
}

/// @param cells  a range of arrays or lists of points
template <typename Cells>
vtkSmartPointer<vtkCellArray> cellArray(const Cells& cells)
{
  const auto cellCount = static_cast<Index>(cells.size());
  vtkIdType cornerCount = 0;
  for (Index i = 0; i < cellCount; ++i)
  {
    cornerCount += static_cast<vtkIdType>(cells[i].size());
  }
  // In arrays of the very size, since a cell array that grows keeps up to twice the memory.
  vtkNew<vtkCellArray::ArrayType64> offsets, corners;
  offsets->SetNumberOfValues(cellCount + 1);
  corners->SetNumberOfValues(cornerCount);
  vtkIdType next = 0;
  for (Index i = 0; i < cellCount; ++i)
  {
    offsets->SetValue(i, next);
    for (const Index corner : cells[i])
    {
      corners->SetValue(next++, corner);
    }
  }
  offsets->SetValue(cellCount, next);
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->SetData(offsets, corners);
  return result;
}

/// A vertex for each of so many points, so that they can be drawn and picked.
vtkSmartPointer<vtkCellArray> vertexForEach(Index pointCount);

/// @throw InvalidInput  too many points
std::vector<Point> readPoints(vtkPointSet* input);

/// @throw InvalidInput  a coordinate that is not finite
/// @param remedy  what to do about it
std::vector<Point> readFinitePoints(vtkPointSet* input, const char* remedy);

/// The corners of one cell, checked: `Size` different points.
template <std::size_t Size>
std::array<Index, Size> readCell(
  vtkCellArray* cells, vtkIdType number, Index pointCount, const char* remedy)
{
  vtkIdType size = 0;
  const vtkIdType* corners = nullptr;
  cells->GetCellAtId(number, size, corners);
  if (size != static_cast<vtkIdType>(Size))
  {
    throw InvalidInput("a cell has ", size, " corners instead of ", Size, ": ", remedy);
  }
  std::array<Index, Size> result;
  for (std::size_t i = 0; i < Size; ++i)
  {
    if (corners[i] < 0 || corners[i] >= pointCount)
    {
      throw InvalidInput(
        "a cell has the corner ", corners[i], " but there are ", pointCount, " points: ", remedy);
    }
    result[i] = static_cast<Index>(corners[i]);
    if (std::find(result.begin(), result.begin() + i, result[i]) != result.begin() + i)
    {
      throw InvalidInput("a cell has the point ", result[i], " twice: ", remedy);
    }
  }
  return result;
}

template <std::size_t Size>
std::vector<std::array<Index, Size>> readCells(
  vtkCellArray* cells, Index pointCount, const char* remedy)
{
  std::vector<std::array<Index, Size>> result;
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return result;
  }
  if (!cells->IsValid())
  {
    throw InvalidInput("the offsets of the cells do not fit their corners: ", remedy);
  }
  result.reserve(toIndex(cells->GetNumberOfCells(), "cells"));
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    result.push_back(readCell<Size>(cells, i, pointCount, remedy));
  }
  return result;
}
}

#endif
