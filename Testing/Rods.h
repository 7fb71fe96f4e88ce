// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rods_h
#define Rods_h

#include "Numbers.h"
#include "PoissonDisk.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

/// Solids of rods whose centerlines are known.
namespace rods
{
using medial::Edge;
using medial::Index;
using medial::Point;
using shapes::Random;

constexpr double pi = 3.14159265358979323846;

/// A rod between two balls, as wide as they are.
struct Rod
{
  Point from, to;
  double fromRadius, toRadius;

  double length() const { return (this->to - this->from).norm(); }
  Point along() const { return (this->to - this->from) / this->length(); }
  double slope() const { return (this->fromRadius - this->toRadius) / this->length(); }
  double radiusAt(double share) const
  {
    return this->fromRadius + share * (this->toRadius - this->fromRadius);
  }

  /// Where the middle is nearest to a point, as a share of the length.
  double nearest(const Point& x) const
  {
    return std::clamp((x - this->from).dot(this->along()) / this->length(), 0.0, 1.0);
  }
  Point at(double share) const { return this->from + share * (this->to - this->from); }

  /// The distance to the surface, negative inside.
  double outside(const Point& x) const
  {
    const double t = (x - this->from).dot(this->along());
    const double across = (x - this->from - t * this->along()).norm();
    const double tilt = this->slope() / std::sqrt(1 - this->slope() * this->slope());
    const double share = std::clamp((t + across * tilt) / this->length(), 0.0, 1.0);
    return (x - this->at(share)).norm() - this->radiusAt(share);
  }
};

/// Rods that share their ends.
struct Frame
{
  std::vector<Point> nodes;
  std::vector<double> radii;
  std::vector<Edge> edges;

  std::vector<Rod> rods() const
  {
    std::vector<Rod> result;
    for (const auto& [a, b] : this->edges)
    {
      result.push_back({ this->nodes[a], this->nodes[b], this->radii[a], this->radii[b] });
    }
    return result;
  }
};

inline Point pointOn(const Rod& rod, Random& random)
{
  const Point direction = shapes::direction(random);
  const int where = static_cast<int>(shapes::uniform(random, 0, 4));
  if (where < 2)
  {
    return where == 0 ? Point(rod.from + rod.fromRadius * direction)
                      : Point(rod.to + rod.toRadius * direction);
  }
  const Point across = (direction - direction.dot(rod.along()) * rod.along()).normalized();
  const double share = shapes::uniform(random, 0, 1);
  const Point normal =
    rod.slope() * rod.along() + std::sqrt(1 - rod.slope() * rod.slope()) * across;
  return rod.at(share) + rod.radiusAt(share) * normal;
}

/// Samples of the surface of the union of rods.
inline std::vector<Point> samples(const std::vector<Rod>& rods, double spacing, unsigned seed)
{
  const auto isInside = [&rods](const Point& x) {
    return std::any_of(
      rods.begin(), rods.end(), [&x](const Rod& rod) { return rod.outside(x) < -1e-9; });
  };
  return shapes::poissonDisk(
    [&](Random& random) {
      for (;;)
      {
        const auto which =
          static_cast<std::size_t>(shapes::uniform(random, 0, static_cast<double>(rods.size())));
        const Point point = pointOn(rods[std::min(which, rods.size() - 1)], random);
        if (!isInside(point))
        {
          return point;
        }
      }
    },
    spacing, seed);
}

/// Eight vessels, four of them in a loop.
inline Frame vesselTree()
{
  return { { { 0, 0, -3 }, { 0, 0, 0 }, { -1.2, 0, 1.4 }, { 1.2, 0.2, 1.4 }, { 0, 0.3, 2.9 },
             { -2.4, 0.5, 2.6 }, { 2.6, -0.4, 2.4 }, { 0.1, 0.2, 4.4 } },
    { 0.5, 0.45, 0.36, 0.36, 0.32, 0.24, 0.24, 0.25 },
    { { 0, 1 }, { 1, 2 }, { 1, 3 }, { 2, 4 }, { 3, 4 }, { 2, 5 }, { 3, 6 }, { 4, 7 } } };
}

/// The edges of a cube of side 2.
inline Frame cubeFrame(double radius = 0.2)
{
  Frame frame;
  for (Index i = 0; i < 8; ++i)
  {
    frame.nodes.emplace_back(2 * (i & 1), i & 2, (i & 4) / 2);
    frame.radii.push_back(radius);
    for (const Index bit : { 1, 2, 4 })
    {
      if ((i & bit) == 0)
      {
        frame.edges.push_back({ i, i + bit });
      }
    }
  }
  return frame;
}

/// The edges of a regular tetrahedron of side 2.8.
inline Frame tetrahedronFrame(double radius = 0.2)
{
  return { { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } },
    { radius, radius, radius, radius },
    { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } } };
}

/// Samples of a spring: a tube about (cos t, sin t, rise t) with balls as ends.
inline std::vector<Point> spring(
  double turns, double rise, double radius, double spacing, unsigned seed)
{
  const double end = 2 * pi * turns;
  return shapes::poissonDisk(
    [&](Random& random) {
      const double t = std::clamp(shapes::uniform(random, -0.05, 1.05), 0.0, 1.0) * end;
      const Point middle(shapes::cosine(t), shapes::sine(t), rise * t);
      const Point along = Point(-shapes::sine(t), shapes::cosine(t), rise).normalized();
      Point direction = shapes::direction(random);
      const double forward = direction.dot(along);
      if ((t > 0 && t < end) || (t == 0) == (forward > 0))
      {
        direction -= forward * along;
      }
      return Point(middle + radius * direction.normalized());
    },
    spacing, seed);
}

/// Samples of a rod of length 6 and more along x, its sections ellipses, with halves of ellipsoids as ends.
inline std::vector<Point> ellipticRod(double width, double height, double spacing, unsigned seed)
{
  return shapes::poissonDisk(
    [&](Random& random) {
      const Point d = shapes::direction(random);
      const bool isEnd = shapes::uniform(random, 0, 4) < 1;
      const double around = std::sqrt(d.y() * d.y() + d.z() * d.z());
      return isEnd
        ? Point((d.x() > 0 ? 3 : -3) + height * d.x(), width * d.y(), height * d.z())
        : Point(shapes::uniform(random, -3, 3), width * d.y() / around, height * d.z() / around);
    },
    spacing, seed);
}

/// Samples of a cylinder of radius 1 and length 4 along z, its ends flat.
inline std::vector<Point> cylinder(double spacing, unsigned seed)
{
  std::vector<Point> rims;
  const int perRim = static_cast<int>(2 * pi / spacing);
  for (int i = 0; i < 2 * perRim; ++i)
  {
    const double t = 2 * pi * i / perRim;
    rims.emplace_back(shapes::cosine(t), shapes::sine(t), i < perRim ? -2 : 2);
  }
  return shapes::poissonDisk(
    [](Random& random) {
      const double t = shapes::uniform(random, 0, 2 * pi);
      const Point side(shapes::cosine(t), shapes::sine(t), shapes::uniform(random, -2, 2));
      const double r = std::sqrt(shapes::uniform(random, 0, 1));
      const double flat = side.z() < 0 ? -2 : 2;
      return shapes::uniform(random, 0, 3) < 2 ? side : Point(r * side.x(), r * side.y(), flat);
    },
    spacing, seed, rims);
}
}

#endif
