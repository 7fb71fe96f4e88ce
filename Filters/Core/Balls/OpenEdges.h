// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_OpenEdges_h
#define medial_OpenEdges_h

#include "Base/Lists.h"
#include "Base/Types.h"
#include "Base/Warnings.h"

#include <vector>

namespace medial
{
/// The edges that exactly one polygon has, each with its lower point first, ascending. A surface
/// without any encloses a solid.
///
/// Ids decide: points of which one is noted as a duplicate of the other are the same, so triangles
/// that don't share their points, as in a .stl file, are no openings. O(n log n) in the corners.
/// @param polygons     the points of each, in order around it
/// @param duplicateOf  for each point another one that is the same, or None
std::vector<Edge> openEdges(const IndexLists& polygons, const std::vector<Index>& duplicateOf);

/// `open_surface`, if there are open edges. It does not doubt the solid: the points may still be dense
/// everywhere, as where two patches were not sewn together. Whether a gap is so wide that its closing is
/// invented shows in the surface.
/// @param points  of the polygons
Warnings openSurfaceWarnings(const IndexLists& polygons, const std::vector<Index>& duplicateOf,
  const std::vector<Point>& points);
}

#endif
