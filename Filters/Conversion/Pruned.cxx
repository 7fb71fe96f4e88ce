// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Pruned.h"

#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Axis.h"
#include "Conversion/Cells.h"
#include "Conversion/Parts.h"
#include "Conversion/Remedies.h"
#include "Parts/PartRanks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <numeric>

namespace medial
{
namespace
{
/// Those of `cells`, numbered from `first`, that are among `chosen`, ascending.
vtkSmartPointer<vtkCellArray> chosenCells(
  vtkCellArray* cells, vtkIdType first, const std::vector<Index>& chosen)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  const auto begin = std::lower_bound(chosen.begin(), chosen.end(), first);
  const auto end = std::lower_bound(begin, chosen.end(), first + cells->GetNumberOfCells());
  result->AllocateEstimate(end - begin, cells->GetMaxCellSize());
  for (auto cell = begin; cell != end; ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(*cell - first, size, corners);
    result->InsertNextCell(size, corners);
  }
  return result;
}

/// All points of an axis and the `chosen` cells, ascending, with their arrays; for those that
/// `replaced` has too, these.
void copyCells(
  vtkPolyData* axis, const std::vector<Index>& chosen, vtkCellData* replaced, vtkPolyData* output)
{
  output->SetPoints(axis->GetPoints());
  output->GetPointData()->PassData(axis->GetPointData());
  const vtkIdType firstLine = axis->GetNumberOfVerts();
  const vtkIdType firstPoly = firstLine + axis->GetNumberOfLines();
  output->SetVerts(chosenCells(axis->GetVerts(), 0, chosen));
  output->SetLines(chosenCells(axis->GetLines(), firstLine, chosen));
  output->SetPolys(chosenCells(axis->GetPolys(), firstPoly, chosen));
  vtkNew<vtkCellData> others;
  others->ShallowCopy(axis->GetCellData());
  for (int i = 0; i < replaced->GetNumberOfArrays(); ++i)
  {
    others->RemoveArray(replaced->GetArrayName(i));
  }
  vtkCellData* cells = output->GetCellData();
  cells->CopyAllOn();
  cells->CopyAllocate(others, static_cast<vtkIdType>(chosen.size()));
  vtkNew<vtkIdList> from, to;
  from->SetNumberOfIds(static_cast<vtkIdType>(chosen.size()));
  to->SetNumberOfIds(static_cast<vtkIdType>(chosen.size()));
  std::copy(chosen.begin(), chosen.end(), from->begin());
  std::iota(to->begin(), to->end(), 0);
  cells->CopyData(others, from, to);
  cells->PassData(replaced);
}

void addHistory(vtkFieldData* rows, const std::vector<PruneRow>& history)
{
  std::vector<Index> numbers(history.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  add<vtkIdTypeArray>(rows, names::Iteration, numbers);
  std::vector<std::string> words;
  for (const PruneRow& row : history)
  {
    words.push_back(row.byHand ? "by hand" : shortWord({ row.measure, row.threshold, 0 }));
  }
  addTexts(rows, names::Word, words);
  add<vtkUnsignedCharArray>(rows, names::ByHand, history, &PruneRow::byHand);
  add<vtkIntArray>(rows, names::Measure, history, &PruneRow::measure);
  add<vtkDoubleArray>(rows, names::Threshold, history, &PruneRow::threshold);
  add<vtkIntArray>(rows, names::Passes, history, &PruneRow::passes);
  add<vtkIdTypeArray>(rows, names::PartsBefore, history, &PruneRow::partsBefore);
  add<vtkIdTypeArray>(rows, names::PartsAfter, history, &PruneRow::partsAfter);
  add<vtkIdTypeArray>(rows, names::Candidates, history, &PruneRow::candidates);
  add<vtkIdTypeArray>(rows, names::Removed, history, &PruneRow::removed);
  add<vtkIdTypeArray>(rows, names::Refused, history, &PruneRow::refused);
  add<vtkIdTypeArray>(rows, names::RefusedByTopology, history, &PruneRow::refusedByTopology);
  add<vtkIdTypeArray>(rows, names::RefusedIsolated, history, &PruneRow::refusedIsolated);
  add<vtkIdTypeArray>(rows, names::RefusedProtected, history, &PruneRow::refusedProtected);
  add<vtkIdTypeArray>(rows, names::TopologyChanges, history, &PruneRow::topologyChanges);
  rows->AddArray(tuples<vtkIdTypeArray>(
    names::Betti, 3, history, [](const PruneRow& row) { return row.betti; }));
  add<vtkDoubleArray>(rows, names::VolumeRemoved, history, &PruneRow::volumeRemoved);
}
}

void write(const Pruned& pruned, Topology topology, const std::vector<Index>& cellRanks,
  vtkPolyData* axis, vtkPolyData* output, vtkTable* history, vtkPolyData* removed)
{
  output->GetFieldData()->PassData(axis->GetFieldData());
  const bool keptBefore =
    Arrays(axis->GetFieldData(), "field", TakeMedialAxis).flag(names::TopologyKept);
  addOne<vtkUnsignedCharArray>(
    output->GetFieldData(), names::TopologyKept, keptBefore && topology == Topology::Collapse);
  vtkNew<vtkCellData> own;
  std::vector<Index> livingRanks;
  for (const Index cell : pruned.inputCell)
  {
    livingRanks.push_back(cellRanks[cell]);
  }
  addParts(own, output->GetFieldData(), pruned.parts, partRanks(pruned.parts, livingRanks));
  addTopology(output->GetFieldData(), pruned.axis);
  add<vtkUnsignedCharArray>(own, names::KeepReason, pruned.parts.partOfCell,
    [&](Index part) { return pruned.keepReason[part]; });
  add<vtkIdTypeArray>(own, names::InputCell, pruned.inputCell);
  copyCells(axis, pruned.inputCell, own, output);
  addHistory(history->GetRowData(), pruned.history);

  std::vector<Index> cells;
  for (Index cell = 0; cell < count(pruned.removedInIteration); ++cell)
  {
    if (pruned.removedInIteration[cell] != None)
    {
      cells.push_back(cell);
    }
  }
  vtkNew<vtkCellData> when;
  add<vtkIdTypeArray>(
    when, names::Iteration, cells, [&](Index cell) { return pruned.removedInIteration[cell]; });
  add<vtkIdTypeArray>(
    when, names::PartId, cells, [&](Index cell) { return pruned.removedPart[cell]; });
  add<vtkIdTypeArray>(when, names::PartRank, cells, [&](Index cell) { return cellRanks[cell]; });
  add<vtkIdTypeArray>(when, names::InputCell, cells);
  when->SetActiveScalars(names::PartRank);
  copyCells(axis, cells, when, removed);
}
}
