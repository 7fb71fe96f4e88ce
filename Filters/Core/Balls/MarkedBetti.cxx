// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/MarkedBetti.h"

#include "Base/DisjointSets.h"
#include "Base/Lists.h"

#include <algorithm>

// A simplex is in the subcomplex where all its corners are marked. So it is a closed subcomplex of a
// triangulation of a convex hull, and its Betti numbers follow from counting: b0 is the number of its
// pieces, b2 that of the pieces of space around it less one (Alexander duality), and b0 - b1 + b2 is the
// Euler characteristic. All this takes nearly linear time in the number of cells.
namespace medial
{
namespace
{
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

/// The edges with marked corners.
std::vector<Edge> markedEdges(const Tetrahedra& mesh, const std::vector<char>& marked)
{
  const IndexLists upper = listsByKey(count(marked), [&](const auto& add) {
    for (const Tetrahedron& cell : mesh.cells)
    {
      for (const auto& ends : cellEdges)
      {
        const Index a = cell[ends[0]], b = cell[ends[1]];
        if (marked[a] && marked[b])
        {
          add(std::min(a, b), std::max(a, b));
        }
      }
    }
  });
  std::vector<Index> lower(marked.size(), None); // that each upper corner was met with last
  std::vector<Edge> result;
  for (Index a = 0; a < upper.size(); ++a)
  {
    for (const Index b : upper[a])
    {
      if (lower[b] != a)
      {
        lower[b] = a;
        result.push_back({ a, b });
      }
    }
  }
  return result;
}
}

std::vector<char> innerBalls(const std::vector<Side>& sides)
{
  std::vector<char> inner(sides.size());
  std::transform(
    sides.begin(), sides.end(), inner.begin(), [](Side side) { return side == Side::Inner; });
  return inner;
}

Betti markedBetti(
  const Tetrahedra& mesh, const std::vector<Edge>& edges, const std::vector<char>& marked)
{
  DisjointSets pieces(count(marked));
  std::vector<char> used(marked.size(), 0);
  Index tetrahedra = 0, triangles = 0, markedEdges = 0, vertices = 0, b0 = 0;
  for (const Tetrahedron& cell : mesh.cells)
  {
    tetrahedra += allMarked(marked, cell);
    for (const Index v : cell)
    {
      used[v] = marked[v];
    }
  }
  forMarkedTriangles(mesh, marked, [&](Index, int) { ++triangles; });
  for (const Edge& edge : edges)
  {
    if (allMarked(marked, edge))
    {
      ++markedEdges;
      pieces.unite(edge[0], edge[1]);
    }
  }
  for (Index v = 0; v < count(marked); ++v)
  {
    vertices += used[v];
    b0 += used[v] && pieces.find(v) == v;
  }
  const Index b2 = openRestPieces(mesh, marked) - 1;
  return { b0, b0 + b2 - (vertices - markedEdges + triangles - tetrahedra), b2 };
}

Betti markedBetti(const Tetrahedra& mesh, const std::vector<char>& marked)
{
  return markedBetti(mesh, markedEdges(mesh, marked), marked);
}
}
