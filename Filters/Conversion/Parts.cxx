// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Parts.h"

#include "Base/Errors.h"
#include "Base/Lists.h"
#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Cells.h"
#include "Conversion/Remedies.h"
#include "Parts/PartRanks.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <numeric>
#include <set>

namespace medial
{
namespace
{
/// Adds the values of a measure; field(entry) is the part of an entry. Counts are whole numbers.
template <typename Entries, typename Field>
void addMeasure(vtkFieldData* data, const char* name, const MeasureTraits& traits,
  const MedialParts& parts, const Entries& entries, Field part)
{
  const auto value = [&](const auto& entry) { return parts.value(traits.measure, part(entry)); };
  if (traits.unit == Unit::Count)
  {
    add<vtkIdTypeArray>(data, name, entries, value);
  }
  else
  {
    add<vtkDoubleArray>(data, name, entries, value);
  }
}

void addPartTable(
  vtkFieldData* rows, const MedialParts& medialParts, const std::vector<Index>& ranks)
{
  const std::vector<MedialPart>& parts = medialParts.parts;
  std::vector<Index> numbers(parts.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  add<vtkIdTypeArray>(rows, names::PartId, numbers);
  add<vtkIdTypeArray>(rows, names::PartRank, ranks);
  add<vtkIntArray>(rows, names::Dimension, parts, &MedialPart::dimension);
  add<vtkIntArray>(rows, names::Level, parts, &MedialPart::level);
  for (const MeasureTraits& traits : allMeasures())
  {
    addMeasure(rows, traits.name, traits, medialParts, numbers, Itself());
  }
  add<vtkDoubleArray>(rows, names::Volume, parts, &MedialPart::volume);
  add<vtkDoubleArray>(rows, names::MinimumRadius, parts, &MedialPart::minimumRadius);
  add<vtkIdTypeArray>(rows, names::Contacts, parts, &MedialPart::contacts);
  add<vtkIdTypeArray>(rows, names::Neighbors, parts, &MedialPart::neighbors);
  add<vtkDoubleArray>(rows, names::NeckRatio, parts, &MedialPart::neckRatio);
  add<vtkUnsignedCharArray>(rows, names::OnLoop, parts, &MedialPart::onLoop);
  rows->AddArray(tuples<vtkDoubleArray>(names::Bounds, 6, parts, [](const MedialPart& part) {
    const Point &from = part.lower, &to = part.upper;
    return std::array{ from.x(), to.x(), from.y(), to.y(), from.z(), to.z() };
  }));
  rows->AddArray(tuples<vtkDoubleArray>(
    names::Centroid, 3, parts, [](const MedialPart& part) { return part.centroid; }));
  rows->AddArray(tuples<vtkDoubleArray>(names::PrincipalLengths, 3, parts,
    [](const MedialPart& part) { return part.principalLengths; }));
}

/// A vertex for each contact of one point, a polyline for each other, with its number.
void addContacts(const std::vector<ContactCurve>& contacts, vtkPolyData* output)
{
  std::vector<std::vector<Index>> vertices, lines;
  std::vector<Index> numbers, lineNumbers;
  IndexLists parts;
  for (Index i = 0; i < count(contacts); ++i)
  {
    const ContactCurve& curve = contacts[i];
    const bool isPoint = curve.points.size() == 1;
    (isPoint ? vertices : lines).push_back(curve.points);
    (isPoint ? numbers : lineNumbers).push_back(i);
    parts.items.insert(parts.items.end(), curve.parts.begin(), curve.parts.end());
    parts.close();
  }
  numbers.insert(numbers.end(), lineNumbers.begin(), lineNumbers.end());
  output->SetVerts(cellArray(vertices));
  output->SetLines(cellArray(lines));
  add<vtkIdTypeArray>(output->GetCellData(), names::ContactId, numbers);
  add<vtkIdTypeArray>(output->GetFieldData(), names::ContactPartOffsets, parts.offsets);
  add<vtkIdTypeArray>(output->GetFieldData(), names::ContactParts, parts.items);
}
}

void addParts(vtkCellData* cells, vtkFieldData* field, const MedialParts& parts,
  const std::vector<Index>& ranks)
{
  const std::vector<Index>& partOfCell = parts.partOfCell;
  add<vtkIdTypeArray>(cells, names::PartId, partOfCell);
  add<vtkIdTypeArray>(cells, names::PartRank, partOfCell, [&](Index part) { return ranks[part]; });
  cells->SetActiveScalars(names::PartRank);
  add<vtkIntArray>(
    cells, names::PartLevel, partOfCell, [&](Index part) { return parts.parts[part].level; });
  const auto suggested = tuples<vtkDoubleArray>(names::SuggestedThreshold,
    static_cast<int>(allMeasures().size()), std::array{ parts.suggestedThresholds });
  for (const MeasureTraits& traits : allMeasures())
  {
    addMeasure(cells, traits.cellArray, traits, parts, partOfCell, Itself());
    suggested->SetComponentName(static_cast<int>(traits.measure), traits.name);
  }
  addOne<vtkIdTypeArray>(field, names::NumberOfParts, count(parts.parts));
  field->AddArray(suggested);
}

void write(const MedialParts& parts, vtkPolyData* axis, vtkPolyData* output, vtkTable* table,
  vtkPolyData* contacts)
{
  const std::vector<Index> ranks = partRanks(parts, readRanks(axis));
  output->ShallowCopy(axis);
  addParts(output->GetCellData(), output->GetFieldData(), parts, ranks);
  addPartTable(table->GetRowData(), parts, ranks);
  contacts->SetPoints(axis->GetPoints());
  contacts->GetPointData()->PassData(axis->GetPointData());
  addContacts(parts.contacts, contacts);
}

void write(const TopologyGraph& graph, const MedialParts& parts, vtkPolyData* output)
{
  const Index nodeCount = graph.partsOfNode.size(), partCount = graph.nodesOfPart.size();
  std::vector<Point> places = graph.nodeCentroids;
  std::vector<Index> node, part, degree;
  std::vector<Edge> lines;
  for (Index i = 0; i < nodeCount; ++i)
  {
    node.push_back(i);
    part.push_back(None);
    degree.push_back(graph.partsOfNode[i].size());
  }
  for (Index i = 0; i < partCount; ++i)
  {
    places.push_back(parts.parts[i].centroid);
    node.push_back(None);
    part.push_back(i);
    degree.push_back(graph.nodesOfPart[i].size());
    for (const Index other : graph.nodesOfPart[i])
    {
      lines.push_back({ nodeCount + i, other });
    }
  }
  output->SetPoints(points(places));
  output->SetVerts(vertexForEach(nodeCount + partCount));
  output->SetLines(cellArray(lines));
  std::vector<char> onLoop = graph.nodeOnLoop;
  onLoop.insert(onLoop.end(), graph.partOnLoop.begin(), graph.partOnLoop.end());
  add<vtkIdTypeArray>(output->GetPointData(), names::NodeId, node);
  add<vtkIdTypeArray>(output->GetPointData(), names::PartId, part);
  add<vtkIdTypeArray>(output->GetPointData(), names::Degree, degree);
  add<vtkUnsignedCharArray>(output->GetPointData(), names::OnLoop, onLoop);
  for (const Edge& line : lines)
  {
    node.push_back(line[1]);
    part.push_back(line[0] - nodeCount);
  }
  add<vtkIdTypeArray>(output->GetCellData(), names::NodeId, node);
  add<vtkIdTypeArray>(output->GetCellData(), names::PartId, part);
}

std::vector<Index> readParts(vtkPolyData* axis)
{
  const Arrays cells(axis->GetCellData(), "cell", TakeParts);
  const Index cellCount = toIndex(axis->GetNumberOfCells(), "cells");
  if (!cells.has(names::PartId))
  {
    return {};
  }
  const Arrays field(axis->GetFieldData(), "field", TakeParts);
  const Index end = field.indices(names::NumberOfParts, 1, 0, cellCount + 1).front();
  return cells.indices(names::PartId, cellCount, 0, end);
}

std::vector<Index> readRanks(vtkPolyData* axis)
{
  const Arrays cells(axis->GetCellData(), "cell", TakeParts);
  return cells.has(names::PartRank)
    ? cells.indices(names::PartRank, axis->GetNumberOfCells(), 0, Largest)
    : std::vector<Index>{};
}

std::vector<Index> readCells(vtkPolyData* axis, const std::vector<vtkIdType>& parts,
  const std::vector<vtkIdType>& cells, const char* done)
{
  const vtkIdType cellCount = axis->GetNumberOfCells();
  std::vector<Index> result;
  for (const vtkIdType cell : cells)
  {
    if (cell < 0 || cell >= cellCount)
    {
      throw InvalidInput(
        "cell ", cell, " can't be ", done, ": the input has the cells 0 ... ", cellCount - 1);
    }
    result.push_back(static_cast<Index>(cell));
  }
  if (parts.empty())
  {
    return result;
  }
  const std::vector<Index> partOfCell = readParts(axis);
  if (partOfCell.empty())
  {
    throw InvalidInput(
      "parts can't be ", done, " without the cell array '", names::PartId, "': ", TakeParts);
  }
  std::set<vtkIdType> missing(parts.begin(), parts.end());
  const std::set<vtkIdType> chosen = missing;
  for (Index cell = 0; cell < count(partOfCell); ++cell)
  {
    if (chosen.count(partOfCell[cell]))
    {
      missing.erase(partOfCell[cell]);
      result.push_back(cell);
    }
  }
  if (!missing.empty())
  {
    throw InvalidInput("part ", *missing.begin(), " can't be ", done, ": the cell array '",
      names::PartId, "' of the input has no such part");
  }
  return result;
}
}
