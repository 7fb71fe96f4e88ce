// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CurveForks_h
#define medial_CurveForks_h

#include "Axis/MedialAxis.h"
#include "Base/BallTree.h"
#include "Measuring/Centerline.h"

#include <vector>

namespace medial
{
/// Lets curves that end at the same node end at the same point.
///
/// In a fork the axis is wider than the rods, and a curve may leave the middle. So a curve counts only
/// from where its ball leaves the fork's: the fork is put where the straight continuations of its curves
/// come nearest to each other, and they run there straight, their radii growing or shrinking as before.
/// Curves that are too short for that, or would leave the solid, are shifted instead.
/// @param solid  the balls of the axis
/// @param curves  smoothed() ones; their nodes are points of the axis
void joinAtForks(const MedialAxis& axis, const BallTree& solid, std::vector<Centerline>& curves);
}

#endif
