// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Midpoints_h
#define medial_Midpoints_h

#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Places for the vertices that mergeVertices adds in the middle of sides: each at least half of
/// `coincident` away from every other vertex, as the vertices that were given are.
///
/// A side's middle may be taken: sides that lead from two merged vertices to a common neighbour have
/// the same middle, and where vertices crowd another one may lie there. Then the vertex gets the
/// first free place around it. What the vertices belong to is not touched.
/// @param points  of the vertices given, in a frame
/// @param merged  for each of them: is it no longer there?
/// @param sides   the ends of the side that each new vertex splits; numbered on from the points, an end
///                may be a new vertex before it
std::vector<Point> midpointPlaces(const std::vector<Point>& points, const std::vector<char>& merged,
  const std::vector<Edge>& sides);
}

#endif
