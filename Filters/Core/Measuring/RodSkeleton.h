// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_RodSkeleton_h
#define medial_RodSkeleton_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Base/Execution.h"

#include <vector>

namespace medial
{
/// The curves along rods. A skeleton of them has the homotopy type of the rods' cells, but for voids.
struct RodSkeleton
{
  std::vector<Edge> edges; ///< pairs of points of the axis
};

/// Burns the sheets of rods to curves, and shortens what sticks out of them.
///
/// The sheets collapse to a CurveSkeleton. Of the edges that are left, dead ends go, the shortest first, if the ball at the tip does not reach farther than
/// three radii from where the end meets others: a rod sticks out of the ball there by its own thickness. Nor may it reach less far than a sample spacing.
/// A piece that is only one line keeps it. Takes O(n log n) time.
/// @param times     burnTimes() of the axis
/// @param inRod     for each triangle: does it count? Lines all do.
/// @param anchor    for each point: must it stay?
/// @param covering  for each point, see CoveringBalls.h
RodSkeleton rodSkeleton(const MedialAxis& axis, const AxisEdges& edges,
  const std::vector<double>& times, const std::vector<char>& inRod, const std::vector<char>& anchor,
  const std::vector<Index>& covering, const Execution& execution = {});
}

#endif
