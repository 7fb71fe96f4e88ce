// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CurveRadii_h
#define medial_CurveRadii_h

#include "Axis/MedialAxis.h"
#include "Base/BallTree.h"
#include "Base/Execution.h"
#include "Measuring/Centerline.h"

#include <vector>

namespace medial
{
/// Lets the radii of curves agree with the axis: each is to be that of the largest ball inside the solid about its point.
///
/// Curves are smoothed, and straight in forks, where their radii go on from the rods. So they may have left the axis,
/// and their balls may be too small, or stick out. Where a maximal ball of radius r is at a distance d, the ball about
/// the point has a radius between r - d and r + d. The nearer the axis, the less is left to choose.
/// @param solid  the balls of the axis
void bindRadii(const MedialAxis& axis, const BallTree& solid, std::vector<Centerline>& curves,
  const Execution& execution = {});
}

#endif
