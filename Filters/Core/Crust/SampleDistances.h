// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SampleDistances_h
#define medial_SampleDistances_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Crust/CrustSurface.h"

#include <vector>

namespace medial
{
/// How far the samples are from a surface, in their unit: what pruning has moved.
struct SampleDistances
{
  double percentile99 = 0; ///< 99 % of the samples are at most this far away
  double largest = 0;
};

/// Of samples that are points of the surface it is 0, without a search. Of the others it is that to the triangles
/// at the three points of the surface that are nearest to it: never too small. O(n log n) for n triangles.
SampleDistances sampleDistances(
  const std::vector<Point>& samples, const CrustSurface& surface, const Execution& execution = {});
}

#endif
