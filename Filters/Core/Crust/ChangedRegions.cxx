// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/ChangedRegions.h"

#include "Base/DisjointSets.h"
#include "Base/Lists.h"
#include "Base/Tetrahedra.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{
/// A triangle of a cell, without its lowest corner.
struct UpperCorners
{
  Index middle, highest, cell;
  bool operator<(const UpperCorners& other) const
  {
    return std::tie(this->middle, this->highest, this->cell) <
      std::tie(other.middle, other.highest, other.cell);
  }
};

/// Cells with a triangle in common are in one set.
/// @param cells  corners ascending
DisjointSets joinedAcrossTriangles(const std::vector<Tetrahedron>& cells)
{
  const Index cornerCount = cells.empty() ? 0
                                          : 1 +
      std::max_element(cells.begin(), cells.end(), [](const Tetrahedron& a, const Tetrahedron& b) {
        return a[3] < b[3];
      })->back();
  Lists<UpperCorners> triangles = listsByKey<UpperCorners>(cornerCount, [&cells](const auto& add) {
    for (Index c = 0; c < count(cells); ++c)
    {
      const auto [first, second, third, fourth] = cells[c];
      add(first, UpperCorners{ second, third, c });
      add(first, UpperCorners{ second, fourth, c });
      add(first, UpperCorners{ third, fourth, c });
      add(second, UpperCorners{ third, fourth, c });
    }
  });
  triangles.sortEach();
  DisjointSets sets(count(cells));
  for (Index corner = 0; corner < triangles.size(); ++corner)
  {
    const auto list = triangles[corner];
    for (Index i = 1; i < list.size(); ++i)
    {
      if (list[i].middle == list[i - 1].middle && list[i].highest == list[i - 1].highest)
      {
        sets.unite(list[i].cell, list[i - 1].cell);
      }
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
  std::set_difference(
    with.begin(), with.end(), without.begin(), without.end(), std::back_inserter(changed));
  const Index withCount = count(changed);
  std::set_difference(
    without.begin(), without.end(), with.begin(), with.end(), std::back_inserter(changed));
  DisjointSets sets = joinedAcrossTriangles(changed);
  const IndexLists cellsOfSet = listsByKey(count(changed), [&](const auto& add) {
    for (Index c = 0; c < count(changed); ++c)
    {
      add(sets.find(c), c);
    }
  });
  std::vector<ChangedRegion> result;
  std::vector<Index> regionOfBall; // the last one in which each ball was met
  for (Index set = 0; set < cellsOfSet.size(); ++set)
  {
    ChangedRegion region;
    for (const Index c : cellsOfSet[set])
    {
      for (const Index ball : changed[c])
      {
        regionOfBall.resize(std::max<std::size_t>(regionOfBall.size(), ball + 1), None);
        if (regionOfBall[ball] != set)
        {
          regionOfBall[ball] = set;
          region.balls.push_back(ball);
        }
      }
      (c < withCount ? region.with : region.without).push_back(changed[c]);
    }
    std::sort(region.balls.begin(), region.balls.end());
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
