// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_KeptThickness_h
#define medial_KeptThickness_h

#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Takes smoothing back where it makes thin walls and gaps much thinner. It moves each side of them on its own, so
/// that the two come as close as one likes, and no samples tell them apart.
///
/// No point moves by more than a quarter of the thickness there. So all stay at least about half as thick.
/// @param before, smoothed  the same points of a closed surface
/// @param most              what is thicker may move freely
/// @return                  the smoothed points, some of them nearer to where they were
std::vector<Point> withThicknessKept(const std::vector<Point>& before,
  const std::vector<Point>& smoothed, const std::vector<Triangle>& triangles, double most,
  const Execution& execution = {});
}

#endif
