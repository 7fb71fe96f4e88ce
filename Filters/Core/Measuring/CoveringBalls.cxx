// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/CoveringBalls.h"

#include "Base/Lists.h"

#include <algorithm>
#include <numeric>

namespace medial
{
namespace
{
/// Points that share an edge with each point.
IndexLists linkedPoints(const AxisEdges& edges, Index pointCount)
{
  return listsByKey(pointCount, [&edges](const auto& add) {
    for (const auto& [a, b] : edges.points)
    {
      add(a, b);
      add(b, a);
    }
  });
}
}

// From large balls to small ones each takes the points inside it that no larger one has, and goes on
// from these only: so each point is taken once, and its edges are looked at once.
std::vector<Index> coveringBalls(
  const MedialAxis& axis, const AxisEdges& edges, const Execution& execution)
{
  const Index pointCount = count(axis.points);
  const IndexLists linked = linkedPoints(edges, pointCount);
  std::vector<Index> order(pointCount);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&axis](Index a, Index b) { return axis.radii[a] > axis.radii[b]; });
  std::vector<Index> result(pointCount, None);
  std::vector<Index> inside;
  for (const Index ball : order)
  {
    execution.pollAt(ball);
    const double radius = axis.radii[ball];
    if (result[ball] == None)
    {
      result[ball] = ball;
      inside.push_back(ball);
    }
    while (!inside.empty())
    {
      const Index p = inside.back();
      inside.pop_back();
      for (const Index next : linked[p])
      {
        if (result[next] == None && (axis.points[next] - axis.points[ball]).norm() < radius)
        {
          result[next] = ball;
          inside.push_back(next);
        }
      }
    }
  }
  return result;
}
}
