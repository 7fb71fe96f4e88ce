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
/// Bit i: corner i of the cell is marked.
unsigned markedCorners(const std::vector<char>& marked, const Tetrahedron& cell)
{
  unsigned result = 0;
  for (unsigned i = 0; i < 4; ++i)
  {
    result |= (marked[cell[i]] ? 1U : 0U) << i;
  }
  return result;
}

/// Is the facet opposite to corner i marked?
bool isFacetMarked(unsigned corners, int i)
{
  return (corners | 1U << i) == 15;
}

/// What is counted of cells and their facets.
struct CellCounts
{
  Index tetrahedra = 0, triangles = 0; ///< marked ones
  Index restPieces = 0; ///< of the open rest of space, without the (closed) subcomplex
};

/// Joins cells across triangles that are not marked. The last set is the space around all cells.
CellCounts cellCounts(const Tetrahedra& mesh, const std::vector<char>& marked)
{
  CellCounts result;
  const Index around = count(mesh.cells);
  DisjointSets sets(around + 1);
  for (Index c = 0; c < around; ++c)
  {
    const unsigned corners = markedCorners(marked, mesh.cells[c]);
    result.tetrahedra += corners == 15;
    for (int i = 0; i < 4; ++i)
    {
      const Index n = mesh.neighbors[c][i];
      if (n != None && n < c)
      {
        continue; // this triangle was met there
      }
      if (isFacetMarked(corners, i))
      {
        ++result.triangles;
      }
      else
      {
        sets.unite(c, n == None ? around : n);
      }
    }
  }
  for (Index c = 0; c <= around; ++c)
  {
    result.restPieces += sets.find(c) == c;
  }
  result.restPieces -= result.tetrahedra; // each is alone: all of its triangles are marked
  return result;
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
  Index markedEdges = 0, vertices = 0, b0 = 0;
  for (const Tetrahedron& cell : mesh.cells)
  {
    for (const Index v : cell)
    {
      used[v] = marked[v];
    }
  }
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
  const CellCounts cells = cellCounts(mesh, marked);
  const Index b2 = cells.restPieces - 1;
  return { b0, b0 + b2 - (vertices - markedEdges + cells.triangles - cells.tetrahedra), b2 };
}

Betti markedBetti(const Tetrahedra& mesh, const std::vector<char>& marked)
{
  return markedBetti(mesh, markedEdges(mesh, marked), marked);
}
}
