// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_EditableTriangles_h
#define medial_EditableTriangles_h

#include "Base/Lists.h"
#include "Base/Types.h"

#include <deque>
#include <vector>

namespace medial
{
/// The triangles of a closed surface, whose edges can be contracted and flipped as long as the surface
/// stays a manifold with the same topology. It knows no coordinates.
///
/// An edge is looked for at that of its ends with fewer triangles, and a contraction moves the triangles
/// of that end only. So points with very many triangles make nothing slow.
class EditableTriangles
{
public:
  /// @param triangles   changed in place; the corners of one that is gone become None
  /// @param pointCount  larger than every corner
  EditableTriangles(std::vector<Triangle>& triangles, Index pointCount);

  bool isThere(Index triangle) const { return this->triangles[triangle][0] != None; }

  /// The points joined to a point by an edge, ascending.
  std::vector<Index> neighbors(Index point);

  bool hasEdge(Index a, Index b);

  /// The triangle on the other side of the edge opposite to a corner (0, 1, 2); None where there is not
  /// exactly one.
  Index across(Index triangle, int corner);

  /// The corner of that triangle which the edge doesn't have; None where there is no such triangle.
  Index beyond(Index triangle, int corner);

  /// The edge with the end first that is better moved onto the other one, since it has fewer triangles.
  Edge fewerFirst(const Edge& edge);

  /// Moves the first end of an edge onto the second one and drops the edge's two triangles. Refuses where
  /// that would pinch the surface: the ends must share two neighbours and no more (the link
  /// condition), and the piece must not be a tetrahedron.
  /// @return  false if refused
  bool contract(Index goes, Index stays);

  /// Replaces the edge opposite to a corner by the other diagonal of its two triangles: with the corner
  /// b, the triangle (a, b, c) and its neighbour (a, c, d) become (a, b, d) and (b, c, d).
  /// @return  false if refused: there is no such neighbour, or the diagonal is an edge already
  bool flip(Index triangle, int corner);

private:
  std::vector<Index>& around(Index point);

  /// The triangles with both points, ascending.
  std::vector<Index> atEdge(Index a, Index b);

  std::vector<Triangle>& triangles;

  // The triangles at each point: all that are there, maybe repeated, and maybe some that have left since.
  IndexLists before;                    ///< where nothing has changed
  std::vector<Index> numberOfList;      ///< of each point: its place in `lists`, or None
  std::deque<std::vector<Index>> lists; ///< of the points that were asked for
};
}

#endif
