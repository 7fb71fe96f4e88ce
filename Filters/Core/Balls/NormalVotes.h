// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_NormalVotes_h
#define medial_NormalVotes_h

#include "Balls/DistinctSamples.h"
#include "Balls/Sides.h"
#include "Base/Lists.h"
#include "Base/Types.h"
#include "Base/Warnings.h"

#include <vector>

namespace medial
{
/// What the normals of samples tell of the sides of balls.
struct NormalVotes
{
  /// distinctNormals(), outwards.
  std::vector<Point> normals;

  /// For each ball: how many more of its samples have it in front of their normal than behind it. Positive:
  /// it is outside; negative: inside; 0: not known. Empty where normals are not used at all.
  std::vector<Index> ofBall;

  Warnings warnings; ///< unusable_normals, inverted_normals, unoriented_normals
};

/// For each sample of the input its normal, of length 1. Zero where it has none or counts as another one. Samples that
/// count as one share the sum of their directions.
std::vector<Point> distinctNormals(
  const std::vector<Point>& normals, const DistinctSamples& distinct);

/// Each sample votes for the side of each ball that it lies on. Only directions count.
///
/// A normal that is zero or not finite is no
/// normal. Balls that are surely outside (see sides()) tell what is wrong with all: where most votes say
/// that they are inside, all normals point inwards, and are turned; where the votes disagree, normals
/// have no common orientation, and are not used. Takes linear time.
///
/// @param normals      for each sample of the input, outwards, of any length
/// @param ballSamples  the samples on each ball, by their numbers in the input
/// @throw InvalidInput  there is not one normal for each sample
NormalVotes normalVotes(const std::vector<Point>& normals, const DistinctSamples& distinct,
  const IndexLists& ballSamples, const SideInput& input);

/// The warning "contradicting_normals" where too many samples have a pole on the wrong side of their normal.
/// @param sides  of the balls
Warnings normalWarnings(const NormalVotes& votes, const DistinctSamples& distinct,
  const SideInput& input, const std::vector<Side>& sides);
}

#endif
