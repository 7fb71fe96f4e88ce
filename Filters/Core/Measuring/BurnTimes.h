// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_BurnTimes_h
#define medial_BurnTimes_h

#include "Axis/MedialAxis.h"

#include <vector>

namespace medial
{
/// For each point of an axis, half the width of the sheet there: the time at which the fire of
/// Erosion.h has burnt it, erosion thickness + radius. The radius where a point is in no triangle: a
/// line is as wide as it is thick. Where lines end at a sheet, the fire of the sheet counts.
std::vector<double> burnTimes(const MedialAxis& axis);
}

#endif
