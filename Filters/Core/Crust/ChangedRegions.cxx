// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/ChangedRegions.h"

#include "Base/DisjointSets.h"
#include "Base/EdgeTable.h"
#include "Base/Lists.h"
#include "Base/Tetrahedra.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace medial
{
namespace
{
/// Cells with a triangle in common are in one set.
DisjointSets joinedAcrossTriangles(const std::vector<Tetrahedron>& cells)
{
  TriangleTable firstCell(2 * cells.size());
  DisjointSets sets(count(cells));
  for (Index c = 0; c < count(cells); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      sets.unite(c, firstCell.numberOf(facet(cells[c], i), c));
    }
  }
  return sets;
}
}

std::vector<ChangedRegion> changedRegions(std::vector<Tetrahedron> with,
  std::vector<Tetrahedron> without, const std::vector<Index>& removed)
{
  sortCells(with);
  sortCells(without);
  std::vector<Tetrahedron> changed;
  std::set_symmetric_difference(
    with.begin(), with.end(), without.begin(), without.end(), std::back_inserter(changed));
  DisjointSets sets = joinedAcrossTriangles(changed);
  const IndexLists cellsOfSet = listsByKey(count(changed), [&](const auto& add) {
    for (Index c = 0; c < count(changed); ++c)
    {
      add(sets.find(c), c);
    }
  });
  std::vector<ChangedRegion> result;
  for (Index set = 0; set < cellsOfSet.size(); ++set)
  {
    ChangedRegion region;
    for (const Index c : cellsOfSet[set])
    {
      region.balls.insert(region.balls.end(), changed[c].begin(), changed[c].end());
    }
    sortUnique(region.balls);
    std::set_intersection(region.balls.begin(), region.balls.end(), removed.begin(), removed.end(),
      std::back_inserter(region.removed));
    if (!region.removed.empty())
    {
      result.push_back(std::move(region));
    }
  }
  std::sort(result.begin(), result.end(), [](const ChangedRegion& a, const ChangedRegion& b) {
    return a.removed.front() < b.removed.front();
  });
  return result;
}
}
