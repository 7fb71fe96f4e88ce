// SPDX-License-Identifier: BSD-3-Clause
#include "PowerShape.h"

#include "DisjointSets.h"

#include <algorithm>

namespace medial
{
namespace
{
bool allInner(const std::vector<Side>& sides, const Index* balls, int n)
{
  return std::all_of(balls, balls + n, [&](Index b) { return sides[b] == Side::Inner; });
}

/// Number of pieces of what is left of space without the power shape: cells, joined across triangles
/// that are not in it. The last set is the space around all cells.
Index outsidePieces(const PowerShape& shape, const std::vector<Side>& sides)
{
  const Tetrahedra& mesh = shape.triangulation;
  const Index around = count(mesh.cells);
  DisjointSets sets(around + 1);
  for (Index c = 0; c < around; ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (!shape.contains[c] && !allInner(sides, facet(mesh.cells[c], i).data(), 3))
      {
        sets.unite(c, mesh.neighbors[c][i] == None ? around : mesh.neighbors[c][i]);
      }
    }
  }
  Index pieces = 1;
  for (Index c = 0; c < around; ++c)
  {
    pieces += !shape.contains[c] && sets.find(c) == c && sets.find(around) != c;
  }
  return pieces;
}

/// Fills the triangles that don't lie between two cells of the shape; returns the number of all.
Index collectTriangles(const std::vector<Side>& sides, PowerShape& shape)
{
  Index total = 0;
  const Tetrahedra& mesh = shape.triangulation;
  for (Index c = 0; c < count(mesh.cells); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      Triangle balls = facet(mesh.cells[c], i);
      const Index n = mesh.neighbors[c][i];
      if ((n != None && n < c) || !allInner(sides, balls.data(), 3))
      {
        continue;
      }
      ++total;
      if (!shape.contains[c] || n == None || !shape.contains[n])
      {
        std::sort(balls.begin(), balls.end());
        shape.triangles.push_back({ balls, { c, n } });
      }
    }
  }
  return total;
}
}

PowerShape powerShape(const PolarBalls& polarBalls, const Execution& execution)
{
  const std::vector<Side>& sides = polarBalls.sides;
  PowerShape shape;
  shape.triangulation = withNeighbors(polarBalls.cells);
  const Tetrahedra& mesh = shape.triangulation;
  execution.report(0.5);
  shape.contains.resize(mesh.cells.size());
  std::transform(mesh.cells.begin(), mesh.cells.end(), shape.contains.begin(),
    [&](const Tetrahedron& cell) { return allInner(sides, cell.data(), 4); });
  const Index tetrahedra =
    static_cast<Index>(std::count(shape.contains.begin(), shape.contains.end(), 1));
  const Index triangles = collectTriangles(sides, shape);

  DisjointSets pieces(count(sides));
  Index vertices = 0, edges = 0, pieceCount = 0;
  for (const Edge& edge : edgeNumbers(mesh.cells, count(sides)).edges)
  {
    if (allInner(sides, edge.data(), 2))
    {
      ++edges;
      pieces.unite(edge[0], edge[1]);
    }
  }
  for (Index b = 0; b < count(sides); ++b)
  {
    vertices += sides[b] == Side::Inner;
    pieceCount += sides[b] == Side::Inner && pieces.find(b) == b;
  }
  const Index voids = outsidePieces(shape, sides) - 1;
  shape.betti = { pieceCount, pieceCount + voids - (vertices - edges + triangles - tetrahedra),
    voids };
  execution.report(1);
  return shape;
}
}
