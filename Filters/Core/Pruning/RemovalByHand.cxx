// SPDX-License-Identifier: BSD-3-Clause
#include "Pruning/RemovalByHand.h"

#include "Base/Lists.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace medial
{
namespace
{
/// The parts of the cells that live, ascending.
std::vector<Index> partsOfCells(const std::vector<Index>& cells, const PruneRound& round)
{
  std::vector<Index> parts;
  for (const Index cell : cells)
  {
    const Index part = round.partition->partOfCell[cell];
    if (part != None)
    {
      parts.push_back(part);
    }
  }
  sortUnique(parts);
  return parts;
}

/// Removes the parts that may go, each as soon as it may; those that are left, together if they may.
void removeAllowed(std::vector<Index> parts, PruneRun& run, PruneRound& round, PruneRow& row)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const Index part : parts)
    {
      if (!run.removability.refusal(round, { part }))
      {
        run.remove(round, { part }, row);
        changed = true;
      }
    }
    const auto isSettled = [&round](
                             Index part) { return round.gone[part] || round.isProtected[part]; };
    parts.erase(std::remove_if(parts.begin(), parts.end(), isSettled), parts.end());
  }
  if (parts.size() > 1 && !run.removability.refusal(round, parts))
  {
    run.remove(round, parts, row);
  }
}

CellFate fateOf(KeepReason refusal)
{
  return refusal == KeepReason::Topology ? CellFate::Topology
    : refusal == KeepReason::Isolated    ? CellFate::Isolated
                                         : CellFate::Protected;
}

/// For each part of the round what became of it; also counts the refusals. Parts that were not named
/// have no fate: Removed stands there.
std::vector<CellFate> fatesOfParts(
  const std::vector<Index>& named, PruneRun& run, const PruneRound& round, PruneRow& row)
{
  std::vector<CellFate> result(round.gone.size(), CellFate::Removed);
  for (const Index part : named)
  {
    if (!round.gone[part])
    {
      const KeepReason reason = *run.removability.refusal(round, { part });
      countRefusal(reason, row);
      result[part] = fateOf(reason);
    }
  }
  return result;
}
}

std::vector<CellFate> removeByHand(PruneRun& run)
{
  run.rounds.forgetInheritance();
  PruneRound round = run.rounds.next(Measure::TriangleCount);
  PruneRow row = run.ledger.newRow(round);
  row.byHand = true;
  const std::vector<Index> named = partsOfCells(run.options.cellsToRemove, round);
  row.candidates = count(named);
  row.passes = 1;
  removeAllowed(named, run, round, row);
  const std::vector<CellFate> fateOfPart = fatesOfParts(named, run, round, row);
  run.ledger.close(row, run.rounds.next(Measure::TriangleCount));
  std::vector<CellFate> fates;
  for (const Index cell : run.options.cellsToRemove)
  {
    const Index part = round.partition->partOfCell[cell];
    fates.push_back(part == None ? CellFate::AlreadyGone : fateOfPart[part]);
  }
  return fates;
}

std::string refusals(const std::vector<CellFate>& fates, const std::vector<Index>& cellsToRemove,
  const std::vector<Index>& partOfCell)
{
  std::map<CellFate, std::set<Index>> kept; // by part or cell, each once
  for (std::size_t i = 0; i < fates.size(); ++i)
  {
    const Index cell = cellsToRemove[i];
    kept[fates[i]].insert(partOfCell.empty() ? cell : partOfCell[cell]);
  }
  const auto listed = [&](CellFate fate, const char* reason) {
    std::ostringstream text;
    for (const Index number : kept[fate])
    {
      text << (text.str().empty() ? "" : ", ") << number;
    }
    const char* what = partOfCell.empty() ? "cells " : "parts ";
    return kept[fate].empty() ? std::string() : "; " + (what + text.str()) + ": " + reason;
  };
  const std::string text = listed(CellFate::Topology, "needed for the topology") +
    listed(CellFate::Isolated, "a whole piece of the axis") +
    listed(CellFate::Protected, "protected") +
    listed(CellFate::AlreadyGone, "already gone with the schedule");
  return text.empty() ? text : "not removed by hand" + text;
}
}
