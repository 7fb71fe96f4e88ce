// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CurveSmoothing_h
#define medial_CurveSmoothing_h

#include "Axis/MedialAxis.h"
#include "Measuring/Centerline.h"
#include "Measuring/CurveBranches.h"

#include <vector>

namespace medial
{
/// A branch without the zigzag of its points, which are corners of triangles beside the middle.
///
/// The means of stretches of an eighth of the radius are replaced by local parabolas, fitted along the
/// curve over half a radius to both sides. Parabolas don't shorten bends, as means would: a ring keeps its
/// size. At most 16 stretches to each side count, so the cost is linear.
/// @param times  burnTimes() of the axis
Centerline smoothed(
  const MedialAxis& axis, const std::vector<double>& times, const CurveBranch& branch);
}

#endif
