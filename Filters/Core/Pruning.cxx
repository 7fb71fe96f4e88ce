// SPDX-License-Identifier: BSD-3-Clause
#include "Pruning.h"

#include "AxisEdges.h"
#include "DisjointSets.h"
#include "PartCollapse.h"
#include "Partition.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>

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
      throw InvalidInput("cell " + std::to_string(cell) + " is to be removed, but the axis has only " +
        std::to_string(axis.cells.size()) + " cells; ids are those of the input");
    }
  }
}

/// The parts as one pass finds them, with what decides about them. Parts grow together when what
/// parted them is removed; a part then stands for all that grew into it.
struct Round
{
  Partition partition;
  DisjointSets grown{ 0 };
  std::vector<std::vector<Index>> cells;
  std::vector<double> significance;
  std::vector<char> gone;
  std::vector<std::vector<Index>> neighbors; ///< parts that share a point, before they grew

  Index size() const { return count(this->cells); }
  bool isAtBorder(Index part) const { return this->partition.level[part] == 1; }

  Index merge(Index a, Index b)
  {
    const Index into = std::min(a, b), from = std::max(a, b);
    const auto append = [](std::vector<Index>& to, const std::vector<Index>& list) {
      to.insert(to.end(), list.begin(), list.end());
    };
    this->grown.unite(a, b);
    append(this->cells[into], this->cells[from]);
    append(this->neighbors[into], this->neighbors[from]);
    this->significance[into] += this->significance[from];
    int& level = this->partition.level[into];
    level = this->isAtBorder(from) ? 1 : level;
    return into;
  }

  /// The living parts that touch one, each once, ascending.
  std::vector<Index> around(Index part)
  {
    std::vector<Index> result;
    for (const Index neighbor : this->neighbors[part])
    {
      const Index now = this->grown.find(neighbor);
      if (now != part && !this->gone[now])
      {
        result.push_back(now);
      }
    }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }
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
    , totalVolume(std::accumulate(input.ballVolumes.begin(), input.ballVolumes.end(), 0.0))
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
    this->inherited.assign(this->axis.cells.size(), 0);
    Round round = this->newRound(iteration.measure);
    PruneRow row = this->newRow(round);
    row.measure = iteration.measure;
    row.threshold = iteration.threshold;
    for (bool changed = true;
         changed && (iteration.passes == 0 || row.passes < iteration.passes); ++row.passes)
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

  /// One walk over the parts of level 1 with at most the threshold and at most this dimension, least
  /// significant first. @return  was anything removed?
  bool pass(Round& round, const PruneIteration& iteration, int dimension, PruneRow& row)
  {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    const auto offer = [&](Index part) {
      if (round.isAtBorder(part) && round.partition.dimension[part] <= dimension &&
        round.significance[part] <= iteration.threshold)
      {
        queue.push({ round.significance[part], part });
      }
    };
    for (Index part = 0; part < round.size(); ++part)
    {
      offer(part);
    }
    const Index candidates = static_cast<Index>(queue.size());
    const Index removedBefore = row.removed;
    row.refused = 0;
    while (!queue.empty())
    {
      const auto [significance, part] = queue.top();
      queue.pop();
      if (round.gone[part] || round.grown.find(part) != part ||
        round.significance[part] != significance)
      {
        continue; // gone with a branch, grown into another one, or it has inherited
      }
      std::vector<Index> unit{ part };
      if (!this->mayGo(round, unit))
      {
        unit = this->options.removeBranches ? this->branch(round, part, iteration.threshold)
                                            : std::vector<Index>();
      }
      if (unit.empty() || (unit.size() > 1 && !this->mayGo(round, unit)))
      {
        ++row.refused;
        continue;
      }
      for (const Index changed : this->remove(round, unit, row))
      {
        offer(changed);
      }
    }
    row.candidates = row.passes == 0 ? std::max(row.candidates, candidates) : row.candidates;
    return row.removed > removedBefore;
  }

