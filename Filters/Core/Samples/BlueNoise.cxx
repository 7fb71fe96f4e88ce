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

/// All candidates, and the random order in which they are taken.
struct Candidates
{
  std::vector<Point> places;
  std::vector<Index> pieces;                          ///< of each
  std::vector<std::pair<std::uint64_t, Index>> order; ///< a random number, and the candidate's own
};

/// The candidates of a piece.
/// @param number  of the piece
/// @param random  of its triangle
void addCandidates(const SurfacePiece& piece, Index number, Random& random, Candidates& result)
{
  constexpr double each = 8; // for each sample: more would hardly narrow the gaps
  // The part of a candidate is one with its probability.
  const auto howMany =
    static_cast<Index>(std::floor(each * expectedSamples(piece) + random.uniform()));
  const auto& [a, b, c] = piece.corners;
  for (Index i = 0; i < howMany; ++i)
  {
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1)
    {
      u = 1 - u;
      v = 1 - v;
    }
    result.order.emplace_back(random.bits(), count(result.places));
    result.places.emplace_back(a + u * (b - a) + v * (c - a));
    result.pieces.push_back(number);
  }
}

/// @param places  there are already, before those of the candidates
Candidates candidates(const std::vector<SurfacePiece>& pieces, std::vector<Point> places)
{
  Candidates result{ std::move(places), {}, {} };
  result.pieces.assign(result.places.size(), None);
  Random random(None);
  Index triangle = None;
  for (Index i = 0; i < count(pieces); ++i)
  {
    if (pieces[i].triangle != triangle)
    {
      triangle = pieces[i].triangle;
      random = Random(triangle);
    }
    addCandidates(pieces[i], i, random, result);
  }
  std::sort(result.order.begin(), result.order.end());
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

SurfacePoint middleOf(const TriangleSet& surface, Index triangle)
{
  const auto& [a, b, c] = surface.triangles[triangle];
  return { (surface.points[a] + surface.points[b] + surface.points[c]) / 3,
    surface.normals[triangle], triangle };
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
  const Candidates all = candidates(pieces, positions(taken));
  execution.report(0.4);
  const Neighbors neighbors(all.places);
  execution.report(0.6);
  std::vector<char> dropped(all.places.size(), 0);
  const auto keepAway = [&](const Point& place, double distance) {
    neighbors.forEachWithin(place, distance, [&dropped](Index other) { dropped[other] = 1; });
  };
  for (const SurfacePoint& each : taken)
  {
    constexpr double nearer = 0.75;
    keepAway(each.position, nearer * spacing.at(each.position));
  }
  for (Index i = 0; i < count(all.order); ++i)
  {
    execution.pollAt(i);
    const Index candidate = all.order[i].second;
    if (!dropped[candidate])
    {
      const SurfacePiece& piece = pieces[all.pieces[candidate]];
      const Point& place = all.places[candidate];
      result.push_back({ place, surface.normals[piece.triangle], piece.triangle });
      keepAway(place, piece.spacing);
    }
  }
  execution.report(1);
  return result;
}
}
