// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/PlatesAndRods.h"

#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Cells.h"
#include "Conversion/Remedies.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <numeric>

namespace medial
{
namespace
{
int classOf(const PlatesAndRods& found, Index element)
{
  return element == None ? 0 : found.elements[element].isPlate ? 1 : 2;
}

void addElements(vtkFieldData* data, const PlatesAndRods& found, const std::vector<Index>& elements)
{
  add<vtkUnsignedCharArray>(
    data, names::PlateOrRod, elements, [&found](Index element) { return classOf(found, element); });
  add<vtkIdTypeArray>(data, names::ElementId, elements);
}

void addCounts(vtkFieldData* field, const PlatesAndRods& found)
{
  Index plates = 0;
  double plateVolume = 0, rodVolume = 0;
  for (const Element& element : found.elements)
  {
    plates += element.isPlate;
    (element.isPlate ? plateVolume : rodVolume) += element.volume;
  }
  addOne<vtkIdTypeArray>(field, names::NumberOfPlates, plates);
  addOne<vtkIdTypeArray>(field, names::NumberOfRods, count(found.elements) - plates);
  addOne<vtkDoubleArray>(field, names::PlateVolume, plateVolume);
  addOne<vtkDoubleArray>(field, names::RodVolume, rodVolume);
  addOne<vtkIdTypeArray>(field, names::PlatePlateJunctions, found.plateJunctions);
  addOne<vtkIdTypeArray>(field, names::PlateRodJunctions, found.mixedJunctions);
  addOne<vtkIdTypeArray>(field, names::RodRodJunctions, found.rodJunctions);
}

void addTable(vtkTable* table, const PlatesAndRods& found)
{
  vtkFieldData* rows = table->GetRowData();
  const std::vector<Element>& elements = found.elements;
  std::vector<Index> numbers(elements.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  add<vtkIdTypeArray>(rows, names::ElementId, numbers);
  add<vtkUnsignedCharArray>(
    rows, names::PlateOrRod, numbers, [&found](Index i) { return classOf(found, i); });
  add<vtkDoubleArray>(rows, names::Volume, elements, &Element::volume);
  add<vtkDoubleArray>(rows, names::Area, elements, &Element::area);
  add<vtkDoubleArray>(rows, names::Length, elements, &Element::length);
  add<vtkDoubleArray>(rows, names::MeanThickness, elements, &Element::meanThickness);
  add<vtkDoubleArray>(rows, names::MinimumThickness, elements, &Element::leastThickness);
  add<vtkDoubleArray>(rows, names::MaximumThickness, elements, &Element::largestThickness);
  rows->AddArray(tuples<vtkDoubleArray>(
    names::Centroid, 3, elements, [](const Element& element) { return element.centroid; }));
  rows->AddArray(tuples<vtkDoubleArray>(
    names::Direction, 3, elements, [](const Element& element) { return element.direction; }));
  add<vtkIdTypeArray>(
    rows, names::Neighbors, numbers, [&found](Index i) { return found.neighbors[i].size(); });
  vtkFieldData* field = table->GetFieldData();
  add<vtkIdTypeArray>(field, names::NeighborOffsets, found.neighbors.offsets);
  add<vtkIdTypeArray>(field, names::NeighborElements, found.neighbors.items);
  addCounts(field, found);
}

/// For each ball the point of the axis that it follows, or None.
std::vector<Index> pointOfBall(const MedialAxis& axis)
{
  std::vector<Index> result(axis.ballOwner.size(), None);
  for (Index p = count(axis.points) - 1; p >= 0; --p)
  {
    if (axis.ballOfPoint[p] != None)
    {
      result[axis.ballOfPoint[p]] = p;
    }
  }
  for (Index ball = 0; ball < count(result); ++ball)
  {
    const Index owner = axis.ballOwner[ball];
    result[ball] = owner == None ? None : result[owner];
  }
  return result;
}
}

void write(const PlatesAndRods& found, vtkPolyData* axis, vtkPolyData* output, vtkTable* table)
{
  output->ShallowCopy(axis);
  vtkPointData* points = output->GetPointData();
  add<vtkDoubleArray>(points, names::SheetWidth, found.widths.width);
  add<vtkDoubleArray>(points, names::Thickness, found.widths.thickness);
  add<vtkDoubleArray>(points, names::WidthRatio, found.widths.ratio);
  addElements(points, found, found.elementOfPoint);
  addElements(output->GetCellData(), found, found.elementOfCell);
  output->GetCellData()->SetActiveScalars(names::PlateOrRod);
  addCounts(output->GetFieldData(), found);
  addTable(table, found);
}

void write(
  const PlatesAndRods& found, const MedialAxis& axis, vtkPolyData* surface, vtkPolyData* output)
{
  const Arrays arrays(surface->GetCellData(), "cell", TakePowerCrust);
  const Index cellCount = toIndex(surface->GetNumberOfCells(), "cells");
  arrays.checkLengths(cellCount);
  const std::vector<Index> points = pointOfBall(axis);
  std::vector<Index> followed, elements;
  for (const Index ball : arrays.indices(names::InnerBall, cellCount, 0, count(points)))
  {
    followed.push_back(points[ball]);
    elements.push_back(points[ball] == None ? None : found.elementOfPoint[points[ball]]);
  }
  output->ShallowCopy(surface);
  addElements(output->GetCellData(), found, elements);
  add<vtkDoubleArray>(output->GetCellData(), names::Thickness, followed,
    [&found](Index p) { return p == None ? 0 : found.widths.thickness[p]; });
  output->GetCellData()->SetActiveScalars(names::PlateOrRod);
}
}
