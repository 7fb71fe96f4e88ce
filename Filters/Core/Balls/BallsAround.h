// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_BallsAround_h
#define medial_BallsAround_h

#include "Balls/PolarBalls.h"
#include "Base/MoreNeighbors.h"

#include <vector>

namespace medial
{
/// The polar balls of a few of many samples, as they are among all of them.
struct BallsAround
{
  std::vector<Index> samples; ///< those of `balls`, by their numbers among all
  std::vector<Index> found;   ///< those of them that only a search in the balls has found
  PolarBalls balls;           ///< that pass through a sample of the core
};

/// Makes the balls of a core without those of all samples: from the core, and as many others as it takes
/// until no other sample is within one of these balls.
/// @param core       ascending numbers of samples
/// @param before     balls of the first of the samples: much the same ones, so that few samples have to be found
/// @param neighbors  of the samples
/// @param solid      tells the sides
/// @param likely     more samples that may be on the balls, as those found before: then fewer searches are needed
/// @throw Aborted
BallsAround ballsAround(const std::vector<Index>& core, const PolarBalls& before,
  const std::vector<Point>& samples, const MoreNeighbors& neighbors, const SurfaceTree& solid,
  const Execution& execution = {}, const std::vector<Index>& likely = {});
}

#endif
