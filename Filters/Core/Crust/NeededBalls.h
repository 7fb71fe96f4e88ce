// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_NeededBalls_h
#define medial_NeededBalls_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Crust/ChangedRegions.h"

#include <vector>

namespace medial
{
/// A region whose topology changes when its removed balls go.
struct ContradictedRegion
{
  ChangedRegion region;
  std::vector<Index>
    needed; ///< removed balls with which the topology stays, few of them; ascending
};

/// Balls with their sides, all in one Frame.
struct LabelledBalls
{
  std::vector<Ball> balls;
  std::vector<char> inner; ///< 1: inside the solid, 0: outside
};

/// The regions whose topology changes without the removed balls, each with a few of the removed balls
/// that keep it.
///
/// A region is looked at alone, by the cells that fill it with and without the removed balls: what is around
/// it is the same, so Betti numbers that differ tell of the region. The regular triangulation of a region's own
/// balls has all cells that fill it. The removed balls are halved in space. If one half keeps the topology, the
/// search goes on in it, and only in the regions that this half changes: with n removed balls and one needed,
/// O(n log n) time. Else both halves have needed balls.
/// @param with, without, removed  as for changedRegions, by the numbers of `balls`
std::vector<ContradictedRegion> contradictedRegions(const LabelledBalls& balls,
  const std::vector<Tetrahedron>& with, const std::vector<Tetrahedron>& without,
  const std::vector<Index>& removed, const Execution& execution);
}

#endif
