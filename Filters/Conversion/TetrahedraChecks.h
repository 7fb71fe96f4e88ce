// SPDX-License-Identifier: BSD-3-Clause
#ifndef TetrahedraChecks_h
#define TetrahedraChecks_h

#include "Balls/PolarBalls.h"

namespace medial
{
/// Finds the neighbours of the balls' tetrahedra, and checks that these are one triangulation: each triangle has one or two; neighbours
/// are oriented alike, and positively; the triangles with one, the hull, form a sphere of balls that are
/// not inside. That they are the regular triangulation isn't checked: it would cost as much as to make it.
/// @param moved     a centre may be so far from where it was when the cells were found
/// @param movedFar  and by this share of its distance from the samples
/// @throw InvalidInput
void checkTetrahedra(PolarBalls& balls, double moved, double movedFar);
}

#endif
