// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/PowerDiagram.h"

#include "Base/Errors.h"
#include "Base/Frame.h"
#include "Base/Predicates.h"

#include <algorithm>

namespace medial
{
bool isMixed(const PowerDiagram& diagram, const Tetrahedron& cell)
{
  const int inner = diagram.inner[cell[0]] + diagram.inner[cell[1]] + diagram.inner[cell[2]] +
    diagram.inner[cell[3]];
  return inner > 0 && inner < 4;
}

void findVertices(Tetrahedra dual, PowerDiagram& diagram, const Execution& execution,
  const std::vector<Index>& numbersBefore)
{
  const std::vector<Tetrahedron> cellsBefore = std::move(diagram.dual.cells);
  const std::vector<Index> samplesBefore = std::move(diagram.sampleOfVertex);
  const std::vector<Point> verticesBefore = std::move(diagram.vertices);
  diagram.dual = std::move(dual);
  const Index cellCount = count(diagram.dual.cells);
  diagram.sampleOfVertex.assign(cellCount, None);
  diagram.vertices.assign(cellCount, Point::Zero());
  execution.forEach(cellCount, [&](Index c) {
    const Tetrahedron& cell = diagram.dual.cells[c];
    if (!isMixed(diagram, cell))
    {
      return;
    }
    const Index before = numbersBefore.empty() ? None : numbersBefore[c];
    if (before != None && before < count(cellsBefore) && cellsBefore[before] == cell)
    {
      diagram.sampleOfVertex[c] = samplesBefore[before];
      diagram.vertices[c] = verticesBefore[before];
      return;
    }
    // The spheres of the four balls pass through a sample that they share, so it has power zero to
    // each: it is the power vertex. Several tetrahedra share one sample, and only by its number do
    // we know that their vertices are the same; constructed ones would differ by rounding error.
    const Index sample = lowestCommonItem(diagram.samples, cell);
    diagram.sampleOfVertex[c] = sample;
    diagram.vertices[c] = sample != None
      ? diagram.positions[sample]
      : powerCenter({ diagram.balls[cell[0]], diagram.balls[cell[1]], diagram.balls[cell[2]],
                      diagram.balls[cell[3]] },
          constructionError);
  });
  const auto isFinite = [](const Point& p) { return p.allFinite(); };
  if (!std::all_of(diagram.vertices.begin(), diagram.vertices.end(), isFinite))
  {
    throw InvalidInput(
      "the coordinates of the balls are too coarse, a tetrahedron of them is flat: "
      "move the samples nearer to the origin before Polar Balls");
  }
}

BallTree treeOfInnerBalls(const PowerDiagram& diagram)
{
  std::vector<Ball> balls;
  for (std::size_t b = 0; b < diagram.balls.size(); ++b)
  {
    if (diagram.inner[b])
    {
      balls.push_back(diagram.balls[b]);
    }
  }
  return BallTree(balls);
}
}
