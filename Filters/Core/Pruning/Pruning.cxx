// SPDX-License-Identifier: BSD-3-Clause
#include "Pruning/Pruning.h"

#include "Axis/AxisBetti.h"
#include "Axis/AxisEdges.h"
#include "Base/Lists.h"
#include "Parts/BallShares.h"
#include "Parts/BettiNumbers.h"
#include "Parts/LivingCells.h"
#include "Parts/Partition.h"
#include "Parts/Thresholds.h"
#include "Parts/TopologyGraph.h"
#include "Pruning/PartCollapse.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_map>

namespace medial
{
namespace
{
using Effect = PartCollapse::Effect;

void requireValid(const MedialAxis& axis, const PruneOptions& options)
{
  for (const PruneIteration& iteration : options.schedule)
  {
    if (!(iteration.threshold >= 0) || iteration.passes < 0)
    {
      throw InvalidInput("a threshold or a number of passes of the pruning schedule is negative or "
                         "not a number; give thresholds of 0 and more (volumes: 0 ... 1)");
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
/// @param diagonal  of the samples' bounding box; 0: not known
PruneOptions inUnits(PruneOptions options, double diagonal)
{
  for (PruneIteration& iteration : options.schedule)
  {
    if (iteration.ofDiagonal && !(diagonal > 0))
    {
      throw InvalidInput(
        "the axis doesn't know the diagonal of the samples' bounding box, of which '",
        scheduleWords({ iteration }),
        "' is a share: take the output of vtkMedialAxis, or give the ", "threshold as a length");
    }
    iteration.threshold *= iteration.ofDiagonal ? diagonal : 1;
    iteration.ofDiagonal = false;
  }
  return options;
}

/// The parts as one pass finds them, with what decides about them.
struct Round
{
  std::shared_ptr<const Partition> partition;
  std::vector<double> significance;
  Measure measure;
  std::vector<char> gone;
  std::vector<char> isProtected;
  std::vector<ContactCurve> contacts; ///< for Topology::PaperGraph, which knows curves alone

  /// Parts that share a point, ascending; made when asked for, of those that are not gone then.
  mutable std::vector<std::optional<std::vector<Index>>> neighbors;
};

/// For each part: does it touch no other?
std::vector<char> wholePieces(const LivingCells& living, const Partition& partition)
{
  std::vector<char> result(partition.dimension.size(), 1);
  forTouchingParts(living, partition, [&](Index a, Index b) { result[a] = result[b] = 0; });
  return result;
}

/// With how many iterations do both begin that have the same outcome?
Index sharedIterations(const PruneOptions& a, const PruneOptions& b)
{
  const auto rules = [](const PruneOptions& options) {
    return std::tie(options.topology, options.removeHair, options.removeBranches, options.neckRatio,
      options.cellsToProtect);
  };
  const auto isMadeAnew = [](const PruneOptions& options) {
    return options.automatic || options.verifyTopology;
  };
  if (isMadeAnew(a) || isMadeAnew(b) || rules(a) != rules(b))
  {
    return 0;
  }
  const auto end =
    std::mismatch(a.schedule.begin(), a.schedule.end(), b.schedule.begin(), b.schedule.end());
  return static_cast<Index>(end.first - a.schedule.begin());
}

void clearRefusals(PruneRow& row)
{
  row.refused = row.refusedByTopology = row.refusedIsolated = row.refusedProtected = 0;
}

void countRefusal(KeepReason reason, PruneRow& row)
{
  ++row.refused;
  row.refusedByTopology += reason == KeepReason::Topology;
  row.refusedIsolated += reason == KeepReason::Isolated;
  row.refusedProtected += reason == KeepReason::Protected;
}

class Pruner
{
public:
  Pruner(const PrunableAxis& input, const PruneOptions& settings, const Execution& how)
    : axis(input.axis)
    , options(settings)
    , execution(how)
    , limbs(settings.neckRatio > 0 ? bodies(input.axis, input.edges, settings.neckRatio) : Bodies{})
    , living(this->limbs.ofCell.empty()
          ? input.living
          : LivingCells(input.axis.cells, input.edges, this->limbs.ofCell))
    , collapse(this->living)
    , measures(input.measures)
    , visitedIn(this->axis.points.size(), 0)
    , metIn(this->axis.cells.size(), 0)
  {
    this->result.removedInIteration.assign(this->axis.cells.size(), None);
    this->result.removedPart.assign(this->axis.cells.size(), None);
    this->resume(input.lastRecord, sharedIterations(input.lastOptions, settings));
    this->volume = this->livingVolume();
    if (this->options.verifyTopology)
    {
      this->verified = bettiNumbers(this->axis.cells);
    }
  }

  Pruned run()
  {
    if (this->options.automatic)
    {
      this->iterateAutomatically();
    }
    else
    {
      const std::vector<PruneIteration>& schedule = this->options.schedule;
      while (this->result.history.size() < schedule.size())
      {
        this->reportIterations(schedule.size());
        this->iterate(schedule[this->result.history.size()]);
      }
    }
    const std::optional<PruneIteration> last = this->lastIteration();
    if (!this->options.cellsToRemove.empty())
    {
      this->removeByHand();
    }
    this->execution.report(0.9);
    const Round round = this->newRound(last ? last->measure : Measure::TriangleCount);
    findAllLevels(this->living, *this->current);
    this->result.parts = decompose(
      this->living, *round.partition, this->measures, this->execution.part(0.9, 1), this->limbs);
    std::vector<Index>& partOfCell = this->result.parts.partOfCell;
    partOfCell.erase(std::remove(partOfCell.begin(), partOfCell.end(), None), partOfCell.end());
    this->explain(round, last);
    const Betti betti = this->result.history.empty()
      ? bettiNumbers(this->living, *round.partition, this->execution)
      : this->result.history.back().betti;
    this->result.inputCell = this->livingCells();
    this->result.axis = withCells(this->axis, this->result.inputCell, betti);
    return std::move(this->result);
  }

private:
  /// Takes over the first rows of an earlier history.
  void resume(const PruneRecord& earlier, Index rows)
  {
    if (rows == 0)
    {
      return;
    }
    std::vector<Index> removed;
    for (Index cell = 0; cell < this->axis.cells.size(); ++cell)
    {
      const Index row = earlier.removedInIteration[cell];
      if (row != None && row < rows)
      {
        this->result.removedInIteration[cell] = row;
        this->result.removedPart[cell] = earlier.removedPart[cell];
        removed.push_back(cell);
      }
    }
    this->living.remove(removed);
    this->result.history.assign(earlier.history.begin(), earlier.history.begin() + rows);
  }

  void reportIterations(std::size_t all) const
  {
    this->execution.report(
      0.9 * static_cast<double>(this->result.history.size()) / static_cast<double>(all));
  }

  /// Of the rows of the history the last by a schedule.
  std::optional<PruneIteration> lastIteration() const
  {
    if (this->result.history.empty())
    {
      return std::nullopt;
    }
    const PruneRow& row = this->result.history.back();
    return PruneIteration{ row.measure, row.threshold, row.passes, false };
  }

  /// Did the last iteration remove at least a tenth of the parts?
  bool hasDropped() const
  {
    const PruneRow& row = this->result.history.back();
    return 10 * (row.partsBefore - row.partsAfter) >= row.partsBefore;
  }

  void iterateAutomatically()
  {
    constexpr std::size_t usual = 5; // iterations, for the progress alone
    do
    {
      this->reportIterations(std::max(usual, this->result.history.size() + 1));
      this->iterate({ Measure::TriangleCount, 5, 0, false });
    }
    while (this->hasDropped());
    for (bool goesOn = true; goesOn;)
    {
      this->reportIterations(std::max(usual, this->result.history.size() + 1));
      const double threshold = this->suggestedVolume();
      goesOn = threshold > 0;
      if (goesOn)
      {
        this->iterate({ Measure::RelativeVolume, threshold, 0, false });
        goesOn = this->hasDropped();
      }
    }
  }

  /// The relative volume up to which parts may go now; 0: none.
  double suggestedVolume()
  {
    this->inherited.clear();
    const Round round = this->newRound(Measure::RelativeVolume);
    std::vector<RankedPart> parts;
    for (Index part = 0; part < count(round.significance); ++part)
    {
      if (round.partition->level[part] == 1)
      {
        parts.push_back({ round.significance[part], round.significance[part] });
      }
    }
    double budget = removableVolume;
    for (const PruneRow& row : this->result.history)
    {
      budget -= row.volumeRemoved;
    }
    return suggestedThreshold(std::move(parts), budget);
  }

  void iterate(const PruneIteration& iteration)
  {
    this->inherited.clear();
    this->countsTogether = this->options.topology != Topology::None && iteration.passes != 1;
    Round round = this->newRound(iteration.measure);
    PruneRow row = this->newRow(round);
    row.measure = iteration.measure;
    row.threshold = iteration.threshold;
    for (bool changed = true; changed && (iteration.passes == 0 || row.passes < iteration.passes);
         ++row.passes)
    {
      changed = false;
      if (this->options.removeHair)
      {
        changed = this->pass(round, iteration, 1, row);
      }
      if (changed)
      {
        round = this->newRound(iteration.measure);
      }
      if (this->pass(round, iteration, 2, row))
      {
        changed = true;
        round = this->newRound(iteration.measure);
      }
    }
    this->finish(row, round);
  }

  /// Parts of level 1 with at most the threshold and at most this dimension, least significant first.
  std::vector<Index> candidates(
    const Round& round, const PruneIteration& iteration, int dimension) const
  {
    std::vector<Index> result;
    for (Index part = 0; part < count(round.significance); ++part)
    {
      if (round.partition->level[part] == 1 && round.partition->dimension[part] <= dimension &&
        round.significance[part] <= iteration.threshold)
      {
        result.push_back(part);
      }
    }
    std::stable_sort(result.begin(), result.end(),
      [&](Index a, Index b) { return round.significance[a] < round.significance[b]; });
    return result;
  }

  /// One walk over the candidates. @return  was anything removed?
  bool pass(Round& round, const PruneIteration& iteration, int dimension, PruneRow& row)
  {
    const std::vector<Index> parts = this->candidates(round, iteration, dimension);
    const bool wantsBranches =
      this->options.removeBranches && this->options.topology == Topology::Collapse;
    bool changed = false;
    clearRefusals(row);
    for (const Index part : parts)
    {
      if (round.gone[part] || round.significance[part] > iteration.threshold)
      {
        continue; // gone with a branch, or it has inherited
      }
      std::vector<Index> unit{ part };
      const std::optional<KeepReason> reason = this->refusal(round, unit);
      if (reason)
      {
        unit =
          wantsBranches ? this->branch(round, part, iteration.threshold) : std::vector<Index>();
      }
      if (unit.empty() || (reason && this->refusal(round, unit)))
      {
        countRefusal(*reason, row);
        continue;
      }
      this->remove(round, unit, row);
      changed = true;
    }
    if (row.passes == 0)
    {
      row.candidates = std::max(row.candidates, count(parts));
    }
    return changed;
  }

  std::vector<Index> cellsOf(const Round& round, const std::vector<Index>& parts) const
  {
    std::vector<Index> cells;
    for (const Index part : parts)
    {
      const IndexLists::View own = round.partition->cells[part];
      cells.insert(cells.end(), own.begin(), own.end());
    }
    return cells;
  }

  /// Why the parts may not go together; nothing where they may.
  std::optional<KeepReason> refusal(const Round& round, const std::vector<Index>& parts)
  {
    if (std::any_of(
          parts.begin(), parts.end(), [&round](Index part) { return round.isProtected[part]; }))
    {
      return KeepReason::Protected;
    }
    const std::vector<Index> cells = this->cellsOf(round, parts);
    Effect effect = Effect::None;
    switch (this->options.topology)
    {
      case Topology::None: // something must stay
        effect = count(cells) < this->living.size() ? Effect::None : Effect::Isolated;
        break;
      case Topology::PaperGraph:
        effect = graphEffect(round, parts);
        break;
      case Topology::Collapse:
        effect = this->collapse.effectOfRemoving(cells);
    }
    return effect == Effect::None ? std::optional<KeepReason>()
      : effect == Effect::Changes ? KeepReason::Topology
                                  : KeepReason::Isolated;
  }

  /// What the paper's graph says about a part. It is an edge between the nodes that it touches: with
  /// one, it is on no loop and connects nothing; with more, it is on a loop or connects.
  static Effect graphEffect(const Round& round, const std::vector<Index>& parts)
  {
    if (parts.size() > 1)
    {
      return Effect::Changes; // the graph tells of single parts
    }
    const TopologyGraph graph = topologyGraph(round.contacts, round.gone);
    const Index nodes = graph.nodesOfPart[parts[0]].size();
    return nodes == 0 ? Effect::Isolated : nodes == 1 ? Effect::None : Effect::Changes;
  }

  void remove(Round& round, const std::vector<Index>& parts, PruneRow& row)
  {
    const std::vector<Index> cells = this->cellsOf(round, parts);
    this->living.remove(cells);
    this->current.reset();
    for (const Index cell : cells)
    {
      this->result.removedInIteration[cell] = count(this->result.history);
      this->result.removedPart[cell] = round.partition->partOfCell[cell];
    }
    for (const Index part : parts)
    {
      round.gone[part] = 1;
    }
    row.removed += count(parts);
    if (this->options.verifyTopology)
    {
      this->verify(row);
    }
    if (this->countsTogether)
    {
      this->bequeath(round, parts);
    }
  }

  /// Compares the Betti numbers, computed from the living cells alone, with those before.
  void verify(PruneRow& row)
  {
    const Betti now = bettiNumbers(withCells(this->axis, this->livingCells(), {}).cells);
    if (now != this->verified && this->options.topology == Topology::Collapse)
    {
      throw std::logic_error(
        "the removal of a part changed the Betti numbers though the topology is "
        "to be kept: a bug of the pruning, please report it with the input");
    }
    row.topologyChanges += now != this->verified;
    this->verified = now;
  }

  /// The most significant part that removed ones were attached to takes over their significance for
  /// the rest of the iteration: what goes at one place counts together. Where a measure doesn't add up
  /// this changes nothing: what went had at most the threshold.
  void bequeath(Round& round, const std::vector<Index>& parts)
  {
    double sum = 0;
    Index heir = None;
    for (const Index part : parts)
    {
      sum = together(round.measure, sum, round.significance[part]);
      for (const Index neighbor : this->neighbors(round, part))
      {
        if (!round.gone[neighbor] &&
          (heir == None || round.significance[neighbor] > round.significance[heir]))
        {
          heir = neighbor;
        }
      }
    }
    if (heir != None)
    {
      double& kept = this->inherited[round.partition->cells[heir][0]];
      round.significance[heir] = together(round.measure, round.significance[heir], sum);
      kept = together(round.measure, kept, sum);
    }
  }

  /// The part and the smaller pieces that only it connects with the rest, if their significance is
  /// together at most the threshold; else empty.
  std::vector<Index> branch(const Round& round, Index part, double threshold)
  {
    std::vector<Index> unit{ part };
    double sum = round.significance[part];
    std::unordered_map<Index, std::size_t> visited{ { part, 0 } }; // in which order
    bool restIsLarge = false;
    for (const Index start : this->neighbors(round, part))
    {
      if (round.gone[start] || visited.count(start))
      {
        continue;
      }
      double pieceSum = 0;
      std::vector<Index> piece{ start };
      const std::size_t before = visited.size();
      visited.emplace(start, before);
      bool large = false;
      for (std::size_t i = 0; i < piece.size() && !large; ++i)
      {
        pieceSum = together(round.measure, pieceSum, round.significance[piece[i]]);
        large = together(round.measure, sum, pieceSum) > threshold || piece.size() > branchLimit ||
          round.isProtected[piece[i]];
        if (large)
        {
          break; // what only it has seen meets it again
        }
        for (const Index next : this->neighbors(round, piece[i]))
        {
          const auto known = visited.find(next);
          if (known != visited.end())
          {
            // What an earlier, unfinished walk has seen belongs to the large rest.
            large = large || (next != part && known->second < before);
          }
          else if (!round.gone[next])
          {
            visited.emplace(next, visited.size());
            piece.push_back(next);
          }
        }
      }
      restIsLarge = restIsLarge || large;
      if (!large)
      {
        sum = together(round.measure, sum, pieceSum);
        unit.insert(unit.end(), piece.begin(), piece.end());
      }
    }
    return restIsLarge && unit.size() > 1 ? unit : std::vector<Index>();
  }

  Round newRound(Measure measure)
  {
    Round round;
    round.measure = measure;
    if (!this->current)
    {
      this->current = std::make_shared<Partition>(partition(this->living, 1, this->execution));
      this->measured.reset();
    }
    if (this->measured != measure)
    {
      this->significance = this->measures.significance(measure, *this->current, this->execution);
      this->measured = measure;
    }
    round.partition = this->current;
    round.gone.assign(round.partition->dimension.size(), 0);
    round.significance = this->significance;
    for (const auto& [cell, amount] : this->inherited)
    {
      if (this->living.isLiving(cell))
      {
        double& value = round.significance[round.partition->partOfCell[cell]];
        value = together(measure, value, amount);
      }
    }
    round.isProtected.assign(round.gone.size(), 0);
    for (const Index cell : this->options.cellsToProtect)
    {
      round.isProtected[round.partition->partOfCell[cell]] = 1;
    }
    if (this->options.topology == Topology::PaperGraph)
    {
      round.contacts = contacts(this->living, *round.partition);
      const auto isPoint = [](const ContactCurve& contact) { return contact.points.size() == 1; };
      round.contacts.erase(std::remove_if(round.contacts.begin(), round.contacts.end(), isPoint),
        round.contacts.end());
    }
    round.neighbors.resize(round.gone.size());
    return round;
  }

  const std::vector<Index>& neighbors(const Round& round, Index part)
  {
    if (round.neighbors[part])
    {
      return *round.neighbors[part];
    }
    std::vector<Index>& result = round.neighbors[part].emplace();
    ++this->walks;
    const auto visit = [&](Index p) {
      for (const Index other : this->living.cellsOfPoint()[p])
      {
        const Index neighbor = round.partition->partOfCell[other];
        if (neighbor != None && neighbor != part && this->metIn[neighbor] != this->walks)
        {
          this->metIn[neighbor] = this->walks;
          result.push_back(neighbor);
        }
      }
    };
    for (const Index cell : round.partition->cells[part])
    {
      forPoints(this->axis.cells, cell, [&](Index p) {
        if (this->visitedIn[p] != this->walks && this->living.cellsAtPoint(p) > 0)
        {
          this->visitedIn[p] = this->walks;
          visit(p);
        }
      });
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  /// The named parts that may go, each when it may; those that are left, together.
  void removeByHand()
  {
    this->inherited.clear();
    this->countsTogether = false;
    Round round = this->newRound(Measure::TriangleCount);
    PruneRow row = this->newRow(round);
    row.byHand = true;
    const std::vector<Index> all = this->namedParts(round);
    std::vector<Index> named = all;
    row.candidates = count(named);
    row.passes = 1;
    for (bool changed = true; changed;)
    {
      changed = false;
      for (const Index part : named)
      {
        if (!this->refusal(round, { part }))
        {
          this->remove(round, { part }, row);
          changed = true;
        }
      }
      named.erase(std::remove_if(named.begin(), named.end(),
                    [&round](Index part) { return round.gone[part] || round.isProtected[part]; }),
        named.end());
    }
    if (named.size() > 1 && !this->refusal(round, named))
    {
      this->remove(round, named, row);
    }
    this->tellFates(round, all, row);
    this->finish(row, this->newRound(Measure::TriangleCount));
  }

  /// The parts that hold living cells to be removed, ascending.
  std::vector<Index> namedParts(const Round& round)
  {
    std::vector<Index> named;
    for (const Index cell : this->options.cellsToRemove)
    {
      const bool isLiving = this->living.isLiving(cell);
      this->result.fates.push_back(isLiving ? CellFate::Removed : CellFate::AlreadyGone);
      if (isLiving)
      {
        named.push_back(round.partition->partOfCell[cell]);
      }
    }
    std::sort(named.begin(), named.end());
    named.erase(std::unique(named.begin(), named.end()), named.end());
    return named;
  }

  /// Fills the fates of what stayed, and counts the parts.
  void tellFates(const Round& round, const std::vector<Index>& named, PruneRow& row)
  {
    std::vector<CellFate> fateOfPart(round.gone.size(), CellFate::Removed);
    for (const Index part : named)
    {
      if (!round.gone[part])
      {
        const KeepReason reason = *this->refusal(round, { part });
        countRefusal(reason, row);
        fateOfPart[part] = reason == KeepReason::Topology ? CellFate::Topology
          : reason == KeepReason::Isolated                ? CellFate::Isolated
                                                          : CellFate::Protected;
      }
    }
    for (std::size_t i = 0; i < this->result.fates.size(); ++i)
    {
      const Index cell = this->options.cellsToRemove[i];
      if (this->living.isLiving(cell))
      {
        this->result.fates[i] = fateOfPart[round.partition->partOfCell[cell]];
      }
    }
  }

  PruneRow newRow(const Round& round) const
  {
    PruneRow row{};
    row.partsBefore = count(round.partition->dimension);
    row.topologyChanges = this->options.verifyTopology ? 0 : None;
    return row;
  }

  void finish(PruneRow& row, const Round& round)
  {
    row.partsAfter = count(round.partition->dimension);
    const double before = this->volume;
    this->volume = this->livingVolume();
    row.volumeRemoved = before - this->volume;
    row.betti = row.removed == 0 && !this->result.history.empty()
      ? this->result.history.back().betti
      : bettiNumbers(this->living, *round.partition, this->execution);
    this->result.history.push_back(row);
  }

  /// Of the balls that are, or whose owner is, at a point with living cells.
  double livingVolume() const
  {
    const std::vector<char> kept = keptBalls(this->axis, this->living);
    double sum = 0;
    for (std::size_t b = 0; b < kept.size(); ++b)
    {
      sum += kept[b] ? this->axis.ballVolumes[b] : 0;
    }
    return this->measures.solidVolume > 0 ? sum / this->measures.solidVolume : 0;
  }

  std::vector<Index> livingCells() const
  {
    std::vector<Index> result;
    result.reserve(this->living.size());
    for (Index c = 0; c < this->axis.cells.size(); ++c)
    {
      if (this->living.isLiving(c))
      {
        result.push_back(c);
      }
    }
    return result;
  }

  /// Fills keepReason from the last iteration's point of view.
  void explain(const Round& round, const std::optional<PruneIteration>& last)
  {
    const std::vector<char> isWhole = wholePieces(this->living, *round.partition);
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
      this->result.keepReason.push_back(reason);
    }
    for (std::size_t i = 0; i < this->result.fates.size(); ++i)
    {
      if (this->result.fates[i] == CellFate::Topology)
      {
        const Index part = round.partition->partOfCell[this->options.cellsToRemove[i]];
        this->result.keepReason[part] = KeepReason::Topology;
      }
    }
  }

  /// A rest of more parts than this counts as large, whatever their significance.
  static constexpr std::size_t branchLimit = 1000;

  const MedialAxis& axis;
  const PruneOptions& options;
  const Execution& execution;
  Bodies limbs;
  LivingCells living;
  PartCollapse collapse;
  const PartMeasures& measures;
  std::shared_ptr<Partition> current; ///< of the living cells, until something goes
  std::optional<Measure> measured;    ///< what is known of the current parts
  std::vector<double> significance;   ///< of the current parts in this measure
  double volume;                      ///< of the living cells, relative
  Betti verified{};                   ///< the last Betti numbers, where every removal is verified
  bool countsTogether = false;        ///< what one part loses after the other
  std::vector<Index> visitedIn;       ///< for each point the last of the walks that came there
  std::vector<Index> metIn;           ///< for each part the last of the walks that met it
  Index walks = 0;
  std::map<Index, double> inherited; ///< by cell, in the measure of the iteration
  Pruned result;
};
}

PrunableAxis::PrunableAxis(MedialAxis theAxis)
  : axis(std::move(theAxis))
  , edges(axisEdges(this->axis.cells))
  , living(this->axis.cells, this->edges)
  , measures(this->axis, this->living)
{
}

Pruned prune(PrunableAxis& input, const PruneOptions& givenOptions, const Execution& execution)
{
  requireValid(input.axis, givenOptions);
  const PruneOptions options = inUnits(givenOptions, input.axis.sampleDiagonal);
  Pruned result = Pruner(input, options, execution).run();
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
