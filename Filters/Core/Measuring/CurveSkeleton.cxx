// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/CurveSkeleton.h"

#include "Base/Lists.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

namespace medial
{
namespace
{
/// Takes triangles away until none is left. Invariant: `sides` counts the living triangles of each
/// edge, and each living edge that has one is in the queue.
class TriangleCollapse
{
public:
  TriangleCollapse(const MedialAxis& axis, const AxisEdges& axisEdges,
    const std::vector<double>& times, const std::vector<char>& counts)
    : edges(axisEdges)
    , isAlive(counts)
    , isGone(edges.points.size(), 0)
    , left(static_cast<Index>(std::count(counts.begin(), counts.end(), 1)))
  {
    for (Index edge = 0; edge < count(this->edges.points); ++edge)
    {
      const auto [a, b] = this->edges.points[edge];
      const IndexLists::View at = this->edges.triangles[edge];
      this->earliest.push_back(times[a] + times[b] - (axis.points[a] - axis.points[b]).norm());
      this->sides.push_back(static_cast<Index>(
        std::count_if(at.begin(), at.end(), [&counts](Index t) { return counts[t] != 0; })));
      this->isGone[edge] = at.size() > 0 && this->sides[edge] == 0;
      this->offer(edge);
    }
  }

  Index trianglesLeft() const { return this->left; }
  bool isTriangleLeft(Index triangle) const { return this->isAlive[triangle] != 0; }

  /// Goes on until no edge has one triangle alone.
  void collapse(const Execution& execution)
  {
    for (Index step = 0; !this->queue.empty(); ++step)
    {
      execution.pollAt(step);
      const Index edge = this->queue.top().second;
      this->queue.pop();
      if (this->sides[edge] == 1)
      {
        const IndexLists::View all = this->edges.triangles[edge];
        this->isGone[edge] = 1;
        this->remove(
          *std::find_if(all.begin(), all.end(), [&](Index t) { return this->isAlive[t] != 0; }));
      }
    }
  }

  void remove(Index triangle)
  {
    this->isAlive[triangle] = 0;
    --this->left;
    for (const Index edge : this->edges.ofTriangle[triangle])
    {
      --this->sides[edge];
      this->offer(edge);
    }
  }

  std::vector<Edge> edgesLeft() const
  {
    std::vector<Edge> result;
    for (Index edge = 0; edge < count(this->edges.points); ++edge)
    {
      if (!this->isGone[edge])
      {
        result.push_back(this->edges.points[edge]);
      }
    }
    return result;
  }

private:
  void offer(Index edge)
  {
    if (this->sides[edge] == 1 && !this->isGone[edge])
    {
      this->queue.push({ this->earliest[edge], edge });
    }
  }

  using Entry = std::pair<double, Index>;

  const AxisEdges& edges;
  std::vector<char> isAlive;    ///< for each triangle
  std::vector<char> isGone;     ///< for each edge
  std::vector<Index> sides;     ///< for each edge
  std::vector<double> earliest; ///< for each edge twice the earliest time at which it may burn
  Index left;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
};

/// The triangles of an axis, those first that burn last.
std::vector<Index> latestTriangles(const MedialAxis& axis, const std::vector<double>& times)
{
  const std::vector<Triangle>& triangles = axis.cells.triangles;
  const auto begin = [&](Index triangle) {
    const auto [a, b, c] = triangles[triangle];
    return std::min({ times[a], times[b], times[c] });
  };
  std::vector<Index> order(triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](Index a, Index b) { return begin(a) > begin(b); });
  return order;
}
}

CurveSkeleton curveSkeleton(const MedialAxis& axis, const AxisEdges& edges,
  const std::vector<double>& times, const std::vector<char>& counts, const Execution& execution)
{
  TriangleCollapse triangles(axis, edges, times, counts);
  triangles.collapse(execution);
  CurveSkeleton result{ {}, 0 };
  if (triangles.trianglesLeft() > 0)
  {
    for (const Index triangle : latestTriangles(axis, times))
    {
      if (triangles.isTriangleLeft(triangle))
      {
        ++result.openedVoids;
        triangles.remove(triangle);
        triangles.collapse(execution);
      }
    }
  }
  result.edges = triangles.edgesLeft();
  return result;
}
}
