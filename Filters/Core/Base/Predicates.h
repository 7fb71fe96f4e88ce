// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Predicates_h
#define medial_Predicates_h

#include "Base/Types.h"

namespace medial
{
/// The side of the plane through a, b, c on which d lies: 1 if a, b, c are counter-clockwise seen from
/// d, -1 on the other side, 0 in the plane. Exact.
int orientation(const Point& a, const Point& b, const Point& c, const Point& d);

/// The point with the same power |x - center|^2 - radius^2 to four balls.
///
/// It solves three linear equations by Cramer's rule. First in doubles, with a bound of the rounding
/// error; if the error may exceed `tolerance`, as for flat tetrahedra, in long doubles, with a bound
/// again; and if that is not enough, exactly, rounded once at the end. Nearly all
/// points are found by the first step; the last one is tens of times slower.
/// @return  not finite if the centres are in one plane (exactly)
Point powerCenter(const std::array<Ball, 4>& balls, double tolerance);

/// The ball through four points, as `powerCenter`.
Ball circumsphere(const std::array<Point, 4>& points, double tolerance);
}

#endif
