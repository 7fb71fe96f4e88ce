// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PointVolumes_h
#define medial_PointVolumes_h

#include "Axis/MedialAxis.h"

#include <vector>

namespace medial
{
/// For each point of the axis the volume of its ball and of the balls off the axis that follow it, unit
/// of the samples cubed. Where several points have one ball the first one has its volume. Points that
/// no cell uses may have some: what pruning took away.
std::vector<double> pointVolumes(const MedialAxis& axis);
}

#endif
