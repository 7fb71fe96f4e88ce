// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/BallsAround.h"

#include "Balls/Sides.h"
#include "Base/Frame.h"
#include "Base/Tetrahedra.h"

#include <algorithm>
#include <iterator>

// A ball through samples with no other sample inside is one of the Delaunay triangulation of all samples. The
// Voronoi cell of a sample among few others contains that among all; so where the sphere around its farthest
// vertex is empty, that vertex is the pole.
namespace medial
{
namespace
{
/// The samples that are the farthest on each axis: guards stand around them.
std::vector<Index> extremes(const std::vector<Point>& samples)
{
  std::vector<Index> result(6, 0);
  for (Index s = 0; s < count(samples); ++s)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = samples[s][axis];
      result[axis] = x < samples[result[axis]][axis] ? s : result[axis];
      result[axis + 3] = x > samples[result[axis + 3]][axis] ? s : result[axis + 3];
    }
  }
  return result;
}

/// The balls that pass through a sample of the core.
std::vector<Index> ballsOfCore(const PolarBalls& balls, const std::vector<char>& isCore)
{
  std::vector<Index> result;
  for (Index b = 0; b < count(balls.balls); ++b)
  {
    const auto own = balls.ballSamples[b];
    if (std::any_of(own.begin(), own.end(), [&](Index s) { return isCore[s]; }))
    {
      result.push_back(b);
    }
  }
  return result;
}

/// The core, and the samples on its balls, as they were before.
std::vector<Index> coreAndNeighbors(
  const std::vector<Index>& core, const PolarBalls& before, Index sampleCount)
{
  std::vector<char> isCore(sampleCount, 0);
  for (const Index s : core)
  {
    isCore[s] = 1;
  }
  std::vector<Index> result = core;
  for (const Index b : ballsOfCore(before, isCore))
  {
    const auto own = before.ballSamples[b];
    result.insert(result.end(), own.begin(), own.end());
  }
  return result;
}

/// Only some of the balls, with their sides and their own triangulation.
PolarBalls only(const std::vector<Index>& chosen, const PolarBalls& all, const SurfaceTree& solid,
  const Execution& execution)
{
  PolarBalls result;
  result.samples = all.samples;
  const Frame frame = frameOf(all.samples);
  std::vector<Ball> local;
  for (const Index b : chosen)
  {
    local.push_back(frame.toLocal(all.balls[b]));
    result.balls.push_back(all.balls[b]);
    result.touchesGuard.push_back(all.touchesGuard[b]);
    result.ballSamples.append(all.ballSamples[b]);
  }
  result.triangulation = powerCells(local, execution);
  const std::vector<Edge> edges =
    edgeNumbers(result.triangulation.cells, count(result.balls)).edges;
  result.sides = sidesIn(solid, frame, { {}, {}, local, result.touchesGuard, edges }, execution);
  return result;
}
}

BallsAround ballsAround(const std::vector<Index>& core, const PolarBalls& before,
  const std::vector<Point>& samples, const MoreNeighbors& neighbors, const SurfaceTree& solid,
  const Execution& execution, const std::vector<Index>& likely)
{
  BallsAround result;
  result.samples = coreAndNeighbors(core, before, count(samples));
  const std::vector<Index> farthest = extremes(samples);
  result.samples.insert(result.samples.end(), farthest.begin(), farthest.end());
  result.samples.insert(result.samples.end(), likely.begin(), likely.end());
  sortUnique(result.samples);
  const std::vector<Index> expected = result.samples;
  std::size_t known = 0;
  while (result.samples.size() > known)
  {
    known = result.samples.size();
    std::vector<Point> places;
    std::vector<char> isCore;
    for (const Index s : result.samples)
    {
      places.push_back(samples[s]);
      isCore.push_back(std::binary_search(core.begin(), core.end(), s));
    }
    const PolarBalls made = ballsWithoutSides(places, execution);
    const std::vector<Index> chosen = ballsOfCore(made, isCore);
    for (const Index b : chosen)
    {
      result.samples.push_back(neighbors.nearestOne(made.balls[b].center));
    }
    sortUnique(result.samples);
    if (result.samples.size() == known)
    {
      result.balls = only(chosen, made, solid, execution);
    }
  }
  std::set_difference(result.samples.begin(), result.samples.end(), expected.begin(),
    expected.end(), std::back_inserter(result.found));
  return result;
}
}
