// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Polygons_h
#define medial_Polygons_h

#include "Base/EdgeTable.h"
#include "Base/Lists.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// For each point the triangles that have it as a corner, ascending.
IndexLists trianglesAtPoints(const std::vector<Triangle>& triangles, Index pointCount);

/// Cuts a convex polygon into a fan of triangles, oriented as it is.
///
/// A diagonal must not be an edge that exists already, or two faces would be glued together along it.
/// Of the fans without such a diagonal it takes the one whose smallest triangle is largest. If there is
/// none, the centroid is appended to `points`, and the triangles are around it. New edges are added to
/// `edges`. Tries at most 32 fans, each in linear time.
/// @param polygon  at least 3 different corners
/// @param edges    with the sides of all polygons
std::vector<Triangle> triangulate(
  const std::vector<Index>& polygon, std::vector<Point>& points, EdgeSet& edges);
}

#endif
