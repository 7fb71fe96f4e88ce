// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Twigs_h
#define medial_Twigs_h

#include "Axis/MedialAxis.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Edges of a graph on the points of an axis without its twigs, in their order.
///
/// The graph burns from its free ends, at each beginning with the radius. The fire that comes last to a
/// point goes on; what the others have burnt are twigs with this point as root. A twig goes if its
/// longest path stays within the sheet at its root: if none of its balls reaches farther from the
/// root than half the width of the sheet (burn time) + a radius. So what goes sticks out of a rod by less
/// than its radius; on a plate, it ends where the plate does. Loops stay. A tree keeps the path on
/// which its last fires meet.
///
/// Where a rod is cut off straight, its axis ends in a cone, all of whose twigs are alike. So a path ends at
/// the point from which its end would go as a twig, if another one that goes sticks out at least half as far.
///
/// Takes O(n log n).
/// @param times  burnTimes() of the axis
std::vector<Edge> withoutTwigs(const MedialAxis& axis, const std::vector<double>& times,
  const std::vector<Edge>& edges, const Execution& execution = {});
}

#endif
