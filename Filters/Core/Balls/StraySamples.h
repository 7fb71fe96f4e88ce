// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_StraySamples_h
#define medial_StraySamples_h

#include "Balls/SampleEvidence.h"
#include "Base/Neighbors.h"
#include "Base/Types.h"
#include "Base/Warnings.h"

#include <vector>

namespace medial
{
/// Warnings about samples that seem to be on no surface:
///
/// - "interior_samples": even their larger polar ball is about as small as the spacing, so that they
///   are among samples on all sides, and they are sparser than the others;
/// - "volume_samples": many samples have such small balls, as the points of a volume have;
/// - "one_sided_samples": many samples see their two poles in opposite directions, but both are inside
///   or both outside;
/// - "lost_surface": both poles are inside or both outside, and so are those of all samples around: a thin part or gap
///   is not there;
/// - "isolated_samples": their nearest sample is several of its own spacings away; one and a half are
///   enough if their two balls are both inside or both outside;
/// - "clustered_samples": their nearest sample is far nearer than the spacing.
///
/// @param neighbors  of the samples
/// @param nearest  the sample nearest to each one
Warnings straySamples(
  const SampleEvidence& evidence, const Neighbors& neighbors, const std::vector<Index>& nearest);
}

#endif
