// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/MedialAxis.h"
#include "Base/Lists.h"

#include "Axis/AxisEdges.h"
#include "Base/DisjointSets.h"
#include "Parts/LivingCells.h"
#include "Parts/Partition.h"

#include <algorithm>
#include <map>

namespace medial
{
namespace
{
/// The conditions on closed chains, which hold all triangles of a part or none: at each edge an even
/// number of them.
IndexLists conditions(const LivingCells& living, const Partition& partition)
{
  IndexLists rows;
  std::vector<Index> row;
  for (Index e = 0; e < living.edges.triangles.size(); ++e)
  {
    if (!living.isContact(e))
    {
      continue;
    }
    row.clear();
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
    rows.items.insert(rows.items.end(), row.begin(), row.end());
    rows.close();
  }
  return rows;
}

/// Parts that can't be in a closed chain because they are alone at an edge, until there is none.
void killLoneParts(const IndexLists& rows, std::vector<char>& dead)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for (Index row = 0; row < rows.size(); ++row)
    {
      Index living = 0, last = None;
      for (const Index part : rows[row])
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
Index rank(const IndexLists& rows, const std::vector<char>& dead)
{
  std::map<Index, std::vector<Index>> pivots; // by highest column
  for (Index i = 0; i < rows.size(); ++i)
  {
    const IndexLists::View all = rows[i];
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
  const IndexLists rows = conditions(living, partition);
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
}

Betti bettiNumbers(
  const LivingCells& living, const Partition& partition, const Execution& execution)
{
  std::array<Index, 2> found{};
  execution.forEach(2, [&](Index task) {
    found[task] = task == 0 ? pieces(living, partition) : closedChains(living, partition);
  });
  const auto [b0, b2] = found;
  return { b0, b0 + b2 - living.eulerCharacteristic(), b2 };
}

Betti bettiNumbers(const AxisCells& cells)
{
  const AxisEdges edges = axisEdges(cells);
  LivingCells living(cells, edges);
  return bettiNumbers(living, partition(living, 1));
}
}
