// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/CrustApproach.h"

#include "Balls/BallsAround.h"
#include "Balls/FarSpots.h"
#include "Base/Lists.h"
#include "Base/Neighbors.h"

#include <algorithm>
#include <array>
#include <utility>

// Added samples change the balls around them only. So they are tried with these balls, which takes hundredths of a
// second, and all balls are made once, to see that the topology stays.
namespace medial
{
namespace
{
class CrustApproach
{
public:
  CrustApproach(const SurfaceTree& theTree, const BoundarySampler& theSampler)
    : tree(theTree)
    , sampler(theSampler)
  {
  }

  /// See bringCrustNear().
  std::vector<FarFace> improve(
    PolarBallsAndSamples& made, BoundarySamples& samples, const Execution& execution) const
  {
    constexpr int rounds = 3;
    std::vector<FarFace> faces = this->farFacesOf(made, samples, execution);
    for (int round = 0; round < rounds && badness(faces)[0] > 0; ++round)
    {
      const Execution part =
        execution.between(round / double(rounds), (round + 1) / double(rounds));
      BoundarySamples more = this->addAround(faces, made.balls, samples, part.between(0, 0));
      // What is left after the first round is the hardest: often other faces become far then.
      if (more.points.size() == samples.points.size() ||
        (round > 0 &&
          badness(this->farFacesAround(faces, made.balls, more, reach, part)) >= badness(faces)))
      {
        break;
      }
      PolarBallsAndSamples later =
        polarBallsAndSamples(positions(more.points), {}, part, &this->tree);
      if (later.powerShape != made.powerShape)
      {
        break;
      }
      std::vector<FarFace> left = this->farFacesOf(later, more, part);
      if (badness(left) >= badness(faces))
      {
        break;
      }
      faces = std::move(left);
      made = std::move(later);
      samples = std::move(more);
    }
    faces.erase(std::remove_if(faces.begin(), faces.end(),
                  [](const FarFace& face) { return face.distance <= told; }),
      faces.end());
    return faces;
  }

private:
  static constexpr double told = 0.5;           // spacings
  static constexpr double wanted = 0.96 * told; // other places of a face may be a little farther
  static constexpr double most = 0.9 * wanted;  // nearly as far
  static constexpr double reach = 8;            // spacings: the balls there change with a sample
  static constexpr double next = 3;             // spacings: where it is tried for a face

  static std::array<Index, 2> badness(const std::vector<FarFace>& faces)
  {
    return FarSpots::badness(faces, wanted);
  }

  /// The crust cuts sharp edges off.
  auto sharpEdges() const
  {
    return [this](const Point& place, double spacing) {
      return this->sampler.isAtSharpEdge(place, spacing);
    };
  }

  std::vector<FarFace> farFacesOf(const PolarBallsAndSamples& made, const BoundarySamples& samples,
    const Execution& execution) const
  {
    return farFaces(
      made.balls, samples.points, this->tree, most, { this->sharpEdges(), {} }, execution);
  }

  /// The samples with those added around far faces, again and again where faces are still far, that leave the fewest by
  /// the balls around them; in each spot on its own, as others don't reach it.
  BoundarySamples addAround(const std::vector<FarFace>& faces, const PolarBalls& balls,
    const BoundarySamples& samples, const Execution& execution) const
  {
    constexpr int rounds = 24; // most places are right after one or two
    // Samples as even as they can be; but some places need one that is nearer to others. Measured on 6 meshes.
    constexpr std::array<double, 5> aparts{ 0.5, 0.3, 0.2, 0.1, 0.05 };
    FarSpots spots(faces, wanted, reach);
    for (int round = 0; round < rounds; ++round)
    {
      const std::vector<FarFace> unsolved = spots.unsolved();
      if (unsolved.empty())
      {
        break;
      }
      BoundarySamples tried = spots.with(samples, &FarSpot::tried);
      const Index before = count(tried.points);
      const std::vector<FarFace> left = spots.left();
      const bool isNew =
        this->sampler.add(placesOf(left), tried, aparts[round % aparts.size()]) > 0;
      spots.add(tried, before);
      spots.judge(isNew ? this->farFacesAround(unsolved, balls, tried, next, execution) : left);
    }
    return spots.with(samples, &FarSpot::best);
  }

  /// The far faces around those that were far.
  /// @param balls     of the samples before some were added
  /// @param distance  so far around them, in spacings
  std::vector<FarFace> farFacesAround(const std::vector<FarFace>& faces, const PolarBalls& balls,
    const BoundarySamples& samples, double distance, const Execution& execution) const
  {
    const std::vector<Point> all = positions(samples.points);
    const Neighbors neighbors(all);
    std::vector<Index> core;
    for (const FarFace& face : faces)
    {
      const std::vector<Index> near = neighbors.within(face.place, reach * face.spacing);
      core.insert(core.end(), near.begin(), near.end());
    }
    sortUnique(core);
    const BallsAround made = ballsAround(core, balls, all, neighbors, this->tree, execution);
    std::vector<SurfacePoint> points;
    for (const Index s : made.samples)
    {
      points.push_back(samples.points[s]);
    }
    const std::vector<Point> places = placesOf(faces);
    const Neighbors farPlaces(places);
    const auto isElsewhere = [&](const Point& place) {
      const Index nearest = farPlaces.nearestOne(place);
      return nearest == None ||
        (places[nearest] - place).norm() > distance * faces[nearest].spacing;
    };
    return farFaces(
      made.balls, points, this->tree, most, { this->sharpEdges(), isElsewhere }, execution);
  }

  const SurfaceTree& tree;
  const BoundarySampler& sampler;
};
}

std::vector<FarFace> bringCrustNear(const SurfaceTree& tree, const BoundarySampler& sampler,
  PolarBallsAndSamples& made, BoundarySamples& samples, const Execution& execution)
{
  return CrustApproach(tree, sampler).improve(made, samples, execution);
}
}
