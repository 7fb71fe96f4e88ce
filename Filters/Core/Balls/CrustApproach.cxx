// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/CrustApproach.h"

#include "Balls/BallsAround.h"
#include "Balls/FarSpots.h"
#include "Base/Lists.h"
#include "Base/MoreNeighbors.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

// Added samples change the balls around them only. So they are tried with these balls, which takes hundredths of a
// second. All balls are made once, with the last samples, to see that the topology stays.
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
    std::vector<FarFace> faces = this->farFacesOf(made, samples, execution.between(0, 0.1));
    std::vector<BoundarySamples> better =
      this->betterSamples(faces, made.balls, samples, execution.between(0.1, 0.4));
    for (; !better.empty(); better.pop_back())
    {
      const Execution part = execution.between(0.4, 1);
      PolarBallsAndSamples later =
        polarBallsAndSamples(positions(better.back().points), {}, part, &this->tree);
      if (later.powerShape != made.powerShape)
      {
        continue;
      }
      std::vector<FarFace> left = this->farFacesOf(later, better.back(), part);
      if (badness(left) < badness(faces))
      {
        faces = std::move(left);
        made = std::move(later);
        samples = std::move(better.back());
        break;
      }
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
  static constexpr double margin = 3; // spacings: so far around faces their balls are made

  /// Samples with which fewer faces are far, by the balls around them; the best last.
  std::vector<BoundarySamples> betterSamples(const std::vector<FarFace>& faces,
    const PolarBalls& balls, const BoundarySamples& samples, const Execution& execution) const
  {
    constexpr int rounds = 3;
    const std::vector<Point> places = positions(samples.points);
    const Neighbors known(places);
    std::vector<Index> onBalls;
    std::vector<BoundarySamples> result;
    std::vector<FarFace> left = faces, changed = faces; // all that were far once
    for (int round = 0; round < rounds && badness(left)[0] > 0; ++round)
    {
      const BoundarySamples& last = result.empty() ? samples : result.back();
      BoundarySamples more = this->addAround(left, balls, last, known, onBalls, execution);
      if (more.points.size() == last.points.size())
      {
        break;
      }
      // What is left after the first round is the hardest: often other faces become far then.
      std::vector<FarFace> now =
        this->farFacesAround(changed, balls, more, known, onBalls, reach, execution);
      if (badness(now) >= badness(left))
      {
        break;
      }
      changed.insert(changed.end(), now.begin(), now.end());
      left = std::move(now);
      result.push_back(std::move(more));
    }
    return result;
  }

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
  /// @param known    finds the first of the samples
  /// @param onBalls  some of the first ones that are on balls through far samples; more after
  BoundarySamples addAround(const std::vector<FarFace>& faces, const PolarBalls& balls,
    const BoundarySamples& samples, const Neighbors& known, std::vector<Index>& onBalls,
    const Execution& execution) const
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
      const std::vector<Point> present = positions(tried.points);
      const bool isNew = this->sampler.add(placesOf(left), tried, aparts[round % aparts.size()],
                           MoreNeighbors(known, present)) > 0;
      spots.add(tried, before);
      spots.judge(isNew
          ? this->farFacesAround(unsolved, balls, tried, known, onBalls, next, execution)
          : left);
    }
    return spots.with(samples, &FarSpot::best);
  }

  /// The far faces around those that were far.
  /// @param balls     of the samples before some were added
  /// @param known     finds the first of the samples
  /// @param onBalls   see addAround()
  /// @param distance  so far around them, in spacings
  std::vector<FarFace> farFacesAround(const std::vector<FarFace>& faces, const PolarBalls& balls,
    const BoundarySamples& samples, const Neighbors& known, std::vector<Index>& onBalls,
    double distance, const Execution& execution) const
  {
    const std::vector<Point> all = positions(samples.points);
    const MoreNeighbors neighbors(known, all);
    std::vector<Index> core;
    for (const FarFace& face : faces)
    {
      const std::vector<Index> near =
        neighbors.within(face.place, (distance + margin) * face.spacing);
      core.insert(core.end(), near.begin(), near.end());
    }
    sortUnique(core);
    const BallsAround made =
      ballsAround(core, balls, all, neighbors, this->tree, execution, onBalls);
    std::copy_if(made.found.begin(), made.found.end(), std::back_inserter(onBalls),
      [&known](Index sample) { return sample < known.size(); });
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
