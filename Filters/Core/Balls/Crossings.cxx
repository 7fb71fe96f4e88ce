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
      const auto found = solid.firstMet(balls.balls[a].center, balls.balls[b].center, None);
      if (found)
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
