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

double expectedSamples(const SurfacePiece& piece)
{
  const auto& [a, b, c] = piece.corners;
  const double area = (b - a).cross(c - a).norm() / 2;
  return samplesPerSquare * area / (piece.spacing * piece.spacing);
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

/// The candidates of a piece.
/// @param random  of its triangle
void addCandidates(
  const SurfacePiece& piece, const Point& normal, Random& random, std::vector<Candidate>& result)
{
  constexpr double each = 8; // for each sample: more would hardly narrow the gaps
  // The part of a candidate is one with its probability.
  const auto number =
    static_cast<Index>(std::floor(each * expectedSamples(piece) + random.uniform()));
  const auto& [a, b, c] = piece.corners;
  for (Index i = 0; i < number; ++i)
  {
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1)
    {
      u = 1 - u;
      v = 1 - v;
    }
    const Point p = a + u * (b - a) + v * (c - a);
    result.push_back({ random.bits(), { p, normal, piece.triangle }, piece.spacing });
  }
}

/// In random order.
std::vector<Candidate> candidates(
  const TriangleSet& surface, const std::vector<SurfacePiece>& pieces)
{
  std::vector<Candidate> result;
  Random random(None);
  Index triangle = None;
  for (const SurfacePiece& piece : pieces)
  {
    if (piece.triangle != triangle)
    {
      triangle = piece.triangle;
      random = Random(triangle);
    }
    addCandidates(piece, surface.normals[triangle], random, result);
  }
  std::stable_sort(result.begin(), result.end(),
    [](const Candidate& a, const Candidate& b) { return a.order < b.order; });
  return result;
}

/// Cuts a triangle at the middle of its longest side, and again, until the spacing hardly changes.
void addPieces(const std::array<Point, 3>& whole, Index triangle, const SpacingField& spacing,
  std::vector<SurfacePiece>& result)
{
  std::vector<std::array<Point, 3>> open{ whole };
  while (!open.empty())
  {
    SurfacePiece piece{ open.back(), triangle, 0 };
    open.pop_back();
    piece.spacing = spacing.at(piece.middle());
    int longest = 0;
    double length = 0;
    for (int k = 0; k < 3; ++k)
    {
      const double side = (piece.corners[(k + 1) % 3] - piece.corners[k]).norm();
      longest = side > length ? k : longest;
      length = std::max(length, side);
    }
    constexpr double wide = 3; // spacings: it grows by less than itself over that
    if (length <= wide * piece.spacing)
    {
      result.push_back(piece);
      continue;
    }
    const auto corner = [&](int k) -> const Point& { return piece.corners[(longest + k) % 3]; };
    const Point middle = (corner(0) + corner(1)) / 2;
    open.push_back({ corner(0), middle, corner(2) });
    open.push_back({ middle, corner(1), corner(2) });
  }
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

std::vector<SurfacePiece> surfacePieces(
  const TriangleSet& surface, const SpacingField& spacing, const Execution& execution)
{
  constexpr Index size = 256; // of a block of triangles, which a thread takes at once
  const Index all = count(surface.triangles);
  std::vector<std::vector<SurfacePiece>> blocks((all + size - 1) / size);
  execution.forEach(count(blocks), [&](Index block) {
    for (Index t = block * size; t < std::min(all, (block + 1) * size); ++t)
    {
      if (surface.areas[t] > 0)
      {
        addPieces(cornersOf(surface, t), t, spacing, blocks[block]);
      }
    }
  });
  std::vector<SurfacePiece> result;
  for (const std::vector<SurfacePiece>& block : blocks)
  {
    result.insert(result.end(), block.begin(), block.end());
  }
  return result;
}

double expectedSamples(const std::vector<SurfacePiece>& pieces)
{
  double result = 0;
  for (const SurfacePiece& piece : pieces)
  {
    result += expectedSamples(piece);
  }
  return result;
}

std::vector<SurfacePoint> blueNoise(const TriangleSet& surface,
  const std::vector<SurfacePiece>& pieces, const std::vector<SurfacePoint>& taken,
  const SpacingField& spacing, const Execution& execution)
{
  std::vector<SurfacePoint> result = taken;
  const std::vector<Candidate> all = candidates(surface, pieces);
  execution.report(0.4);
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
