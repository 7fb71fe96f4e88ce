// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CrustApproach_h
#define medial_CrustApproach_h

#include "Balls/FarFaces.h"
#include "Balls/PolarBalls.h"
#include "Samples/BoundarySamples.h"

#include <vector>

namespace medial
{
/// Adds samples where the power crust is farther than half a spacing from the surface, and not at a sharp edge. They
/// are kept if the balls still have the topology of the solid, and fewer such places.
/// @param tree     of the surface
/// @param sampler  made the samples
/// @param solid    its Betti numbers
/// @param balls    of the samples before; they have these Betti numbers
/// @return  the faces that stay farther
/// @throw Aborted
std::vector<FarFace> bringCrustNear(const SurfaceTree& tree, const BoundarySampler& sampler,
  const Betti& solid, const PolarBalls& balls, BoundarySamples& samples,
  const Execution& execution = {});
}

#endif
