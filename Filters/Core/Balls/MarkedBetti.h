// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_MarkedBetti_h
#define medial_MarkedBetti_h

#include "Base/Tetrahedra.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Are all corners of a simplex marked?
template <typename Simplex>
bool allMarked(const std::vector<char>& marked, const Simplex& corners)
{
  for (const Index v : corners)
  {
    if (!marked[v])
    {
      return false;
    }
  }
  return true;
}

/// Calls body(cell, i) once for each triangle with marked corners: the facet opposite to the cell's
/// corner number i.
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

/// Marks the balls inside the solid. The simplices with these corners are the power shape.
std::vector<char> innerBalls(const std::vector<Side>& sides);

/// Betti numbers of the subcomplex of all simplices of a triangulation whose corners are marked.
/// @param mesh  the whole convex hull, with neighbours
Betti markedBetti(const Tetrahedra& mesh, const std::vector<char>& marked);

/// The same, where the edges of the mesh are known: they take most of the time.
Betti markedBetti(
  const Tetrahedra& mesh, const std::vector<Edge>& edges, const std::vector<char>& marked);
}

#endif
