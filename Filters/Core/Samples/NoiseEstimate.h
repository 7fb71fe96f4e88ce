// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_NoiseEstimate_h
#define medial_NoiseEstimate_h

#include "Base/Execution.h"
#include "Base/Neighbors.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// How far samples scatter about a smooth surface, in local sample spacings: the median over the samples
/// of the residual of a quadric fitted to the 16 nearest other ones. Curvature is no noise, nor are sharp
/// edges as long as most samples are on none. About 0 for clean samples, 0.8 for points of a volume.
/// @return  0 with fewer than 17 points
double noiseEstimate(
  const std::vector<Point>& points, const Neighbors& neighbors, const Execution& execution = {});
}

#endif
