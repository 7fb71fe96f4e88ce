// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CoveringBalls_h
#define medial_CoveringBalls_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Base/Execution.h"

#include <vector>

namespace medial
{
/// For each point of the axis the centre of the largest maximal ball that contains it, of those that are
/// reached from there along edges inside them: how thick the solid is there, at its rims too. Of equal
/// balls the lowest point. Takes O(n log n) time.
std::vector<Index> coveringBalls(
  const MedialAxis& axis, const AxisEdges& edges, const Execution& execution = {});
}

#endif
