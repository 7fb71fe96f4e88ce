// SPDX-License-Identifier: BSD-3-Clause
#include "Pruning.h"

#include "AxisEdges.h"
#include "LivingCells.h"
#include "PartCollapse.h"
#include "Partition.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

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
  for (const Index cell : options.cellsToRemove)
  {
    if (cell < 0 || cell >= axis.cells.size())
    {
      throw InvalidInput("cell " + std::to_string(cell) +
        " is to be removed, but the axis has only " + std::to_string(axis.cells.size()) +
        " cells; ids are those of the input");
    }
  }
}

/// The parts as one pass finds them, with what decides about them.
struct Round
{
  Partition partition;
  std::vector<double> significance;
  Measure measure;
  std::vector<char> gone;

  /// Parts that share a point, ascending; made when asked for.
  mutable std::vector<std::optional<std::vector<Index>>> neighbors;
};

/// For each part: does it touch no other?
std::vector<char> wholePieces(const LivingCells& living, const Partition& partition)
{
  std::vector<char> result(partition.dimension.size(), 1);
  for (Index p = 0; p < living.cellsOfPoint().size(); ++p)
  {
    Index last = None;
    for (const Index cell : living.cellsOfPoint()[p])
    {
      const Index part = partition.partOfCell[cell];
      if (part != None && last != None && part != last)
      {
        result[part] = result[last] = 0;
      }
      last = part == None ? last : part;
    }
  }
  return result;
}

class Pruner
{
public:
  Pruner(const MedialAxis& input, const PruneOptions& settings, const Execution& how)
    : axis(input)
    , options(settings)
    , execution(how)
    , edges(axisEdges(input.cells))
    , living(input.cells, this->edges)
    , collapse(this->living)
    , measures(input)
    , totalVolume(std::accumulate(input.ballVolumes.begin(), input.ballVolumes.end(), 0.0))
    , visitedIn(input.points.size(), 0)
    , inherited(input.cells.size(), 0)
  {
    this->result.removedInIteration.assign(input.cells.size(), None);
    this->result.removedPart.assign(input.cells.size(), None);
  }

