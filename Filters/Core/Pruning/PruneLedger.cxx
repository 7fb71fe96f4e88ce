// SPDX-License-Identifier: BSD-3-Clause
#include "Pruning/PruneLedger.h"

#include "Axis/AxisBetti.h"
#include "Parts/BettiNumbers.h"

#include "Parts/BallShares.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{
/// The cells whose entry is, or is not, None.
std::vector<Index> cellsWhere(const PruneRecord& record, bool isRemoved)
{
  std::vector<Index> result;
  for (Index cell = 0; cell < count(record.removedInIteration); ++cell)
  {
    if ((record.removedInIteration[cell] != None) == isRemoved)
    {
      result.push_back(cell);
    }
  }
  return result;
}
}

Index sharedIterations(const PruneOptions& earlier, const PruneOptions& options)
{
  const auto rules = [](const PruneOptions& o) {
    return std::tie(o.topology, o.removeHair, o.removeBranches, o.neckRatio, o.cellsToProtect);
  };
  const auto isMadeAnew = [](const PruneOptions& o) { return o.automatic || o.verifyTopology; };
  if (isMadeAnew(earlier) || isMadeAnew(options) || rules(earlier) != rules(options))
  {
    return 0;
  }
  const auto end = std::mismatch(earlier.schedule.begin(), earlier.schedule.end(),
    options.schedule.begin(), options.schedule.end());
  const auto shared = static_cast<Index>(end.first - earlier.schedule.begin());
  return std::min(shared, std::max(count(options.schedule) - 1, 0));
}

PruneRecord firstRows(const PruneRecord& earlier, Index rows, Index cellCount)
{
  PruneRecord result;
  result.removedInIteration.assign(cellCount, None);
  result.removedPart.assign(cellCount, None);
  for (Index cell = 0; rows > 0 && cell < cellCount; ++cell)
  {
    const Index row = earlier.removedInIteration[cell];
    if (row != None && row < rows)
    {
      result.removedInIteration[cell] = row;
      result.removedPart[cell] = earlier.removedPart[cell];
    }
  }
  result.history.assign(earlier.history.begin(), earlier.history.begin() + rows);
  return result;
}

std::vector<Index> removedCells(const PruneRecord& record)
{
  return cellsWhere(record, true);
}

std::vector<Index> livingCells(const PruneRecord& record)
{
  return cellsWhere(record, false);
}

void countRefusal(KeepReason reason, PruneRow& row)
{
  ++row.refused;
  row.refusedByTopology += reason == KeepReason::Topology;
  row.refusedIsolated += reason == KeepReason::Isolated;
  row.refusedProtected += reason == KeepReason::Protected;
}

void clearRefusals(PruneRow& row)
{
  row.refused = row.refusedByTopology = row.refusedIsolated = row.refusedProtected = 0;
}

PruneLedger::PruneLedger(const LivingCells& livingCells, const PartMeasures& partMeasures,
  const PruneOptions& pruneOptions, const Execution& ledgerExecution, PruneRecord begun)
  : living(livingCells)
  , measures(partMeasures)
  , options(pruneOptions)
  , execution(ledgerExecution)
  , entries(std::move(begun))
  , volume(this->livingVolume())
{
  if (this->options.verifyTopology)
  {
    this->verified = bettiNumbers(this->living.cells);
  }
}

PruneRow PruneLedger::newRow(const PruneRound& round) const
{
  PruneRow row{};
  row.partsBefore = count(round.partition->dimension);
  row.topologyChanges = this->options.verifyTopology ? 0 : None;
  return row;
}

void PruneLedger::enter(const std::vector<Index>& cells, const PruneRound& round, PruneRow& row)
{
  for (const Index cell : cells)
  {
    this->entries.removedInIteration[cell] = count(this->entries.history);
    this->entries.removedPart[cell] = round.partition->partOfCell[cell];
  }
  if (this->options.verifyTopology)
  {
    this->verify(row);
  }
}

void PruneLedger::verify(PruneRow& row)
{
  // From the cells alone: neither the partition nor what LivingCells counts is trusted.
  const Betti now =
    bettiNumbers(withCells(this->measures.axis, livingCells(this->entries), {}).cells);
  if (now != this->verified && this->options.topology == Topology::Collapse)
  {
    throw std::logic_error("the removal of a part changed the Betti numbers though the topology is "
                           "to be kept: a bug of the pruning, please report it with the input");
  }
  row.topologyChanges += now != this->verified;
  this->verified = now;
}

void PruneLedger::close(PruneRow row, const PruneRound& round)
{
  row.partsAfter = count(round.partition->dimension);
  const double before = this->volume;
  this->volume = this->livingVolume();
  row.volumeRemoved = before - this->volume;
  row.betti = row.removed == 0 && !this->entries.history.empty()
    ? this->entries.history.back().betti
    : bettiNumbers(this->living, *round.partition, this->execution);
  this->entries.history.push_back(row);
}

/// Of the balls that are, or whose owner is, at a point with living cells.
double PruneLedger::livingVolume() const
{
  const std::vector<char> kept = keptBalls(this->measures.axis, this->living);
  double sum = 0;
  for (std::size_t b = 0; b < kept.size(); ++b)
  {
    sum += kept[b] ? this->measures.axis.ballVolumes[b] : 0;
  }
  return this->measures.solidVolume > 0 ? sum / this->measures.solidVolume : 0;
}
}
