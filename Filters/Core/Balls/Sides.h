// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Sides_h
#define medial_Sides_h

#include "Balls/SideInput.h"
#include "Base/Execution.h"
#include "Base/Frame.h"
#include "Base/SurfaceTree.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// For each ball: does it touch a guard, or is its centre outside the samples' bounding box? The samples
/// cover the whole boundary, so such a ball is outside the solid.
std::vector<char> surelyOutside(const SideInput& input);

/// The side of each ball ([ACK01] section 4).
///
/// Balls that are surely outside are outer; others are on the side that votes tell, if they do. From
/// all these labels spread to the other balls, the most certain label first. Balls that intersect deeply
/// are on the same side; the two poles of a sample are on opposite sides. A ball that no label
/// reaches is outer. A ball in no cell is hidden. Where that contradicts more evidence than it must, cutSides()
/// mends it.
/// @param votes  for each ball: positive outside, negative inside, 0 not known; or empty
/// @throw Aborted
std::vector<Side> sides(
  const SideInput& input, const Execution& execution = {}, const std::vector<Index>& votes = {});

/// The same where the surface of the solid is known: a ball is inner if its centre is inside.
/// @param frame  of the balls; the surface is in world coordinates
std::vector<Side> sidesIn(const SurfaceTree& solid, const Frame& frame, const SideInput& input,
  const Execution& execution = {});
}

#endif
