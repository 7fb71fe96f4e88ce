// SPDX-License-Identifier: BSD-3-Clause
#include "Pruning/PruneRun.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace medial
{
PruneRun::PruneRun(LivingCells& living, const PartMeasures& partMeasures,
  const PruneOptions& pruneOptions, const Execution& execution, PruneRecord begun)
  : options(pruneOptions)
  , rounds(living, partMeasures, pruneOptions, execution)
  , removability(living, this->rounds, pruneOptions)
  , ledger(living, partMeasures, pruneOptions, execution, std::move(begun))
{
}

void PruneRun::iterate(const PruneIteration& iteration)
{
  this->rounds.forgetInheritance();
  PruneRound round = this->rounds.next(iteration.measure);
  PruneRow row = this->ledger.newRow(round);
  row.measure = iteration.measure;
  row.threshold = iteration.threshold;
  for (bool changed = true; changed && (iteration.passes == 0 || row.passes < iteration.passes);
       ++row.passes)
  {
    // Hair goes first: a part doesn't collapse while hair hangs on it, as this would cut the hair off.
    changed = this->options.removeHair && this->pass(round, iteration, 1, row);
    if (changed)
    {
      round = this->rounds.next(iteration.measure);
    }
    if (this->pass(round, iteration, 2, row))
    {
      changed = true;
      round = this->rounds.next(iteration.measure);
    }
  }
  this->ledger.close(row, round);
}

/// One walk over the candidates of at most this dimension. @return  was anything removed?
bool PruneRun::pass(
  PruneRound& round, const PruneIteration& iteration, int dimension, PruneRow& row)
{
  const std::vector<Index> parts = candidates(round, iteration.threshold, dimension);
  const bool wantsBranches =
    this->options.removeBranches && this->options.topology == Topology::Collapse;
  const bool inherits = this->options.topology != Topology::None && iteration.passes != 1;
  bool changed = false;
  clearRefusals(row);
  for (const Index part : parts)
  {
    if (round.gone[part] || round.significance[part] > iteration.threshold)
    {
      continue; // it went with a branch, or took over the significance of removed parts
    }
    std::vector<Index> unit{ part };
    const std::optional<KeepReason> reason = this->removability.refusal(round, unit);
    if (reason)
    {
      unit = wantsBranches ? this->removability.branch(round, part, iteration.threshold)
                           : std::vector<Index>();
    }
    if (unit.empty() || (reason && this->removability.refusal(round, unit)))
    {
      countRefusal(*reason, row);
      continue;
    }
    this->remove(round, unit, row);
    if (inherits)
    {
      this->rounds.inherit(round, unit);
    }
    changed = true;
  }
  if (row.passes == 0)
  {
    row.candidates = std::max(row.candidates, count(parts));
  }
  return changed;
}

void PruneRun::remove(PruneRound& round, const std::vector<Index>& parts, PruneRow& row)
{
  const std::vector<Index> cells = cellsOf(round, parts);
  this->rounds.remove(round, parts, cells);
  this->ledger.enter(cells, round, row);
  row.removed += count(parts);
}
}
