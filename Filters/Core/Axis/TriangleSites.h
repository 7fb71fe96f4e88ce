// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_TriangleSites_h
#define medial_TriangleSites_h

#include "Balls/PolarBalls.h"
#include "Base/Types.h"

#include <optional>

namespace medial
{
// Where the spheres of three balls meet: in a point on each side of the triangle of their centres, or
// nowhere. Both functions look at the side from which the centres are counter-clockwise.

/// The lowest sample that three balls share on this side, or None.
Index sharedSample(const PolarBalls& polarBalls, const Triangle& balls);

/// Where the spheres meet on this side, if they do.
/// @param a, b, c  in a frame
std::optional<Point> boundaryIntersection(const Ball& a, const Ball& b, const Ball& c);
}

#endif
