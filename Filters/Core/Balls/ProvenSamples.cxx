// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/ProvenSamples.h"

#include "Balls/BallsAround.h"
#include "Balls/Crossings.h"
#include "Balls/FarFaces.h"
#include "Balls/PolarBalls.h"
#include "Base/BettiWords.h"
#include "Base/Lists.h"
#include "Base/Neighbors.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

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

/// Brings the power crust of right samples near to the surface.
class CrustApproach
{
public:
  CrustApproach(const SurfaceTree& theTree, const BoundarySampler& theSampler, const Betti& theSolid)
    : tree(theTree)
    , sampler(theSampler)
    , solid(theSolid)
    , isAtSharpEdge([&theSampler](const Point& place, double spacing) {
      // The crust cuts the edge off there.
      return theSampler.isAtSharpEdge(place, spacing);
    })
  {
  }

  /// Adds samples where the crust is far from the surface. They are kept if the balls still have the same topology and
  /// fewer such places.
  void improve(const PolarBalls& balls, ProvenSamples& result, const Execution& execution) const
  {
    constexpr int rounds = 3;
    const Index before = count(result.samples.points);
    std::vector<FarFace> faces =
      farFaces(balls, result.samples.points, this->tree, most, this->isAtSharpEdge, execution);
    PolarBalls latest = balls;
    for (int round = 0; round < rounds && !faces.empty(); ++round)
    {
      const Execution part =
        execution.between(round / double(rounds), (round + 1) / double(rounds));
      BoundarySamples samples = this->addAround(faces, latest, result.samples, part);
      if (samples.points.size() == result.samples.points.size())
      {
        break;
      }
      PolarBallsAndSamples made =
        polarBallsAndSamples(positions(samples.points), {}, part, &this->tree);
      if (made.powerShape != this->solid)
      {
        break;
      }
      const std::vector<FarFace> left =
        farFaces(made.balls, samples.points, this->tree, most, this->isAtSharpEdge, part);
      if (badness(left) >= badness(faces))
      {
        break;
      }
      faces = left;
      latest = std::move(made.balls);
      result.samples = std::move(samples);
    }
    result.added += count(result.samples.points) - before;
    faces.erase(std::remove_if(faces.begin(), faces.end(),
                  [](const FarFace& face) { return face.distance <= wanted; }),
      faces.end());
    if (!faces.empty())
    {
      result.warnings.push_back(farFromSurface(faces));
    }
  }

private:
  static constexpr double wanted = 0.5;        // spacings
  static constexpr double most = 0.9 * wanted; // other places of a face may be a little farther

  /// How many faces are farther than wanted, and how many nearly are.
  static std::array<Index, 2> badness(const std::vector<FarFace>& faces)
  {
    const auto isTooFar = [](const FarFace& face) { return face.distance > wanted; };
    return { static_cast<Index>(std::count_if(faces.begin(), faces.end(), isTooFar)),
      count(faces) };
  }

  /// The samples with those added around far faces, again and again where faces are still far, that leave the fewest by
  /// the balls around them.
  BoundarySamples addAround(const std::vector<FarFace>& faces, const PolarBalls& balls,
    const BoundarySamples& samples, const Execution& execution) const
  {
    constexpr int rounds = 12; // most places are right after one or two
    BoundarySamples best = samples, tried = samples;
    std::vector<FarFace> left = faces;
    std::array<Index, 2> least = badness(faces);
    for (int round = 0; round < rounds && !left.empty(); ++round)
    {
      std::vector<Point> places;
      std::transform(left.begin(), left.end(), std::back_inserter(places),
        [](const FarFace& face) { return face.place; });
      if (this->sampler.add(places, tried) == 0)
      {
        break;
      }
      left = this->farFacesAround(left, balls, tried, execution);
      if (badness(left) < least)
      {
        least = badness(left);
        best = tried;
      }
    }
    return best;
  }

  /// The far faces next to those that were far.
  /// @param balls  of the samples before some were added
  std::vector<FarFace> farFacesAround(const std::vector<FarFace>& faces, const PolarBalls& balls,
    const BoundarySamples& samples, const Execution& execution) const
  {
    constexpr double next = 3, around = 8; // spacings
    const std::vector<Point> all = positions(samples.points);
    const Neighbors neighbors(all);
    std::vector<Index> core;
    for (const FarFace& face : faces)
    {
      const std::vector<Index> near = neighbors.within(face.place, around * face.spacing);
      core.insert(core.end(), near.begin(), near.end());
    }
    sortUnique(core);
    const BallsAround made = ballsAround(core, balls, all, this->tree, execution);
    std::vector<SurfacePoint> points;
    for (const Index s : made.samples)
    {
      points.push_back(samples.points[s]);
    }
    const auto isElsewhere = [&](const Point& place, double spacing) {
      return std::none_of(faces.begin(), faces.end(), [&](const FarFace& face) {
        return (face.place - place).norm() < next * face.spacing;
      }) || this->isAtSharpEdge(place, spacing);
    };
    return farFaces(made.balls, points, this->tree, most, isElsewhere, execution);
  }

  const SurfaceTree& tree;
  const BoundarySampler& sampler;
  Betti solid;
  PlaceTest isAtSharpEdge;
};

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
      CrustApproach(tree, sampler, surface.measures.betti)
        .improve(made.balls, result, execution.between(half, 1));
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
