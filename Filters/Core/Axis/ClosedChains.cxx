// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/ClosedChains.h"

#include <algorithm>
#include <iterator>
#include <map>

// Each edge where groups meet is a linear equation over Z/2: the groups with an odd number of
// triangles there sum to 0. The closed chains are the solutions, so their dimension is the number of
// groups less the rank of the equations. Elimination takes up to n^3 for n groups; but most groups of
// a medial axis reach its border, and those and what then stands alone are excluded first, in time
// linear in the equations for each round. What remains is about the walls of voids.

namespace medial
{
namespace
{
/// The equations: for each edge the groups with an odd number of triangles there, ascending.
IndexLists equations(const IndexLists& groupsAtEdges)
{
  IndexLists result;
  std::vector<Index> sorted;
  for (Index edge = 0; edge < groupsAtEdges.size(); ++edge)
  {
    const IndexLists::View groups = groupsAtEdges[edge];
    sorted.assign(groups.begin(), groups.end());
    std::sort(sorted.begin(), sorted.end());
    for (auto first = sorted.begin(); first != sorted.end();)
    {
      const auto last = std::upper_bound(first, sorted.end(), *first);
      if ((last - first) % 2 == 1)
      {
        result.items.push_back(*first);
      }
      first = last;
    }
    result.close();
  }
  return result;
}

/// Excludes groups that are the only one left in an equation, until there is none.
void excludeLoneGroups(const IndexLists& rows, std::vector<char>& excluded)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for (Index row = 0; row < rows.size(); ++row)
    {
      Index left = 0, last = None;
      for (const Index group : rows[row])
      {
        left += !excluded[group];
        last = excluded[group] ? last : group;
      }
      if (left == 1)
      {
        excluded[last] = 1;
        changed = true;
      }
    }
  }
}

/// Rank over Z/2 of the equations without the excluded groups, by Gaussian elimination on lists.
Index rank(const IndexLists& rows, const std::vector<char>& excluded)
{
  std::map<Index, std::vector<Index>> pivots; // by highest group
  for (Index i = 0; i < rows.size(); ++i)
  {
    const IndexLists::View groups = rows[i];
    std::vector<Index> row;
    std::copy_if(groups.begin(), groups.end(), std::back_inserter(row),
      [&excluded](Index group) { return !excluded[group]; });
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
}

Index closedChains(const IndexLists& groupsAtEdges, std::vector<char> excluded)
{
  const IndexLists rows = equations(groupsAtEdges);
  excludeLoneGroups(rows, excluded);
  return static_cast<Index>(std::count(excluded.begin(), excluded.end(), 0)) - rank(rows, excluded);
}
}
