// SPDX-License-Identifier: BSD-3-Clause
#include "Pruning/Pruning.h"

#include "Axis/AxisBetti.h"
#include "Axis/AxisEdges.h"
#include "Base/Errors.h"
#include "Base/Lists.h"
#include "Parts/BallShares.h"
#include "Parts/BettiNumbers.h"
#include "Parts/LivingCells.h"
#include "Parts/Necks.h"
#include "Parts/Partition.h"
#include "Parts/Thresholds.h"
#include "Pruning/PruneLedger.h"
#include "Pruning/PruneRound.h"
#include "Pruning/PruneRun.h"
#include "Pruning/RemovalByHand.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace medial
{
namespace
{
void requireValid(const MedialAxis& axis, const PruneOptions& options)
{
  for (std::size_t i = 0; i < options.schedule.size(); ++i)
  {
    const std::string fault = faultOf(options.schedule[i]);
    if (!fault.empty())
    {
      throw InvalidInput("iteration ", i + 1, " of the pruning schedule can't be made: ", fault,
        "; give thresholds of 0 and more (volumes: 0 ... 1)");
    }
  }
  if (!(options.neckRatio >= 0 && options.neckRatio <= 1))
  {
    throw InvalidInput("the neck ratio is a share of a radius; give a number from 0 to 1");
  }
  const auto requireThere = [&axis](const std::vector<Index>& cells, const char* what) {
    for (const Index cell : cells)
    {
      if (cell < 0 || cell >= axis.cells.size())
      {
        throw InvalidInput("cell ", cell, " is to be ", what, ", but the axis has only ",
          axis.cells.size(), " cells; ids are those of the input");
      }
    }
  };
  requireThere(options.cellsToRemove, "removed");
  requireThere(options.cellsToProtect, "protected");
}

/// The options with all thresholds in the samples' unit.
PruneOptions inUnits(PruneOptions options, const MedialAxis& axis)
{
  for (PruneIteration& iteration : options.schedule)
  {
    if (iteration.lengthUnit == LengthUnit::Samples)
    {
      continue;
    }
    const bool isOfDiagonal = iteration.lengthUnit == LengthUnit::Diagonal;
    const double unit = isOfDiagonal ? axis.sampleDiagonal : axis.sampleSpacing;
    if (!(unit > 0))
    {
      throw InvalidInput("the axis doesn't know the ",
        isOfDiagonal ? "diagonal of the samples' bounding box" : "spacing of the samples",
        ", in which '", scheduleWords({ iteration }),
        "' is counted: take the output of vtkMedialAxis, or give the threshold as a length");
    }
    iteration.threshold *= traitsOf(iteration.measure).unit == Unit::Area ? unit * unit : unit;
    iteration.lengthUnit = LengthUnit::Samples;
  }
  return options;
}

/// Progress is that of the iterations; the decomposition at the end takes the last tenth.
void reportIterations(const Execution& execution, const PruneRun& run, std::size_t total)
{
  execution.report(
    0.9 * static_cast<double>(run.ledger.record().history.size()) / static_cast<double>(total));
}

void runSchedule(PruneRun& run, const Execution& execution)
{
  const std::vector<PruneIteration>& schedule = run.options.schedule;
  const std::vector<PruneRow>& history = run.ledger.record().history;
  while (history.size() < schedule.size())
  {
    reportIterations(execution, run, schedule.size());
    run.iterate(schedule[history.size()]);
  }
}

/// Did the last iteration remove at least a tenth of the parts?
bool hasDropped(const PruneRun& run)
{
  const PruneRow& row = run.ledger.record().history.back();
  return 10 * (row.partsBefore - row.partsAfter) >= row.partsBefore;
}

/// The relative volume up to which parts may go now; 0: none.
double suggestedVolume(PruneRun& run)
{
  PruneRounds::Inheritance forgotten = run.rounds.forgetInheritance();
  const PruneRound round = run.rounds.next(Measure::RelativeVolume);
  run.rounds.remember(std::move(forgotten));
  std::vector<RankedPart> parts;
  for (Index part = 0; part < count(round.significance); ++part)
  {
    if (round.partition->level[part] == 1)
    {
      parts.push_back({ round.significance[part], round.significance[part] });
    }
  }
  double budget = removableVolume;
  for (const PruneRow& row : run.ledger.record().history)
  {
    budget -= row.volumeRemoved;
  }
  return suggestedThreshold(std::move(parts), budget);
}

/// See PruneOptions::automatic.
void runAutomatically(PruneRun& run, const Execution& execution)
{
  const auto report = [&] {
    constexpr std::size_t usual = 5; // iterations: nobody knows yet how many there will be
    reportIterations(execution, run, std::max(usual, run.ledger.record().history.size() + 1));
  };
  do
  {
    report();
    run.iterate({ Measure::TriangleCount, 5, 0 });
  }
  while (hasDropped(run));
  for (bool goesOn = true; goesOn;)
  {
    report();
    const double threshold = suggestedVolume(run);
    goesOn = threshold > 0;
    if (goesOn)
    {
      run.iterate({ Measure::RelativeVolume, threshold, 0 });
      goesOn = hasDropped(run);
    }
  }
}

/// The last iteration of the history, before any removal by hand.
std::optional<PruneIteration> lastIteration(const PruneRecord& record)
{
  if (record.history.empty())
  {
    return std::nullopt;
  }
  const PruneRow& row = record.history.back();
  return PruneIteration{ row.measure, row.threshold, row.passes };
}

/// For each part: does it touch no other?
std::vector<char> wholePieces(const LivingCells& living, const Partition& partition)
{
  std::vector<char> result(partition.dimension.size(), 1);
  forTouchingParts(living, partition, [&](Index a, Index b) { result[a] = result[b] = 0; });
  return result;
}

/// For each part why the last iteration left it.
std::vector<KeepReason> keepReasons(
  const LivingCells& living, const PruneRound& round, const std::optional<PruneIteration>& last)
{
  const std::vector<char> isWhole = wholePieces(living, *round.partition);
  std::vector<KeepReason> result;
  for (Index part = 0; part < count(round.significance); ++part)
  {
    KeepReason reason = KeepReason::Topology;
    if (round.isProtected[part])
    {
      reason = KeepReason::Protected;
    }
    else if (isWhole[part])
    {
      reason = KeepReason::Isolated;
    }
    else if (round.partition->level[part] != 1)
    {
      reason = KeepReason::InnerLevel;
    }
    else if (!last || round.significance[part] > last->threshold)
    {
      reason = KeepReason::AboveThreshold;
    }
    result.push_back(reason);
  }
  return result;
}

/// Parts that were to be removed by hand are kept for the topology, whatever their significance.
void explainFates(const std::vector<Index>& cellsToRemove, const PruneRound& round, Pruned& result)
{
  for (std::size_t i = 0; i < result.fates.size(); ++i)
  {
    if (result.fates[i] == CellFate::Topology)
    {
      const Index part = round.partition->partOfCell[cellsToRemove[i]];
      result.keepReason[part] = KeepReason::Topology;
    }
  }
}

/// Prunes the living cells, which are those after the rows of `begun`.
Pruned pruned(const PrunableAxis& input, LivingCells& living, const Bodies& bodies,
  PruneRecord begun, const PruneOptions& options, const Execution& execution)
{
  PruneRun run(living, input.measures, options, execution, std::move(begun));
  options.automatic ? runAutomatically(run, execution) : runSchedule(run, execution);
  const std::optional<PruneIteration> last = lastIteration(run.ledger.record());
  Pruned result;
  if (!options.cellsToRemove.empty())
  {
    result.fates = removeByHand(run);
  }
  execution.report(0.9);
  const PruneRound round = run.rounds.next(last ? last->measure : Measure::TriangleCount);
  run.rounds.findAllLevels();
  result.parts =
    decompose(living, *round.partition, input.measures, execution.between(0.9, 1), bodies);
  std::vector<Index>& partOfCell = result.parts.partOfCell;
  partOfCell.erase(std::remove(partOfCell.begin(), partOfCell.end(), None), partOfCell.end());
  result.keepReason = keepReasons(living, round, last);
  explainFates(options.cellsToRemove, round, result);
  static_cast<PruneRecord&>(result) = run.ledger.takeRecord();
  const Betti betti = result.history.empty() ? bettiNumbers(living, *round.partition, execution)
                                             : result.history.back().betti;
  result.inputCell = livingCells(result);
  result.axis = withCells(input.axis, result.inputCell, betti);
  return result;
}
}

PrunableAxis::PrunableAxis(MedialAxis medialAxis)
  : axis(std::move(medialAxis))
  , edges(axisEdges(this->axis.cells))
  , living(this->axis.cells, this->edges)
  , measures(this->axis, this->living)
{
}

Pruned prune(PrunableAxis& input, const PruneOptions& requestedOptions, const Execution& execution)
{
  requireValid(input.axis, requestedOptions);
  const PruneOptions options = inUnits(requestedOptions, input.axis);
  const Bodies limbs =
    options.neckRatio > 0 ? bodies(input.axis, input.edges, options.neckRatio) : Bodies{};
  LivingCells living =
    limbs.ofCell.empty() ? input.living : LivingCells(input.axis.cells, input.edges, limbs.ofCell);
  PruneRecord begun = firstRows(
    input.lastRecord, sharedIterations(input.lastOptions, options), input.axis.cells.size());
  living.remove(removedCells(begun));
  Pruned result = pruned(input, living, limbs, std::move(begun), options, execution);
  input.lastOptions = options;
  input.lastRecord = result;
  execution.report(1);
  return result;
}

Pruned prune(const MedialAxis& axis, const PruneOptions& options, const Execution& execution)
{
  PrunableAxis prunable(axis);
  return prune(prunable, options, execution);
}
}
