// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/LocalThickness.h"

#include "Base/Neighbors.h"

#include <algorithm>
#include <limits>

// Shrinking balls: the first ball is between the point and the wall that a ray along the normal meets. While
// it holds a sample, it shrinks to the ball through that one. In an edge it shrinks to nothing: there it has
// touched a wall that isn't opposite.
namespace medial
{
namespace
{
constexpr double infinite = std::numeric_limits<double>::infinity();

/// One side of one sample.
double thickness(const SurfacePoint& at, const Point& inwards,
  const std::vector<SurfacePoint>& samples, const Neighbors& neighbors, const SurfaceTree& tree,
  const std::vector<Point>& triangleNormals)
{
  const auto met = tree.firstMet(at.position, inwards, at.triangle);
  if (!met)
  {
    return infinite;
  }
  double radius = (met->point - at.position).norm() / 2;
  Point opposite = triangleNormals[met->triangle];
  constexpr int most = 30; // each step shrinks it; few are needed
  for (int step = 0; step < most && radius > 0; ++step)
  {
    const Point center = at.position + radius * inwards;
    const SurfacePoint& nearest = samples[neighbors.nearest(center, 1).front()];
    constexpr double enough = 0.95; // of the radius: a spacing need not be more exact
    const Point across = nearest.position - at.position;
    const double along = across.dot(inwards);
    if ((nearest.position - center).norm() >= enough * radius || along <= 0)
    {
      break;
    }
    radius = across.squaredNorm() / (2 * along);
    opposite = nearest.normal;
  }
  // 100 degrees and more between the normals: no edge of a box, and all that is thinner than it is wide.
  constexpr double isOpposite = -0.17; // cosine
  return at.normal.dot(opposite) < isOpposite ? 2 * radius : infinite;
}
}

std::vector<Point> positions(const std::vector<SurfacePoint>& samples)
{
  std::vector<Point> result(samples.size());
  std::transform(samples.begin(), samples.end(), result.begin(),
    [](const SurfacePoint& sample) { return sample.position; });
  return result;
}

std::vector<double> localThickness(const std::vector<SurfacePoint>& samples,
  const SurfaceTree& tree, const std::vector<Point>& triangleNormals, const Execution& execution)
{
  const std::vector<Point> places = positions(samples);
  const Neighbors neighbors(places);
  std::vector<double> result(samples.size());
  execution.forEach(count(samples), [&](Index i) {
    result[i] = infinite;
    for (const double side : { -1.0, 1.0 })
    {
      result[i] = std::min(result[i],
        thickness(samples[i], side * samples[i].normal, samples, neighbors, tree, triangleNormals));
    }
  });
  return result;
}
}
