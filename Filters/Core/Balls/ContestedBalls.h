// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ContestedBalls_h
#define medial_ContestedBalls_h

#include "Balls/SampleEvidence.h"
#include "Base/Types.h"
#include "Base/Warnings.h"

#include <vector>

namespace medial
{
/// How much speaks for the side that a ball was given, and how much against it.
struct Support
{
  double agreeing = 0;
  double contradicting = 0;
};

/// The support of each ball.
///
/// Balls that intersect deeply should be on one side; the two poles of a sample should be on opposite
/// ones ([ACK01] section 4). Each such pair speaks for both its balls or against both, with the cosine of
/// the angle at which the spheres meet or at which the sample sees its poles. Where the samples are
/// dense nothing contradicts, whatever the shape of the solid.
std::vector<Support> supports(const SampleEvidence& evidence);

/// Is at least a third of what is known of the ball's side against it?
bool isContested(const Support& support);

/// Warns ("contested_sides") where contested balls decide the topology: without the inner ones, or
/// with the outer ones, the power shape has other Betti numbers.
/// @param contested  for each ball
/// @param betti      of the power shape
Warnings contestedTopology(const SampleEvidence& evidence, const std::vector<Support>& supports,
  const std::vector<char>& contested, const Betti& betti);
}

#endif
