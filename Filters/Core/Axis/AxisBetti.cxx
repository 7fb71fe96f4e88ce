// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/AxisBetti.h"

#include "Axis/AxisEdges.h"
#include "Axis/ClosedChains.h"
#include "Base/DisjointSets.h"
#include "Base/Lists.h"

#include <algorithm>
#include <vector>

namespace medial
{
namespace
{
Index highestPoint(const AxisCells& cells)
{
  Index highest = None;
  for (Index cell = 0; cell < cells.size(); ++cell)
  {
    forPoints(cells, cell, [&highest](Index p) { highest = std::max(highest, p); });
  }
  return highest;
}

/// How many points cells use, and into how many connected pieces these fall.
struct PointCounts
{
  Index points = 0, pieces = 0;
};

PointCounts pointCounts(const AxisCells& cells, const AxisEdges& edges)
{
  const Index end = highestPoint(cells) + 1;
  DisjointSets pieces(end);
  std::vector<char> isUsed(end, 0);
  for (const Edge& edge : edges.points)
  {
    pieces.unite(edge[0], edge[1]);
    isUsed[edge[0]] = isUsed[edge[1]] = 1;
  }
  for (const Index vertex : cells.vertices)
  {
    isUsed[vertex] = 1;
  }
  PointCounts result;
  for (Index p = 0; p < end; ++p)
  {
    result.points += isUsed[p];
    result.pieces += isUsed[p] && pieces.find(p) == p;
  }
  return result;
}

/// The number of voids. Groups are triangles joined over edges with exactly two.
Index voids(const AxisCells& cells, const AxisEdges& edges)
{
  const Index triangleCount = count(cells.triangles);
  DisjointSets joined(triangleCount);
  const auto forEdgesWith = [&edges](const auto& accept, const auto& body) {
    for (Index e = 0; e < edges.triangles.size(); ++e)
    {
      if (accept(edges.triangles[e].size()))
      {
        body(edges.triangles[e]);
      }
    }
  };
  forEdgesWith([](Index triangles) { return triangles == 2; },
    [&joined](IndexLists::View at) { joined.unite(at[0], at[1]); });
  std::vector<Index> groupOf(triangleCount);
  Index groupCount = 0;
  for (Index t = 0; t < triangleCount; ++t)
  {
    const Index first = joined.find(t); // the lowest triangle of the group
    groupOf[t] = first == t ? groupCount++ : groupOf[first];
  }
  std::vector<char> hasBorder(groupCount, 0);
  forEdgesWith([](Index triangles) { return triangles == 1; },
    [&](IndexLists::View at) { hasBorder[groupOf[at[0]]] = 1; });
  IndexLists groupsAtEdges;
  forEdgesWith([](Index triangles) { return triangles > 2; },
    [&](IndexLists::View at) {
      for (const Index t : at)
      {
        groupsAtEdges.items.push_back(groupOf[t]);
      }
      groupsAtEdges.close();
    });
  return closedChains(groupsAtEdges, std::move(hasBorder));
}
}

Betti bettiNumbers(const AxisCells& cells)
{
  const AxisEdges edges = axisEdges(cells);
  const PointCounts counts = pointCounts(cells, edges);
  const Index euler = counts.points - count(edges.points) + count(cells.triangles);
  const Index b0 = counts.pieces, b2 = voids(cells, edges);
  return { b0, b0 + b2 - euler, b2 };
}
}
