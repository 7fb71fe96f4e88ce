// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SurfaceGaps_h
#define medial_SurfaceGaps_h

#include "Balls/SampleEvidence.h"
#include "Base/Types.h"
#include "Base/Warnings.h"

#include <vector>

namespace medial
{
/// Warns ("gaps") where the surface crosses a place without samples: the solid's cap there is
/// invented. Where the power cells of an inner and an outer ball meet, the surface runs through the
/// circle in which the two spheres meet, and no sample is within both. On an evenly sampled surface these
/// circles are smaller than the spacing.
/// @param contested  for each ball; such balls are left out, because their side may be wrong
Warnings surfaceGaps(const SampleEvidence& evidence, const std::vector<char>& contested);
}

#endif
