// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/Crossings.h"

#include "Base/Tetrahedra.h"

#include <optional>

namespace medial
{
std::vector<Point> crossings(
  const PolarBalls& balls, const SurfaceTree& solid, const Execution& execution)
{
  const std::vector<Edge> edges = edgeNumbers(balls.cells, count(balls.balls)).edges;
  std::vector<std::optional<Point>> met(edges.size());
  execution.forEach(count(edges), [&](Index e) {
    const auto& [a, b] = edges[e];
    if (balls.sides[a] == balls.sides[b] && balls.sides[a] != Side::Hidden)
    {
      const Point from = balls.balls[a].center;
      const Point across = balls.balls[b].center - from;
      const auto found = solid.firstMet(from, across, None);
      if (found && (found->point - from).squaredNorm() < across.squaredNorm())
      {
        met[e] = found->point;
      }
    }
  });
  std::vector<Point> result;
  for (const std::optional<Point>& place : met)
  {
    if (place)
    {
      result.push_back(*place);
    }
  }
  return result;
}
}
