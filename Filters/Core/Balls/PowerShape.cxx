// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/PowerShape.h"

#include "Balls/MarkedBetti.h"

#include <algorithm>

// A simplex is in the shape where all its corners are inner balls. So the shape is a closed subcomplex of a
// triangulation of the balls' convex hull. With m balls all this takes nearly linear time in the number of
// cells, which is proportional to m in practice.
namespace medial
{
PowerShape powerShape(const PolarBalls& polarBalls, const Execution& execution)
{
  const std::vector<char> inner = innerBalls(polarBalls.sides);
  PowerShape shape;
  const Tetrahedra& mesh = polarBalls.triangulation;
  execution.report(0.5);
  shape.contains.resize(mesh.cells.size());
  std::transform(mesh.cells.begin(), mesh.cells.end(), shape.contains.begin(),
    [&](const Tetrahedron& cell) { return allMarked(inner, cell); });
  forMarkedTriangles(mesh, inner, [&](Index c, int i) {
    const Index n = mesh.neighbors[c][i];
    if (!shape.contains[c] || n == None || !shape.contains[n])
    {
      Triangle balls = facet(mesh.cells[c], i);
      std::sort(balls.begin(), balls.end());
      shape.triangles.push_back({ balls, { c, n } });
    }
  });
  execution.poll();
  shape.betti = markedBetti(mesh, inner);
  execution.report(1);
  return shape;
}
}
