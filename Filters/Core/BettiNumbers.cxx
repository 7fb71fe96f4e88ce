// SPDX-License-Identifier: BSD-3-Clause
#include "MedialAxis.h"

#include "AxisEdges.h"
#include "DisjointSets.h"
#include "LivingCells.h"
#include "Partition.h"

#include <algorithm>
#include <map>

namespace medial
{
namespace
{
/// The conditions on closed chains, which hold all triangles of a part or none: at each edge an even
/// number of them.
std::vector<std::vector<Index>> conditions(const LivingCells& living, const Partition& partition)
{
  std::vector<std::vector<Index>> rows;
  for (Index e = 0; e < living.edges.triangles.size(); ++e)
  {
    if (!living.isContact(e))
    {
      continue;
    }
    std::vector<Index> row;
    for (const Index t : living.edges.triangles[e])
    {
      const Index part = partition.partOfCell[living.cells.firstTriangle() + t];
      const auto at = std::find(row.begin(), row.end(), part);
      if (at != row.end())
      {
        row.erase(at);
      }
      else if (part != None)
      {
        row.push_back(part);
      }
    }
    std::sort(row.begin(), row.end());
    rows.push_back(std::move(row));
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

/// Parts that can't be in a closed chain because they are alone at an edge, until there is none.
void killLoneParts(const std::vector<std::vector<Index>>& rows, std::vector<char>& dead)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const std::vector<Index>& row : rows)
    {
      Index living = 0, last = None;
      for (const Index part : row)
      {
        living += !dead[part];
        last = dead[part] ? last : part;
      }
      if (living == 1)
      {
        dead[last] = 1;
        changed = true;
      }
    }
  }
}

/// Rank over Z/2 of rows given as ascending lists of their columns.
Index rank(const std::vector<std::vector<Index>>& rows, const std::vector<char>& dead)
{
  std::map<Index, std::vector<Index>> pivots; // by highest column
  for (const std::vector<Index>& all : rows)
  {
    std::vector<Index> row;
    std::copy_if(
      all.begin(), all.end(), std::back_inserter(row), [&dead](Index part) { return !dead[part]; });
    while (!row.empty())
    {
      const auto pivot = pivots.find(row.back());
      if (pivot == pivots.end())
      {
        pivots[row.back()] = row;
        break;
      }
      std::vector<Index> sum;
      std::set_symmetric_difference(row.begin(), row.end(), pivot->second.begin(),
        pivot->second.end(), std::back_inserter(sum));
      row = std::move(sum);
    }
  }
  return count(pivots);
}

Index closedChains(const LivingCells& living, const Partition& partition)
{
  std::vector<char> dead; // a part with an edge of one triangle is in no closed chain
  for (std::size_t part = 0; part < partition.level.size(); ++part)
  {
    dead.push_back(partition.dimension[part] < 2 || partition.level[part] == 1);
  }
  const std::vector<std::vector<Index>> rows = conditions(living, partition);
  killLoneParts(rows, dead);
  return static_cast<Index>(std::count(dead.begin(), dead.end(), 0)) - rank(rows, dead);
}

/// Groups of parts that share points.
Index pieces(const LivingCells& living, const Partition& partition)
{
  DisjointSets groups(count(partition.dimension));
  Index result = count(partition.dimension);
  forTouchingParts(living, partition, [&](Index a, Index b) { result -= groups.unite(a, b); });
  return result;
}

/// Points - edges + triangles.
Index eulerCharacteristic(const LivingCells& living)
{
  const AxisCells& cells = living.cells;
  Index result = 0;
  for (Index p = 0; p < living.cellsOfPoint().size(); ++p)
  {
    result += living.cellsAtPoint(p) > 0;
  }
  std::vector<char> used(living.edges.points.size(), 0);
  for (Index e = 0; e < count(used); ++e)
  {
    used[e] = living.trianglesAtEdge(e) > 0;
  }
  for (Index c = cells.firstEdge(); c < cells.firstTriangle(); ++c)
  {
    char& edge = used[living.edges.ofDangling[c - cells.firstEdge()]];
    edge = edge || living.isLiving(c);
  }
  for (Index c = cells.firstTriangle(); c < cells.size(); ++c)
  {
    result += living.isLiving(c);
  }
  return result - static_cast<Index>(std::count(used.begin(), used.end(), 1));
}
}

Betti bettiNumbers(
  const LivingCells& living, const Partition& partition, const Execution& execution)
{
  std::array<Index, 3> found{};
  execution.forEach(3, [&](Index task) {
    found[task] = task == 0 ? pieces(living, partition)
      : task == 1           ? closedChains(living, partition)
                            : eulerCharacteristic(living);
  });
  const auto [b0, b2, euler] = found;
  return { b0, b0 + b2 - euler, b2 };
}

Betti bettiNumbers(const AxisCells& cells)
{
  const AxisEdges edges = axisEdges(cells);
  LivingCells living(cells, edges);
  return bettiNumbers(living, partition(living, 1));
}
}
