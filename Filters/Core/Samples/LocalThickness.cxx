// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/LocalThickness.h"

#include "Base/Neighbors.h"

#include <algorithm>
#include <cmath>
#include <limits>

// Shrinking balls: the first ball is between the point and the wall that the way along the normal meets, or as
// large as counts. While it holds a sample, it shrinks to the ball through that one. In an edge it shrinks to
// nothing: there it has touched a wall that isn't opposite.
namespace medial
{
namespace
{
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A ball between a point of the surface and an opposite wall.
struct Span
{
  double width = infinite; ///< its diameter
  Point opposite;          ///< normal of the wall
};

/// Measures one side of one sample.
class Spans
{
public:
  Spans(const std::vector<SurfacePoint>& theSamples, const SurfaceTree& theTree,
    const std::vector<Point>& theTriangleNormals, double theMost)
    : samples(theSamples)
    , places(positions(theSamples))
    , neighbors(this->places)
    , tree(theTree)
    , triangleNormals(theTriangleNormals)
    , most(theMost)
  {
  }

  Span at(const SurfacePoint& sample, const Point& inwards) const
  {
    // As free as a larger ball must be, and searches around far centres are slow.
    constexpr double enough = 0.95; // of the radius: a spacing need not be more exact
    double radius = this->most / enough / 2;
    Point opposite = -sample.normal;
    const Point farthest = sample.position + 2 * radius * inwards;
    if (const auto met = this->tree.firstMet(sample.position, farthest, sample.triangle))
    {
      radius = (met->point - sample.position).norm() / 2;
      opposite = this->triangleNormals[met->triangle];
    }
    constexpr int steps = 30; // each shrinks it; few are needed
    for (int step = 0; step < steps && radius > 0; ++step)
    {
      const Point center = sample.position + radius * inwards;
      constexpr double rounding = 1e-9;
      const Index found = this->neighbors.nearestOne(center, (1 + rounding) * enough * radius);
      if (found == None)
      {
        break;
      }
      const SurfacePoint& nearest = this->samples[found];
      const Point across = nearest.position - sample.position;
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
    const bool counts = 2 * radius < this->most && sample.normal.dot(opposite) < isOpposite;
    return { counts ? 2 * radius : infinite, opposite };
  }

private:
  const std::vector<SurfacePoint>& samples;
  std::vector<Point> places;
  Neighbors neighbors;
  const SurfaceTree& tree;
  const std::vector<Point>& triangleNormals;
  double most;
};

/// Knows where the two walls of a span meet.
class Wedges
{
public:
  explicit Wedges(const std::vector<WedgeEdge>& theEdges)
    : edges(theEdges)
    , places(positionsOf(theEdges))
    , neighbors(this->places)
  {
    for (const WedgeEdge& edge : this->edges)
    {
      this->longest = std::max(this->longest, (edge.ends[1] - edge.ends[0]).norm());
    }
  }

  bool holds(const SurfacePoint& at, const Span& span) const
  {
    if (this->edges.empty() || span.width == infinite)
    {
      return false;
    }
    // The ball between two planes at this angle is so wide at a distance of one from where they meet.
    const double cosine = std::clamp(-at.normal.dot(span.opposite), -1.0, 1.0);
    const double slope = 2 * std::sqrt((1 - cosine) / (1 + cosine));
    constexpr double narrow = 0.052; // three degrees: thin far behind its edge, as a thin wall is
    if (slope < narrow)
    {
      return false;
    }
    constexpr double about = 1.5; // the walls may be curved a little
    const double farthest = about * span.width / slope;
    const std::vector<Index> near =
      this->neighbors.within(at.position, farthest + this->longest / 2);
    return std::any_of(near.begin(), near.end(), [&](Index i) {
      return distance(this->edges[i].ends, at.position) < farthest &&
        isBetween(this->edges[i], at.normal, span.opposite);
    });
  }

private:
  static std::vector<Point> positionsOf(const std::vector<WedgeEdge>& edges)
  {
    std::vector<Point> result(edges.size());
    std::transform(edges.begin(), edges.end(), result.begin(),
      [](const WedgeEdge& edge) -> Point { return (edge.ends[0] + edge.ends[1]) / 2; });
    return result;
  }

  static double distance(const std::array<Point, 2>& ends, const Point& from)
  {
    const Point along = ends[1] - ends[0];
    const double t = along.dot(from - ends[0]) / along.squaredNorm();
    return (ends[0] + std::clamp(t, 0.0, 1.0) * along - from).norm();
  }

  static bool isBetween(const WedgeEdge& edge, const Point& a, const Point& b)
  {
    constexpr double like = 0.9; // cosine
    const auto& [first, second] = edge.normals;
    return (a.dot(first) > like && b.dot(second) > like) ||
      (a.dot(second) > like && b.dot(first) > like);
  }

  const std::vector<WedgeEdge>& edges;
  std::vector<Point> places;
  Neighbors neighbors;
  double longest = 0; ///< piece of an edge
};
}

std::vector<Point> positions(const std::vector<SurfacePoint>& samples)
{
  std::vector<Point> result(samples.size());
  std::transform(samples.begin(), samples.end(), result.begin(),
    [](const SurfacePoint& sample) { return sample.position; });
  return result;
}

std::vector<Point> normals(const std::vector<SurfacePoint>& samples)
{
  std::vector<Point> result(samples.size());
  std::transform(samples.begin(), samples.end(), result.begin(),
    [](const SurfacePoint& sample) { return sample.normal; });
  return result;
}

std::vector<double> localThickness(const std::vector<SurfacePoint>& samples,
  const SurfaceTree& tree, const std::vector<Point>& triangleNormals, double most,
  const std::vector<WedgeEdge>& edges, const Execution& execution, Index first)
{
  const Wedges wedges(edges);
  const Spans spans(samples, tree, triangleNormals, most);
  std::vector<double> result(samples.size() - first, infinite);
  execution.forEach(count(result), [&](Index i) {
    const SurfacePoint& sample = samples[first + i];
    for (const double side : { -1.0, 1.0 })
    {
      const Span span = spans.at(sample, side * sample.normal);
      result[i] = wedges.holds(sample, span) ? result[i] : std::min(result[i], span.width);
    }
  });
  return result;
}
}
