// SPDX-License-Identifier: BSD-3-Clause
#include "Pruning.h"

#include "AxisEdges.h"
#include "PartCollapse.h"
#include "Partition.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace medial
{
namespace
{
using Effect = LivingCells::Effect;

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
  IndexLists neighbors; ///< parts that share a point
};

class Pruner
{
public:
  Pruner(const MedialAxis& input, const PruneOptions& settings, const Execution& how)
    : axis(input)
    , options(settings)
    , execution(how)
    , edges(axisEdges(input.cells))
    , living(input.cells, this->edges)
    , measures(input)
    , totalVolume(std::accumulate(input.ballVolumes.begin(), input.ballVolumes.end(), 0.0))
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
    this->result.axis = this->livingAxis();
    this->result.parts = decompose(this->result.axis);
    this->explain();
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
      changed = this->pass(round, iteration, 2, row) || changed;
      round = this->newRound(iteration.measure);
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
    return this->living.effectOfRemoving(cells) == Effect::None;
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
      for (const Index neighbor : round.neighbors[part])
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
  std::vector<Index> branch(const Round& round, Index part, double threshold) const
  {
    std::vector<Index> unit{ part };
    double sum = round.significance[part];
    std::vector<Index> visited{ part };
    bool restIsLarge = false;
    const auto wasVisited = [&visited](Index p) {
      return std::find(visited.begin(), visited.end(), p) != visited.end();
    };
    for (const Index start : round.neighbors[part])
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
        for (const Index next : round.neighbors[piece[i]])
        {
          const auto known = std::find(visited.begin(), visited.end(), next);
          if (known == visited.end() && !round.gone[next])
          {
            visited.push_back(next);
            piece.push_back(next);
          }
          // What an earlier, unfinished walk has seen belongs to the large rest.
          large = large ||
            (known != visited.end() && next != part &&
              known - visited.begin() < static_cast<std::ptrdiff_t>(before));
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

  Round newRound(Measure measure) const
  {
    Round round;
    round.measure = measure;
    round.partition = partition(this->axis.cells, this->edges, this->living.mask());
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
    round.neighbors = this->touchingParts(round.partition);
    return round;
  }

  IndexLists touchingParts(const Partition& partition) const
  {
    std::vector<std::vector<Index>> partsAt(this->axis.points.size());
    const AxisCells& cells = this->axis.cells;
    const auto add = [&](Index cell, const auto& points) {
      const Index part = partition.partOfCell[cell];
      for (const Index p : points)
      {
        if (part != None && (partsAt[p].empty() || partsAt[p].back() != part))
        {
          partsAt[p].push_back(part);
        }
      }
    };
    for (Index v = 0; v < count(cells.vertices); ++v)
    {
      add(v, std::array<Index, 1>{ cells.vertices[v] });
    }
    for (Index e = 0; e < count(cells.edges); ++e)
    {
      add(cells.firstEdge() + e, cells.edges[e]);
    }
    for (Index t = 0; t < count(cells.triangles); ++t)
    {
      add(cells.firstTriangle() + t, cells.triangles[t]);
    }
    std::vector<std::vector<Index>> touching(partition.dimension.size());
    for (const std::vector<Index>& at : partsAt)
    {
      for (const Index a : at)
      {
        for (const Index b : at)
        {
          if (a != b)
          {
            touching[a].push_back(b);
          }
        }
      }
    }
    IndexLists result;
    for (std::vector<Index>& list : touching)
    {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
      result.items.insert(result.items.end(), list.begin(), list.end());
      result.close();
    }
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
    row.volumeRemoved = this->livingVolume(round);
    return row;
  }

  void finish(PruneRow& row, const Round& round)
  {
    row.partsAfter = count(round.partition.dimension);
    row.volumeRemoved -= this->livingVolume(round);
    row.betti = this->livingAxis().betti;
    this->result.history.push_back(row);
  }

  double livingVolume(const Round& round) const
  {
    const std::vector<Index> partOf = partOfBall(this->axis, round.partition.partOfCell);
    double sum = 0;
    for (std::size_t b = 0; b < partOf.size(); ++b)
    {
      sum += partOf[b] == None ? 0 : this->axis.ballVolumes[b];
    }
    return this->totalVolume > 0 ? sum / this->totalVolume : 0;
  }

  /// The axis with the living cells alone; fills inputCell.
  MedialAxis livingAxis()
  {
    this->result.inputCell.clear();
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
  void explain()
  {
    const PruneIteration last =
      this->options.schedule.empty() ? PruneIteration{} : this->options.schedule.back();
    const Round round = this->newRound(last.measure);
    for (Index part = 0; part < count(round.significance); ++part)
    {
      KeepReason reason = KeepReason::Topology;
      if (round.neighbors[part].size() == 0)
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
  PartMeasures measures;
  double totalVolume;
  std::vector<Index> refusedCells; ///< named by hand, kept for topology
  bool countsTogether = false;     ///< what one part loses after the other
  std::vector<double> inherited;   ///< by cell, in the measure of the iteration
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
