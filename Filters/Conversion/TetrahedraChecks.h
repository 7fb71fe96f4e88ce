// SPDX-License-Identifier: BSD-3-Clause
#ifndef TetrahedraChecks_h
#define TetrahedraChecks_h

#include "Balls/PolarBalls.h"

namespace medial
{
/// Does a stage walk from tetrahedron to tetrahedron? What measures doesn't, and reads faster without neighbours.
enum class CellNeighbors
{
  Found,
  LeftOut
};

/// Checks that the balls' tetrahedra are one triangulation, and finds their neighbours on request: each triangle has
/// one tetrahedron or two; these are oriented alike, and positively; the triangles with one, the hull, form a sphere
/// of balls that are not inside. That they are the regular triangulation isn't checked: it would cost as much as to make it.
/// @param moved     a centre may be so far from where it was when the cells were found
/// @param movedFar  and by this share of its distance from the samples
/// @throw InvalidInput  the same with neighbours and without
void checkTetrahedra(PolarBalls& balls, double moved, double movedFar, CellNeighbors neighbors);
}

#endif
