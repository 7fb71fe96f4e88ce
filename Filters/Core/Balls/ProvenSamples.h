// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ProvenSamples_h
#define medial_ProvenSamples_h

#include "Balls/PolarBalls.h"
#include "Samples/BoundarySamples.h"

namespace medial
{
/// Samples of a surface, and whether they are enough.
struct ProvenSamples
{
  BoundarySamples samples;
  PolarBallsAndSamples balls; ///< of them; the surface tells the sides
  Index rounds = 0;           ///< how often they were made denser
  Index added = 0;            ///< samples where the crust was far from the surface
  Warnings warnings;          ///< those of the samples; and, if they are not enough, where not
};

/// Samples a closed surface until the power shape of the samples' balls has the Betti numbers of the
/// solid. As long as it doesn't, the spacing is halved where the power diagram contradicts the surface. Then
/// samples are added where the power crust is farther from the surface than half a spacing, and not at a sharp edge.
/// @param rounds  how often at most; 0: only the balls are made, and nothing is checked
/// @throw InvalidInput  an option is out of range
/// @throw Aborted
ProvenSamples provenSamples(const ClosedSurface& surface, const SurfaceTree& tree,
  const SamplingOptions& options, Index rounds, const Execution& execution = {});
}

#endif
