// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/BlueNoise.h"

#include "Base/Neighbors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace medial
{
namespace
{
/// Random numbers of a triangle: they don't depend on the other triangles or on threads (SplitMix64).
class Random
{
public:
  explicit Random(Index triangle)
    : state(0x9e3779b97f4a7c15u * (static_cast<std::uint64_t>(triangle) + 1))
  {
  }
  std::uint64_t bits()
  {
    std::uint64_t z = (this->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double uniform() { return static_cast<double>(this->bits() >> 11) / 9007199254740992.0; }

private:
  std::uint64_t state;
};

/// Areas of a triangle in which the spacing hardly changes.
template <typename Body>
void forEachPiece(
  const std::array<Point, 3>& corners, const SpacingField& spacing, const Body& body)
{
  std::vector<std::array<Point, 3>> open{ corners };
  while (!open.empty())
  {
    const std::array<Point, 3> piece = open.back();
    open.pop_back();
    const double here = spacing.at((piece[0] + piece[1] + piece[2]) / 3);
    int longest = 0;
    double length = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double side = (piece[(k + 1) % 3] - piece[k]).norm();
      longest = side > length ? k : longest;
      length = std::max(length, side);
    }
    constexpr double wide = 3; // spacings: it grows by less than itself over that
    if (length <= wide * here)
    {
      body(piece, here);
      continue;
    }
    const Point middle = (piece[longest] + piece[(longest + 1) % 3]) / 2;
    const Point& apex = piece[(longest + 2) % 3];
    open.push_back({ piece[longest], middle, apex });
    open.push_back({ middle, piece[(longest + 1) % 3], apex });
  }
}

double areaOf(const std::array<Point, 3>& t)
{
  return (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
}

std::array<Point, 3> cornersOf(const TriangleSet& surface, Index t)
{
  const Triangle& corners = surface.triangles[t];
  return { surface.points[corners[0]], surface.points[corners[1]], surface.points[corners[2]] };
}

struct Candidate
{
  std::uint64_t order;
  SurfacePoint point;
  double spacing;
};

/// The candidates of one triangle.
std::vector<Candidate> candidatesOf(
  const TriangleSet& surface, Index t, const SpacingField& spacing)
{
  constexpr double each = 8; // for each sample: more would hardly narrow the gaps
  Random random(t);
  std::vector<Candidate> result;
  forEachPiece(cornersOf(surface, t), spacing, [&](const std::array<Point, 3>& piece, double here) {
    // The part of a candidate is one with its probability.
    const double wanted = each * samplesPerSquare * areaOf(piece) / (here * here);
    const auto number = static_cast<Index>(std::floor(wanted + random.uniform()));
    for (Index i = 0; i < number; ++i)
    {
      double u = random.uniform(), v = random.uniform();
      if (u + v > 1)
      {
        u = 1 - u;
        v = 1 - v;
      }
      const Point p = piece[0] + u * (piece[1] - piece[0]) + v * (piece[2] - piece[0]);
      result.push_back({ random.bits(), { p, surface.normals[t], t }, here });
    }
  });
  return result;
}

std::vector<Candidate> candidates(
  const TriangleSet& surface, const SpacingField& spacing, const Execution& execution)
{
  std::vector<std::vector<Candidate>> each(surface.triangles.size());
  execution.forEach(count(each), [&](Index t) {
    if (surface.areas[t] > 0)
    {
      each[t] = candidatesOf(surface, t, spacing);
    }
  });
  std::vector<Candidate> result;
  for (const std::vector<Candidate>& list : each)
  {
    result.insert(result.end(), list.begin(), list.end());
  }
  std::stable_sort(result.begin(), result.end(),
    [](const Candidate& a, const Candidate& b) { return a.order < b.order; });
  return result;
}
}

TriangleSet triangleSet(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  TriangleSet result{ points, triangles, {}, {} };
  for (const Triangle& t : triangles)
  {
    const Point normal = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
    const double length = normal.norm();
    result.normals.push_back(length > 0 ? Point(normal / length) : Point::Zero());
    result.areas.push_back(length / 2);
  }
  return result;
}

double expectedSamples(
  const TriangleSet& surface, const SpacingField& spacing, const Execution& execution)
{
  std::vector<double> each(surface.triangles.size(), 0);
  execution.forEach(count(each), [&](Index t) {
    if (surface.areas[t] > 0)
    {
      forEachPiece(
        cornersOf(surface, t), spacing, [&](const std::array<Point, 3>& piece, double here) {
          each[t] += samplesPerSquare * areaOf(piece) / (here * here);
        });
    }
  });
  double result = 0;
  for (const double n : each)
  {
    result += n;
  }
  return result;
}

std::vector<SurfacePoint> blueNoise(const TriangleSet& surface, const SpacingField& spacing,
  const std::vector<SurfacePoint>& taken, const Execution& execution)
{
  std::vector<SurfacePoint> result = taken;
  const std::vector<Candidate> all = candidates(surface, spacing, execution.between(0, 0.4));
  std::vector<Point> places = positions(taken);
  places.reserve(taken.size() + all.size());
  for (const Candidate& candidate : all)
  {
    places.push_back(candidate.point.position);
  }
  const Neighbors neighbors(places);
  execution.report(0.6);
  std::vector<char> dropped(places.size(), 0);
  const auto keepAway = [&](Index i, double distance) {
    for (const Index other : neighbors.within(i, distance))
    {
      dropped[other] = 1;
    }
  };
  const Index first = count(taken);
  for (Index i = 0; i < first; ++i)
  {
    constexpr double nearer = 0.75;
    keepAway(i, nearer * spacing.at(places[i]));
  }
  for (Index i = first; i < count(places); ++i)
  {
    execution.pollAt(i);
    if (!dropped[i])
    {
      result.push_back(all[i - first].point);
      keepAway(i, all[i - first].spacing);
    }
  }
  execution.report(1);
  return result;
}
}
