// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/Crossings.h"

#include "Base/Tetrahedra.h"

#include <optional>

namespace medial
{
std::vector<Crossing> crossings(
  const PolarBalls& balls, const SurfaceTree& solid, const Execution& execution)
{
  const std::vector<Edge> edges = edgeNumbers(balls.triangulation.cells, count(balls.balls)).edges;
  std::vector<std::optional<Crossing>> met(edges.size());
  execution.forEach(count(edges), [&](Index e) {
    const auto& [a, b] = edges[e];
    if (balls.sides[a] == balls.sides[b] && balls.sides[a] != Side::Hidden)
    {
      const Point from = balls.balls[a].center;
      const Point across = balls.balls[b].center - from;
      const auto found = solid.firstMet(from, across, None);
      if (found && (found->point - from).squaredNorm() < across.squaredNorm())
      {
        met[e] = Crossing{ found->point, balls.balls[a].radius < balls.balls[b].radius ? a : b };
      }
    }
  });
  std::vector<Crossing> result;
  for (const std::optional<Crossing>& crossing : met)
  {
    if (crossing)
    {
      result.push_back(*crossing);
    }
  }
  return result;
}
}
