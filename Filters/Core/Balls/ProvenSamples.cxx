// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/ProvenSamples.h"

#include "Balls/Crossings.h"
#include "Balls/FarFaces.h"
#include "Balls/PolarBalls.h"
#include "Base/BettiWords.h"
#include "Base/Lists.h"

#include <algorithm>
#include <iterator>

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

/// Adds samples where the crust of right ones is far from the surface. Those with the fewest such places are kept,
/// if the balls still have the same topology.
void bringCrustNear(const ClosedSurface& surface, const SurfaceTree& tree,
  const BoundarySampler& sampler, const PolarBalls& balls, ProvenSamples& result,
  const Execution& execution)
{
  constexpr double wanted = 0.5;        // spacings
  constexpr double most = 0.9 * wanted; // other places of a face may be a little farther
  constexpr int rounds = 5;             // most places are right after one or two
  const auto isAtSharpEdge = [&sampler](
                               const Point& place) { return sampler.isAtSharpEdge(place); };
  BoundarySamples samples = result.samples;
  std::vector<FarFace> faces =
    farFaces(balls, samples.points, tree, most, isAtSharpEdge, execution);
  std::vector<FarFace> best = faces;
  for (int round = 0; round < rounds && !faces.empty(); ++round)
  {
    std::vector<Point> places;
    std::transform(faces.begin(), faces.end(), std::back_inserter(places),
      [](const FarFace& face) { return face.place; });
    if (sampler.add(places, samples) == 0)
    {
      break;
    }
    const Execution part = execution.between(round / double(rounds), (round + 1) / double(rounds));
    const PolarBallsAndSamples made =
      polarBallsAndSamples(positions(samples.points), {}, part, &tree);
    if (made.powerShape != surface.measures.betti)
    {
      break;
    }
    faces = farFaces(made.balls, samples.points, tree, most, isAtSharpEdge, part);
    if (faces.size() < best.size())
    {
      best = faces;
      result.added += count(samples.points) - count(result.samples.points);
      result.samples = samples;
    }
  }
  best.erase(std::remove_if(best.begin(), best.end(),
               [&](const FarFace& face) { return face.distance <= wanted; }),
    best.end());
  if (!best.empty())
  {
    result.warnings.push_back(farFromSurface(best));
  }
}

Warning notEnough(const Betti& made, const Betti& solid, const std::vector<Crossing>& places)
{
  return { "too_few_samples",
    text("The samples give ", inWords(made), ", but the surface has ", inWords(solid), ", and in ",
      places.size(), places.size() == 1 ? " place" : " places",
      " they don't keep inside and outside apart. Take a smaller fineness, or mend the surface "
      "there."),
    count(places), places.empty() ? std::optional<Point>() : places.front().place, true };
}
}

ProvenSamples provenSamples(const ClosedSurface& surface, const SurfaceTree& tree,
  const SamplingOptions& options, Index rounds, const Execution& execution)
{
  BoundarySampler sampler(surface, tree, options, execution.between(0, 0.3));
  ProvenSamples result;
  result.samples = sampler.samples(execution.between(0.3, 0.4));
  result.warnings = result.samples.warnings;
  double done = 0.4;
  while (rounds > 0)
  {
    const double half = done + (1 - done) / 2;
    const PolarBallsAndSamples made = polarBallsAndSamples(
      positions(result.samples.points), {}, execution.between(done, half), &tree);
    if (made.powerShape == surface.measures.betti)
    {
      bringCrustNear(surface, tree, sampler, made.balls, result, execution.between(half, 1));
      break;
    }
    const std::vector<Crossing> places = crossings(made.balls, tree);
    if (result.rounds == rounds || places.empty())
    {
      result.warnings.push_back(notEnough(made.powerShape, surface.measures.betti, places));
      break;
    }
    ++result.rounds;
    done = half + (1 - half) / 4;
    const double between = (half + done) / 2;
    sampler.refine(tooFarApart(places, made.balls), execution.between(half, between));
    result.samples = sampler.samples(execution.between(between, done));
    result.warnings = result.samples.warnings;
  }
  execution.report(1);
  return result;
}
}
