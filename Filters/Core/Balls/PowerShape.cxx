// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/PowerShape.h"

#include "Base/DisjointSets.h"

#include <algorithm>

// A simplex is in the shape where all its corners are inner balls. So the shape is a closed subcomplex
// of a triangulation of the balls' convex hull, and its Betti numbers follow from counting: b0 is the
// number of its pieces, b2 that of the pieces of space around it less one (Alexander duality), and
// b0 - b1 + b2 is the Euler characteristic. With m balls all this takes nearly linear time in the number
// of cells, which is proportional to m in practice.
namespace medial
{
namespace
{
template <typename Simplex>
bool allMarked(const std::vector<char>& marked, const Simplex& corners)
{
  return std::all_of(corners.begin(), corners.end(), [&](Index v) { return marked[v] != 0; });
}

/// Calls body(cell, i) once for each triangle with marked corners.
template <typename Body>
void forMarkedTriangles(const Tetrahedra& mesh, const std::vector<char>& marked, const Body& body)
{
  for (Index c = 0; c < count(mesh.cells); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      const Index n = mesh.neighbors[c][i];
      if ((n == None || n > c) && allMarked(marked, facet(mesh.cells[c], i)))
      {
        body(c, i);
      }
    }
  }
}

/// Number of pieces of the open rest of space, without the (closed) subcomplex: cells, joined across
/// triangles that are not in it. The last set is the space around all cells.
Index openRestPieces(const Tetrahedra& mesh, const std::vector<char>& marked)
{
  const Index around = count(mesh.cells);
  DisjointSets sets(around + 1);
  std::vector<char> outside(around);
  for (Index c = 0; c < around; ++c)
  {
    outside[c] = !allMarked(marked, mesh.cells[c]);
    for (int i = 0; i < 4; ++i)
    {
      if (outside[c] && !allMarked(marked, facet(mesh.cells[c], i)))
      {
        sets.unite(c, mesh.neighbors[c][i] == None ? around : mesh.neighbors[c][i]);
      }
    }
  }
  Index pieces = 1;
  for (Index c = 0; c < around; ++c)
  {
    pieces += outside[c] && sets.find(c) == c && sets.find(around) != c;
  }
  return pieces;
}
}

Betti markedBetti(const Tetrahedra& mesh, const std::vector<char>& marked)
{
  DisjointSets pieces(count(marked));
  std::vector<char> used(marked.size(), 0);
  Index tetrahedra = 0, triangles = 0, edges = 0, vertices = 0, b0 = 0;
  for (const Tetrahedron& cell : mesh.cells)
  {
    tetrahedra += allMarked(marked, cell);
    for (const Index v : cell)
    {
      used[v] = marked[v];
    }
  }
  forMarkedTriangles(mesh, marked, [&](Index, int) { ++triangles; });
  for (const Edge& edge : edgeNumbers(mesh.cells, count(marked)).edges)
  {
    if (allMarked(marked, edge))
    {
      ++edges;
      pieces.unite(edge[0], edge[1]);
    }
  }
  for (Index v = 0; v < count(marked); ++v)
  {
    vertices += used[v];
    b0 += used[v] && pieces.find(v) == v;
  }
  const Index b2 = openRestPieces(mesh, marked) - 1;
  return { b0, b0 + b2 - (vertices - edges + triangles - tetrahedra), b2 };
}

PowerShape powerShape(const PolarBalls& polarBalls, const Execution& execution)
{
  std::vector<char> inner(polarBalls.sides.size());
  std::transform(polarBalls.sides.begin(), polarBalls.sides.end(), inner.begin(),
    [](Side side) { return side == Side::Inner; });
  PowerShape shape;
  shape.triangulation = withNeighbors(polarBalls.cells);
  const Tetrahedra& mesh = shape.triangulation;
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
  shape.betti = markedBetti(mesh, inner);
  execution.report(1);
  return shape;
}
}
