// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Crossings_h
#define medial_Crossings_h

#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/SurfaceTree.h"

#include <vector>

namespace medial
{
/// Where the power diagram contradicts the surface of the solid: neighbouring balls of the same side with the
/// surface between their centres. The samples are too far apart there: they don't keep both sides
/// apart.
struct Crossing
{
  Point place;   ///< of the surface, between the two
  Index smaller; ///< of the two balls
};

std::vector<Crossing> crossings(
  const PolarBalls& balls, const SurfaceTree& solid, const Execution& execution = {});
}

#endif
