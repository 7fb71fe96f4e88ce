// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/PairedWalls.h"

#include "Base/Neighbors.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace medial
{
namespace
{
/// Finds partners.
class Walls
{
public:
  Walls(const TriangleSet& theSurface, const SurfaceTree& theTree, const SpacingField& theSpacing,
    double theWidth)
    : surface(theSurface)
    , tree(theTree)
    , spacing(theSpacing)
    , width(theWidth)
  {
  }

  std::optional<SurfacePoint> partnerOf(const SurfacePoint& sample) const
  {
    std::optional<SurfacePoint> result;
    double nearest = this->width;
    for (const double side : { -1.0, 1.0 })
    {
      const Point farthest = sample.position + side * nearest * sample.normal;
      const auto met = this->tree.firstMet(sample.position, farthest, sample.triangle);
      if (met && this->isParallel(sample, met->triangle))
      {
        nearest = (met->point - sample.position).norm();
        result = this->mirrored(sample, *met);
      }
    }
    constexpr double least = 0.02; // spacings: nearer ones would be taken for copies of one
    return result && nearest > least * this->spacing.at(sample.position)
      ? result
      : std::optional<SurfacePoint>();
  }

private:
  bool isParallel(const SurfacePoint& sample, Index opposite) const
  {
    constexpr double most = -0.999; // cosine: 2.5 degrees. Pairs in wedges leave more places wrong
    return sample.normal.dot(this->surface.normals[opposite]) < most;
  }

  /// In the plane halfway between the two walls.
  SurfacePoint mirrored(const SurfacePoint& sample, const SurfaceTree::Place& opposite) const
  {
    const Point& other = this->surface.normals[opposite.triangle];
    const Point across = sample.normal - other;
    const double height = (opposite.point - sample.position).dot(other);
    const Point image = sample.position - 2 * height / across.squaredNorm() * across;
    const SurfaceTree::Place foot = this->tree.nearest(image);
    return { foot.point, this->surface.normals[foot.triangle], foot.triangle };
  }

  const TriangleSet& surface;
  const SurfaceTree& tree;
  const SpacingField& spacing;
  double width;
};

enum class State : char
{
  Free,
  Taken,
  Dropped
};

/// Takes pairs in their order, where no other one is near; what is next to a partner is dropped.
/// @param places  samples, and after them the partners of the paired ones
std::vector<State> takePairs(const std::vector<Point>& places, const std::vector<Index>& paired,
  Index sampleCount, Index fixed, const SpacingField& spacing)
{
  std::vector<State> states(places.size(), State::Free);
  std::fill_n(states.begin(), fixed, State::Taken);
  const Neighbors neighbors(places);
  for (Index k = 0; k < count(paired); ++k)
  {
    const Index sample = paired[k], partner = sampleCount + k;
    constexpr double nearer = 0.7; // of the spacing: leaves no gap
    const std::vector<Index> near = neighbors.within(partner, nearer * spacing.at(places[partner]));
    const auto isTaken = [&](Index other) { return states[other] == State::Taken; };
    if (states[sample] != State::Free || std::any_of(near.begin(), near.end(), isTaken))
    {
      states[sample] = State::Dropped; // another pair is there, or nearly
      continue;
    }
    for (const Index other : near)
    {
      states[other] = State::Dropped;
    }
    states[sample] = states[partner] = State::Taken;
  }
  return states;
}
}

PairedSamples pairAcrossWalls(const TriangleSet& surface, const SurfaceTree& tree,
  const SpacingField& spacing, double width, const std::vector<SurfacePoint>& samples, Index fixed,
  const Execution& execution)
{
  const Walls walls(surface, tree, spacing, width);
  std::vector<std::optional<SurfacePoint>> partners(samples.size());
  execution.between(0, 0.8).forEach(count(samples) - fixed,
    [&](Index i) { partners[fixed + i] = walls.partnerOf(samples[fixed + i]); });

  // Samples, and after them partners by the numbers of their samples.
  std::vector<Point> places = positions(samples);
  std::vector<Index> paired;
  for (Index i = fixed; i < count(samples); ++i)
  {
    if (partners[i])
    {
      paired.push_back(i);
      places.push_back(partners[i]->position);
    }
  }
  if (paired.empty())
  {
    execution.report(1);
    return { samples, {} };
  }
  const std::vector<State> states = takePairs(places, paired, count(samples), fixed, spacing);
  PairedSamples result;
  for (Index i = 0; i < count(samples); ++i)
  {
    if (states[i] != State::Dropped)
    {
      result.points.push_back(samples[i]);
    }
  }
  for (Index k = 0; k < count(paired); ++k)
  {
    if (states[count(samples) + k] == State::Taken)
    {
      result.places.push_back(places[paired[k]]);
      result.points.push_back(*partners[paired[k]]);
    }
  }
  execution.report(1);
  return result;
}
}