  Pruned run()
  {
    const double steps = static_cast<double>(this->options.schedule.size()) + 2;
    for (const PruneIteration& iteration : this->options.schedule)
    {
      this->execution.report(static_cast<double>(this->result.history.size()) / steps);
      this->iterate(iteration);
    }
    if (!this->options.cellsToRemove.empty())
    {
      this->removeByHand();
    }
    this->execution.report(1 - 1 / steps);
    const Round round =
      this->newRound(this->options.schedule.empty() ? Measure::TriangleCount
                                                    : this->options.schedule.back().measure);
    this->result.axis = this->livingAxis();
    this->result.parts = decompose(this->result.axis);
    this->explain(round);
    return std::move(this->result);
  }

private:
  void iterate(const PruneIteration& iteration)
  {
    std::fill(this->inherited.begin(), this->inherited.end(), 0);
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
      if (round.partition.level[part] == 1 && round.partition.dimension[part] <= dimension &&
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
    bool changed = false;
    Index refused = 0;
    for (const Index part : parts)
    {
      if (round.gone[part] || round.significance[part] > iteration.threshold)
      {
        continue; // gone with a branch, or it has inherited
      }
      std::vector<Index> unit{ part };
      if (!this->mayGo(round, unit))
      {
        unit = this->options.removeBranches ? this->branch(round, part, iteration.threshold)
                                            : std::vector<Index>();
      }
      if (unit.empty() || (unit.size() > 1 && !this->mayGo(round, unit)))
      {
        ++refused;
        continue;
      }
      this->remove(round, unit, row);
      changed = true;
    }
    if (row.passes == 0)
    {
      row.candidates = std::max(row.candidates, count(parts));
    }
    row.refused = refused;
    return changed;
  }

  std::vector<Index> cellsOf(const Round& round, const std::vector<Index>& parts) const
  {
    std::vector<Index> cells;
    for (const Index part : parts)
    {
      const IndexLists::View own = round.partition.cells[part];
      cells.insert(cells.end(), own.begin(), own.end());
    }
    return cells;
  }

  bool mayGo(const Round& round, const std::vector<Index>& parts)
  {
    const std::vector<Index> cells = this->cellsOf(round, parts);
    if (this->options.topology == Topology::None)
    {
      return count(cells) < this->living.size(); // something must stay
    }
    return this->collapse.effectOfRemoving(cells) == Effect::None;
  }

  void remove(Round& round, const std::vector<Index>& parts, PruneRow& row)
  {
    const std::vector<Index> cells = this->cellsOf(round, parts);
    this->living.remove(cells);
    for (const Index cell : cells)
    {
      this->result.removedInIteration[cell] = count(this->result.history);
      this->result.removedPart[cell] = round.partition.partOfCell[cell];
    }
    for (const Index part : parts)
    {
      round.gone[part] = 1;
    }
    row.removed += count(parts);
    if (this->countsTogether)
    {
      this->bequeath(round, parts);
    }
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
      double& kept = this->inherited[round.partition.cells[heir][0]];
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
    std::vector<Index> visited{ part };
    bool restIsLarge = false;
    const auto wasVisited = [&visited](Index p) {
      return std::find(visited.begin(), visited.end(), p) != visited.end();
    };
    for (const Index start : this->neighbors(round, part))
    {
      if (round.gone[start] || wasVisited(start))
      {
        continue;
      }
      double pieceSum = 0;
      std::vector<Index> piece{ start };
      const std::size_t before = visited.size();
      visited.push_back(start);
      bool large = false;
      for (std::size_t i = 0; i < piece.size() && !large; ++i)
      {
        pieceSum = together(round.measure, pieceSum, round.significance[piece[i]]);
        large = together(round.measure, sum, pieceSum) > threshold || piece.size() > branchLimit;
        for (const Index next : this->neighbors(round, piece[i]))
        {
          const auto known = std::find(visited.begin(), visited.end(), next);
          if (known != visited.end())
          {
            // What an earlier, unfinished walk has seen belongs to the large rest.
            const auto place = static_cast<std::size_t>(known - visited.begin());
            large = large || (next != part && place < before);
          }
          else if (!round.gone[next])
          {
            visited.push_back(next);
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
    round.partition = partition(this->living, 1);
    round.gone.assign(round.partition.dimension.size(), 0);
    round.significance = this->measures.significance(measure, round.partition);
    for (Index cell = 0; cell < count(this->inherited); ++cell)
    {
      if (round.partition.partOfCell[cell] != None && this->inherited[cell] > 0)
      {
        double& value = round.significance[round.partition.partOfCell[cell]];
        value = together(measure, value, this->inherited[cell]);
      }
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
        const Index neighbor = round.partition.partOfCell[other];
        if (neighbor != None && neighbor != part && (result.empty() || result.back() != neighbor))
        {
          result.push_back(neighbor);
        }
      }
    };
    for (const Index cell : round.partition.cells[part])
    {
      forPoints(this->axis.cells, cell, [&](Index p) {
        if (this->visitedIn[p] != this->walks)
        {
          this->visitedIn[p] = this->walks;
          visit(p);
        }
      });
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// The named parts that may go, each when it may; those that are left, together.
  void removeByHand()
  {
    std::fill(this->inherited.begin(), this->inherited.end(), 0);
    this->countsTogether = false;
    Round round = this->newRound(Measure::TriangleCount);
    PruneRow row = this->newRow(round);
    row.byHand = true;
    std::vector<Index> named;
    for (const Index cell : this->options.cellsToRemove)
    {
      if (this->living.isLiving(cell))
      {
        named.push_back(round.partition.partOfCell[cell]);
      }
    }
    std::sort(named.begin(), named.end());
    named.erase(std::unique(named.begin(), named.end()), named.end());
    row.candidates = count(named);
    row.passes = 1;
    for (bool changed = true; changed;)
    {
      changed = false;
      for (const Index part : named)
      {
        if (!round.gone[part] && this->mayGo(round, { part }))
        {
          this->remove(round, { part }, row);
          changed = true;
        }
      }
      named.erase(std::remove_if(named.begin(), named.end(),
                    [&round](Index part) { return round.gone[part] != 0; }),
        named.end());
    }
    if (named.size() > 1 && this->mayGo(round, named))
    {
      this->remove(round, named, row);
      named.clear();
    }
    row.refused = count(named);
    this->refusedCells = this->cellsOf(round, named);
    this->finish(row, this->newRound(Measure::TriangleCount));
  }

  PruneRow newRow(const Round& round) const
  {
    PruneRow row{};
    row.partsBefore = count(round.partition.dimension);
    row.volumeRemoved = this->livingVolume();
    return row;
  }

  void finish(PruneRow& row, const Round& round)
  {
    row.partsAfter = count(round.partition.dimension);
    row.volumeRemoved -= this->livingVolume();
    row.betti = bettiNumbers(this->living, round.partition);
    this->result.history.push_back(row);
  }

  /// Of the balls that are, or whose owner is, at a point with living cells.
  double livingVolume() const
  {
    std::vector<char> kept(this->axis.ballOwner.size(), 0);
    for (Index p = 0; p < this->living.cellsOfPoint().size(); ++p)
    {
      const Index ball = this->axis.ballOfPoint[p];
      if (ball != None && this->living.cellsAtPoint(p) > 0)
      {
        kept[ball] = 1;
      }
    }
    double sum = 0;
    for (std::size_t b = 0; b < kept.size(); ++b)
    {
      const Index owner = this->axis.ballOwner[b];
      sum += owner != None && kept[owner] ? this->axis.ballVolumes[b] : 0;
    }
    return this->totalVolume > 0 ? sum / this->totalVolume : 0;
  }

  /// The axis with the living cells alone; fills inputCell.
  MedialAxis livingAxis()
  {
    for (Index c = 0; c < this->axis.cells.size(); ++c)
    {
      if (this->living.isLiving(c))
      {
        this->result.inputCell.push_back(c);
      }
    }
    return withCells(this->axis, this->result.inputCell);
  }

  /// Fills keepReason from the last iteration's point of view.
  void explain(const Round& round)
  {
    const PruneIteration last =
      this->options.schedule.empty() ? PruneIteration{} : this->options.schedule.back();
    const std::vector<char> isWhole = wholePieces(this->living, round.partition);
    for (Index part = 0; part < count(round.significance); ++part)
    {
      KeepReason reason = KeepReason::Topology;
      if (isWhole[part])
      {
        reason = KeepReason::Isolated;
      }
      else if (round.partition.level[part] != 1)
      {
        reason = KeepReason::InnerLevel;
      }
      else if (this->options.schedule.empty() || round.significance[part] > last.threshold)
      {
        reason = KeepReason::AboveThreshold;
      }
      this->result.keepReason.push_back(reason);
    }
    for (const Index cell : this->refusedCells)
    {
      this->result.keepReason[round.partition.partOfCell[cell]] = KeepReason::Topology;
    }
  }

  /// A rest of more parts than this counts as large, whatever their significance.
  static constexpr std::size_t branchLimit = 1000;

  const MedialAxis& axis;
  const PruneOptions& options;
  const Execution& execution;
  AxisEdges edges;
  LivingCells living;
  PartCollapse collapse;
  PartMeasures measures;
  double totalVolume;
  std::vector<Index> refusedCells; ///< named by hand, kept for topology
  bool countsTogether = false;     ///< what one part loses after the other
  std::vector<Index> visitedIn;    ///< for each point the last of the walks that came there
  Index walks = 0;
  std::vector<double> inherited; ///< by cell, in the measure of the iteration
  Pruned result;
};
}

Pruned prune(const MedialAxis& axis, const PruneOptions& options, const Execution& execution)
{
  requireValid(axis, options);
  Pruned result = Pruner(axis, options, execution).run();
  execution.report(1);
  return result;
}
}