  std::vector<Index> cellsOf(const Round& round, const std::vector<Index>& parts) const
  {
    std::vector<Index> cells;
    for (const Index part : parts)
    {
      const std::vector<Index>& own = round.cells[part];
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

  /// Removes parts. @return  the parts whose significance changed
  std::vector<Index> remove(Round& round, const std::vector<Index>& parts, PruneRow& row)
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
    std::vector<Index> changed{ this->bequeath(round, parts) };
    this->growTogether(round, cells, changed);
    changed.erase(std::remove(changed.begin(), changed.end(), None), changed.end());
    return changed;
  }

  /// The most significant part that removed ones were attached to takes over their significance for
  /// the rest of the iteration: what goes at one place, one after the other, counts together.
  Index bequeath(Round& round, const std::vector<Index>& parts)
  {
    double sum = 0;
    Index heir = None;
    for (const Index part : parts)
    {
      sum += round.significance[part];
      for (const Index neighbor : round.around(part))
      {
        if (heir == None || round.significance[neighbor] > round.significance[heir])
        {
          heir = neighbor;
        }
      }
    }
    if (heir != None)
    {
      round.significance[heir] += sum;
      this->inherited[round.cells[heir][0]] += sum;
    }
    return heir;
  }

  /// Where an edge of removed triangles has two triangles left, their parts are one from now on.
  void growTogether(
    Round& round, const std::vector<Index>& removed, std::vector<Index>& changed) const
  {
    const Index first = this->axis.cells.firstTriangle();
    for (const Index cell : removed)
    {
      for (int k = 0; k < 3 && cell >= first; ++k)
      {
        std::vector<Index> left;
        for (const Index t : this->edges.triangles[this->edges.ofTriangle[cell - first][k]])
        {
          if (this->living.isLiving(first + t))
          {
            left.push_back(round.grown.find(round.partition.partOfCell[first + t]));
          }
        }
        if (left.size() == 2 && left[0] != left[1])
        {
          changed.push_back(round.merge(left[0], left[1]));
        }
      }
    }
    for (Index& part : changed)
    {
      part = part == None ? None : round.grown.find(part);
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  }

  /// The part and the smaller pieces that only it connects with the rest, if their significance sums
  /// to at most the threshold; else empty.
  std::vector<Index> branch(Round& round, Index part, double threshold) const
  {
    std::vector<Index> unit{ part };
    double sum = round.significance[part];
    std::vector<Index> visited{ part };
    bool restIsLarge = false;
    const auto wasVisited = [&visited](Index p) {
      return std::find(visited.begin(), visited.end(), p) != visited.end();
    };
    for (const Index start : round.around(part))
    {
      if (wasVisited(start))
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
        pieceSum += round.significance[piece[i]];
        large = sum + pieceSum > threshold || piece.size() > branchLimit;
        for (const Index next : round.around(piece[i]))
        {
          const auto known = std::find(visited.begin(), visited.end(), next);
          if (known == visited.end())
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
        sum += pieceSum;
        unit.insert(unit.end(), piece.begin(), piece.end());
      }
    }
    return restIsLarge && unit.size() > 1 ? unit : std::vector<Index>();
  }

  Round newRound(Measure measure) const
  {
    Round round;
    round.partition = partition(this->axis.cells, this->edges, this->living.mask());
    const Index parts = count(round.partition.dimension);
    round.grown = DisjointSets(parts);
    round.gone.assign(parts, 0);
    round.significance.assign(parts, 0);
    for (Index part = 0; part < parts; ++part)
    {
      const IndexLists::View own = round.partition.cells[part];
      round.cells.emplace_back(own.begin(), own.end());
    }
    if (measure == Measure::TriangleCount)
    {
      for (Index part = 0; part < parts; ++part)
      {
        round.significance[part] = round.partition.cells[part].size();
      }
    }
    else
    {
      const std::vector<Index> partOf = partOfBall(this->axis, round.partition.partOfCell);
      for (std::size_t b = 0; b < partOf.size(); ++b)
      {
        if (partOf[b] != None && this->totalVolume > 0)
        {
          round.significance[partOf[b]] += this->axis.ballVolumes[b] / this->totalVolume;
        }
      }
    }
    for (Index cell = 0; cell < count(this->inherited); ++cell)
    {
      if (round.partition.partOfCell[cell] != None)
      {
        round.significance[round.partition.partOfCell[cell]] += this->inherited[cell];
      }
    }
    round.neighbors = this->touchingParts(round.partition);
    return round;
  }

  std::vector<std::vector<Index>> touchingParts(const Partition& partition) const
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
    for (std::vector<Index>& list : touching)
    {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return touching;
  }

  /// The named parts that may go, each when it may; those that are left, together.
  void removeByHand()
  {
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
    MedialAxis pruned = this->axis;
    pruned.cells = {};
    pruned.polygonOfCell.clear();
    pruned.samplesOfCell.clear();
    this->result.inputCell.clear();
    const AxisCells& cells = this->axis.cells;
    for (Index c = 0; c < cells.size(); ++c)
    {
      if (!this->living.isLiving(c))
      {
        continue;
      }
      this->result.inputCell.push_back(c);
      pruned.polygonOfCell.push_back(this->axis.polygonOfCell[c]);
      pruned.samplesOfCell.push_back(this->axis.samplesOfCell[c]);
      if (c < cells.firstEdge())
      {
        pruned.cells.vertices.push_back(cells.vertices[c]);
      }
      else if (c < cells.firstTriangle())
      {
        pruned.cells.edges.push_back(cells.edges[c - cells.firstEdge()]);
      }
      else
      {
        pruned.cells.triangles.push_back(cells.triangles[c - cells.firstTriangle()]);
      }
    }
    pruned.betti = bettiNumbers(pruned.cells);
    pruned.certificate = pruned.betti == pruned.powerShapeBetti;
    return pruned;
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
      if (round.neighbors[part].empty())
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
  double totalVolume;
  std::vector<Index> refusedCells; ///< named by hand, kept for topology
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
