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
/// @param made     the balls of the samples, with the topology of the solid, before and after
/// @return  the faces that stay farther
/// @throw Aborted
std::vector<FarFace> bringCrustNear(const SurfaceTree& tree, const BoundarySampler& sampler,
  PolarBallsAndSamples& made, BoundarySamples& samples, const Execution& execution = {});
}

#endif
