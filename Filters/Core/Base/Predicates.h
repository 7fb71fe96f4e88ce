// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Predicates_h
#define medial_Predicates_h

#include "Base/Types.h"

namespace medial
{
/// On which side of the plane through a, b, c is d: 1 where a, b, c are counter-clockwise seen from
/// it, -1 on the other side, 0 in the plane. Exact.
int orientation(const Point& a, const Point& b, const Point& c, const Point& d);

/// The point with the same power |x - center|^2 - radius^2 to four balls.
///
/// Constructed in doubles; where their rounding could move it by more than `tolerance` (flat
/// tetrahedra), in longer numbers, and at last in exact rationals, rounded once.
/// @return  not finite where the centres are in one plane (exactly)
Point powerCenter(const std::array<Ball, 4>& balls, double tolerance);

/// The ball through four points, as `powerCenter`.
Ball circumsphere(const std::array<Point, 4>& points, double tolerance);
}

#endif
