// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ShapeComplex_h
#define medial_ShapeComplex_h

#include "Base/Lists.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The simplices of a power shape, and which of them are left after collapses.
///
/// A collapse removes a simplex together with one of its faces that is free: a face of no other simplex.
/// That never changes a Betti number. No other change is possible, so what is left has the topology of
/// the shape by construction.
class ShapeComplex
{
public:
  /// All simplices whose corners are marked.
  /// @param mesh    a triangulation, with neighbours
  /// @param marked  for each of its points
  ShapeComplex(const Tetrahedra& mesh, const std::vector<char>& marked);

  // The simplices as they were at first. Numbers are stable.
  std::vector<Tetrahedron> tetrahedra; ///< corners, ascending
  std::vector<Tetrahedron> facets; ///< for each tetrahedron: the triangle opposite to each corner
  std::vector<Triangle> triangles; ///< corners, ascending
  std::vector<Triangle> sides;     ///< for each triangle: the edge opposite to each corner
  std::vector<Edge> edges;         ///< corners, ascending

  bool hasTetrahedron(Index tetrahedron) const { return this->livingTetrahedron[tetrahedron]; }
  bool hasTriangle(Index triangle) const { return this->livingTriangle[triangle]; }
  bool hasEdge(Index edge) const { return this->livingEdge[edge]; }

  /// In how many tetrahedra is a triangle?
  int tetrahedronCount(Index triangle) const;
  /// The only tetrahedron of a triangle; None if it has none or two.
  Index onlyTetrahedron(Index triangle) const;
  /// In how many triangles is an edge?
  Index triangleCount(Index edge) const { return this->trianglesAtEdge[edge]; }
  /// The triangles at an edge. This takes time linear in the number that it had at first.
  std::vector<Index> trianglesAt(Index edge) const;

  // Collapses. False if the face is not free, or one of the two is gone; then nothing changes.
  bool collapseTetrahedron(Index tetrahedron, Index triangle);
  bool collapseTriangle(Index triangle, Index edge);

private:
  void numberTriangles(const Tetrahedra& mesh, const std::vector<char>& marked,
    const EdgeNumbers& meshEdges, const std::vector<Index>& edgeOfMesh);

  IndexLists triangleLists; ///< at each edge, at first
  std::vector<Edge> cells;  ///< the tetrahedra of each triangle, or None
  std::vector<char> livingTetrahedron, livingTriangle, livingEdge;
  std::vector<Index> trianglesAtEdge; ///< how many
};
}

#endif
