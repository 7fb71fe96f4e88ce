// SPDX-License-Identifier: BSD-3-Clause
#include "MedialAxis.h"

#include "AxisEdges.h"
#include "DisjointSets.h"

#include <algorithm>
#include <map>

namespace medial
{
namespace
{
/// Triangles joined over edges with exactly two of them: a closed chain holds all of a patch or none.
struct Patches
{
  std::vector<Index> ofTriangle;
  Index count = 0;
  std::vector<char> dead; ///< has an edge with one triangle: in no closed chain
};

Patches patches(const AxisEdges& edges, Index triangleCount)
{
  DisjointSets sets(triangleCount);
  for (Index e = 0; e < edges.triangles.size(); ++e)
  {
    if (edges.triangles[e].size() == 2)
    {
      sets.unite(edges.triangles[e][0], edges.triangles[e][1]);
    }
  }
  Patches result;
  result.ofTriangle.assign(triangleCount, None);
  for (Index t = 0; t < triangleCount; ++t)
  {
    const Index first = sets.find(t);
    result.ofTriangle[t] = first == t ? result.count++ : result.ofTriangle[first];
  }
  result.dead.assign(result.count, 0);
  for (Index e = 0; e < edges.triangles.size(); ++e)
  {
    if (edges.triangles[e].size() == 1)
    {
      result.dead[result.ofTriangle[edges.triangles[e][0]]] = 1;
    }
  }
  return result;
}

/// The conditions on closed chains: at each edge an even number of these patches.
std::vector<std::vector<Index>> conditions(const AxisEdges& edges, const Patches& patches)
{
  std::vector<std::vector<Index>> rows;
  for (Index e = 0; e < edges.triangles.size(); ++e)
  {
    if (edges.triangles[e].size() < 3)
    {
      continue;
    }
    std::vector<Index> row;
    for (const Index t : edges.triangles[e])
    {
      const Index patch = patches.ofTriangle[t];
      const auto at = std::find(row.begin(), row.end(), patch);
      at == row.end() ? static_cast<void>(row.push_back(patch)) : static_cast<void>(row.erase(at));
    }
    std::sort(row.begin(), row.end());
    rows.push_back(row);
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

/// Patches that can't be in a closed chain because they are alone at an edge, until there is none.
void killLonePatches(const std::vector<std::vector<Index>>& rows, std::vector<char>& dead)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const std::vector<Index>& row : rows)
    {
      Index living = 0, last = None;
      for (const Index patch : row)
      {
        living += !dead[patch];
        last = dead[patch] ? last : patch;
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
    std::copy_if(all.begin(), all.end(), std::back_inserter(row),
      [&dead](Index patch) { return !dead[patch]; });
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

Index closedChains(const AxisEdges& edges, Index triangleCount)
{
  Patches groups = patches(edges, triangleCount);
  const std::vector<std::vector<Index>> rows = conditions(edges, groups);
  killLonePatches(rows, groups.dead);
  const Index living = static_cast<Index>(std::count(groups.dead.begin(), groups.dead.end(), 0));
  return living - rank(rows, groups.dead);
}
}

Betti bettiNumbers(const AxisCells& cells)
{
  const AxisEdges edges = axisEdges(cells);
  Index highest = None;
  for (const Edge& edge : edges.points)
  {
    highest = std::max(highest, edge[1]);
  }
  for (const Index v : cells.vertices)
  {
    highest = std::max(highest, v);
  }
  std::vector<char> used(highest + 1, 0);
  DisjointSets pieces(highest + 1);
  for (const Index v : cells.vertices)
  {
    used[v] = 1;
  }
  for (const Edge& edge : edges.points)
  {
    used[edge[0]] = used[edge[1]] = 1;
    pieces.unite(edge[0], edge[1]);
  }
  Index vertices = 0, b0 = 0;
  for (Index v = 0; v <= highest; ++v)
  {
    vertices += used[v];
    b0 += used[v] && pieces.find(v) == v;
  }
  const Index b2 = closedChains(edges, count(cells.triangles));
  const Index euler = vertices - count(edges.points) + count(cells.triangles);
  return { b0, b0 + b2 - euler, b2 };
}
}
