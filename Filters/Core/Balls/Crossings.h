// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Crossings_h
#define medial_Crossings_h

#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/SurfaceTree.h"

#include <vector>

namespace medial
{
/// Two neighbouring balls of the same side with the surface of the solid between their centres.
struct Crossing
{
  Point place;   ///< of the surface, between the two
  Index smaller; ///< of the two balls
};

/// Where the power diagram contradicts the surface of the solid. The samples are too far apart there: they
/// don't keep both sides apart.
std::vector<Crossing> crossings(
  const PolarBalls& balls, const SurfaceTree& solid, const Execution& execution = {});
}

#endif
