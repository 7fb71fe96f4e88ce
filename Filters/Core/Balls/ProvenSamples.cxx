// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/ProvenSamples.h"

#include "Balls/Crossings.h"
#include "Balls/CrustApproach.h"
#include "Balls/PolarBalls.h"
#include "Base/BettiWords.h"
#include "Base/Lists.h"

#include <algorithm>

namespace medial
{
namespace
{
/// Where the crossings are, and the samples of their smaller balls, which are around them.
std::vector<Point> tooFarApart(const std::vector<Crossing>& crossings, const PolarBalls& balls)
{
  std::vector<Point> result;
  std::vector<Index> samples;
  for (const Crossing& crossing : crossings)
  {
    result.push_back(crossing.place);
    const auto own = balls.ballSamples[crossing.smaller];
    samples.insert(samples.end(), own.begin(), own.end());
  }
  sortUnique(samples);
  for (const Index sample : samples)
  {
    result.push_back(balls.samples[sample]);
  }
  return result;
}

Warning farFromSurface(const std::vector<FarFace>& faces)
{
  const FarFace& farthest = *std::max_element(faces.begin(), faces.end(),
    [](const FarFace& a, const FarFace& b) { return a.distance < b.distance; });
  return { "far_surface",
    text("In ", faces.size(), faces.size() == 1 ? " place" : " places",
      " what is made from the samples will be farther than half their spacing from the surface "
      "given: ",
      farthest.distance, " spacings in one of them. Take a smaller fineness if that matters."),
    count(faces), farthest.place, false };
}

Warning notEnough(const Betti& made, const Betti& solid, const std::vector<Crossing>& crossings,
  const std::vector<Detail>& details)
{
  std::optional<Point> place;
  std::string reason;
  if (!details.empty())
  {
    place = details.front().place.position;
    reason = text(" They miss details that are small for their spacing, on ", details.size(),
      details.size() == 1 ? " triangle" : " triangles",
      ": take a smaller spacing, or leave out grains and pores that don't matter.");
  }
  if (!crossings.empty())
  {
    place = crossings.front().place;
    reason += text(" In ", crossings.size(), crossings.size() == 1 ? " place" : " places",
      " they don't keep inside and outside apart: take a smaller spacing or fineness, or mend the "
      "surface there; of an image, smooth it more.");
  }
  return { "too_few_samples",
    text("The samples give ", inWords(made), ", but the surface has ", inWords(solid), ".", reason),
    std::max<Index>(1, count(crossings) + count(details)), place, true };
}

Warning missedDetails(const std::vector<Detail>& details)
{
  return { "missed_details",
    text("The samples miss spikes of the surface, ", details.size(),
      details.size() == 1 ? " triangle" : " triangles",
      " of it, farther than one and a half spacings from all samples. Take a smaller "
      "spacing if they matter."),
    count(details), details.front().place.position, false };
}

/// Samples, again and again where they miss spikes that can be followed.
BoundarySamples samplesWithSpikes(
  BoundarySampler& sampler, Warnings& warnings, const Execution& execution)
{
  constexpr int rounds = 3;
  BoundarySamples result = sampler.samples(execution);
  std::vector<Detail> missed = sampler.spikes(result, execution);
  for (int round = 0; round < rounds && sampler.follow(missed, execution) > 0; ++round)
  {
    result = sampler.samples(execution);
    missed = sampler.spikes(result, execution);
  }
  warnings = result.warnings;
  if (!missed.empty())
  {
    warnings.push_back(missedDetails(missed));
  }
  return result;
}

bool isLimited(const BoundarySamples& samples)
{
  return std::any_of(samples.warnings.begin(), samples.warnings.end(),
    [](const Warning& warning) { return warning.code == "too_many_samples"; });
}
}

ProvenSamples provenSamples(const ClosedSurface& surface, const SurfaceTree& tree,
  const SamplingOptions& options, Index rounds, const Execution& execution)
{
  BoundarySampler sampler(surface, tree, options, execution.between(0, 0.3));
  ProvenSamples result;
  result.samples = samplesWithSpikes(sampler, result.warnings, execution.between(0.3, 0.4));
  double done = 0.4;
  while (true)
  {
    const double half = done + (1 - done) / 2;
    result.balls = polarBallsAndSamples(
      positions(result.samples.points), {}, execution.between(done, half), &tree);
    if (rounds == 0)
    {
      break;
    }
    if (result.balls.powerShape == surface.measures.betti)
    {
      const Index before = count(result.samples.points);
      const std::vector<FarFace> far =
        bringCrustNear(tree, sampler, result.balls, result.samples, execution.between(half, 1));
      result.added = count(result.samples.points) - before;
      if (!far.empty())
      {
        result.warnings.push_back(farFromSurface(far));
      }
      break;
    }
    const std::vector<Crossing> places = crossings(result.balls.balls, tree);
    const std::vector<Detail> details =
      places.empty() ? sampler.hiddenDetails(result.samples) : std::vector<Detail>();
    // Where there is no room for more samples, those of the next round would hardly differ.
    if (result.rounds == rounds || isLimited(result.samples) ||
      (places.empty() && sampler.follow(details) == 0))
    {
      result.warnings.push_back(
        notEnough(result.balls.powerShape, surface.measures.betti, places, details));
      break;
    }
    ++result.rounds;
    done = half + (1 - half) / 4;
    const double between = (half + done) / 2;
    if (!places.empty())
    {
      sampler.refine(tooFarApart(places, result.balls.balls), execution.between(half, between));
    }
    result.samples = samplesWithSpikes(sampler, result.warnings, execution.between(between, done));
  }
  result.balls.balls.normals = normals(result.samples.points);
  execution.report(1);
  return result;
}
}
