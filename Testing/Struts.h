// SPDX-License-Identifier: BSD-3-Clause
#ifndef Struts_h
#define Struts_h

#include "Numbers.h"
#include "PoissonDisk.h"

#include <algorithm>
#include <cmath>
#include <vector>

/// Samples of solids made of rods and plates whose number is known: all points within a radius of
/// segments and rectangles.
namespace shapes
{
/// The rectangle with a corner and two orthogonal sides; a segment where the second side is 0.
struct Strut
{
  Point corner, u, v = Point::Zero();

  static double share(const Point& along, const Point& place)
  {
    const double square = dot(along, along);
    return square > 0 ? std::clamp(dot(place, along) / square, 0., 1.) : 0;
  }

  /// Its point nearest to a place.
  Point nearest(const Point& place) const
  {
    const Point from = place - this->corner;
    return this->corner + share(this->u, from) * this->u + share(this->v, from) * this->v;
  }
};

inline Strut segment(const Point& a, const Point& b)
{
  return { a, b - a };
}

/// A point of the boundary of all that is within the radius.
inline Draw surfaceOf(const std::vector<Strut>& struts, double radius)
{
  return [struts, radius](Random& random) {
    while (true)
    {
      const double which = uniform(random, 0, static_cast<double>(struts.size()));
      const Strut& strut = struts[std::min(static_cast<std::size_t>(which), struts.size() - 1)];
      Point place = strut.corner + 1.5 * radius * direction(random);
      for (const Point& side : { strut.u, strut.v })
      {
        place += uniform(random, -0.1, 1.1) * side;
      }
      const Point foot = strut.nearest(place);
      const double distance = length(place - foot);
      const Point point = foot + (radius / std::max(distance, 1e-300)) * (place - foot);
      const bool isOutside = std::all_of(struts.begin(), struts.end(), [&](const Strut& other) {
        return length(point - other.nearest(point)) > radius * (1 - 1e-9);
      });
      if (distance > 0.1 * radius && isOutside)
      {
        return point;
      }
    }
  };
}

inline std::vector<Point> strutSamples(
  const std::vector<Strut>& struts, double radius, double spacing, unsigned seed)
{
  return poissonDisk(surfaceOf(struts, radius), spacing, seed);
}

/// The 12 edges of a cube of side 2.
inline std::vector<Strut> cubeFrame()
{
  std::vector<Strut> result;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int i = 0; i < 4; ++i)
    {
      Point from;
      from[axis] = 0;
      from[(axis + 1) % 3] = i % 2 * 2;
      from[(axis + 2) % 3] = i / 2 * 2;
      Point to = from;
      to[axis] = 2;
      result.push_back(segment(from, to));
    }
  }
  return result;
}

/// The 6 edges of a regular tetrahedron of side 2.8.
inline std::vector<Strut> tetrahedronFrame()
{
  const std::vector<Point> corners{ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
  std::vector<Strut> result;
  for (std::size_t i = 0; i < 4; ++i)
  {
    for (std::size_t k = i + 1; k < 4; ++k)
    {
      result.push_back(segment(corners[i], corners[k]));
    }
  }
  return result;
}

/// Three rods from the origin, at angles of about 120 degrees.
inline std::vector<Strut> threeRods()
{
  return { segment({ 0, 0, 0 }, { 2, 0, 0 }), segment({ 0, 0, 0 }, { -1, 1.7, 0 }),
    segment({ 0, 0, 0 }, { -1, -1.7, 0 }) };
}

/// Six rods along the axes from the origin.
inline std::vector<Strut> sixRods()
{
  std::vector<Strut> result;
  for (int axis = 0; axis < 3; ++axis)
  {
    Point end = Point::Zero();
    end[axis] = 1.5;
    result.push_back(segment(-end, end));
  }
  return result;
}

/// Two turns of a helix of radius 1 and pitch 1.2, of short segments.
inline std::vector<Strut> spring()
{
  constexpr int steps = 48;
  constexpr double pi = 3.14159265358979323846;
  const auto at = [](int i) {
    const double angle = 4 * pi * i / steps;
    return Point(cosine(angle), sine(angle), 1.2 * angle / (2 * pi));
  };
  std::vector<Strut> result;
  for (int i = 0; i < steps; ++i)
  {
    result.push_back(segment(at(i), at(i + 1)));
  }
  return result;
}

/// A plate of 2 x 1.6.
inline std::vector<Strut> plate()
{
  return { { { -1, -0.8, 0 }, { 2, 0, 0 }, { 0, 1.6, 0 } } };
}

/// Three plates of 1 x 1.6 at the z axis.
inline std::vector<Strut> threePlates()
{
  std::vector<Strut> result;
  for (const Point& out :
    { Point(1, 0, 0), Point(-0.5, 0.8660254037844386, 0), Point(-0.5, -0.8660254037844386, 0) })
  {
    result.push_back({ { 0, 0, -0.8 }, out, { 0, 0, 1.6 } });
  }
  return result;
}

/// Two plates of 1.2 x 1.2, 1.2 apart, and a rod between them.
inline std::vector<Strut> platesAndRod()
{
  return { { { -1.8, -0.6, -0.6 }, { 1.2, 0, 0 }, { 0, 1.2, 0 } },
    { { 0.6, -0.6, -0.6 }, { 1.2, 0, 0 }, { 0, 1.2, 0 } },
    segment({ -0.6, 0, -0.6 }, { 0.6, 0, -0.6 }) };
}

/// A rod along z with an elliptic section of half axes a and b, 4 a long, with rounded ends.
inline std::vector<Point> ellipticRod(double a, double b, double spacing, unsigned seed)
{
  const Draw draw = [a, b](Random& random) {
    const double z = uniform(random, -3 * a, 3 * a);
    const double beyond = std::max(0., std::abs(z) - 2 * a) / a; // 0 ... 1 in the caps
    const Point around = direction(random);
    const double across = std::hypot(around.x(), around.y());
    const double shrink = std::sqrt(1 - beyond * beyond) / across;
    return Point(a * shrink * around.x(), b * shrink * around.y(), z);
  };
  return poissonDisk(draw, spacing, seed);
}

inline std::vector<Point> mirrored(std::vector<Point> points)
{
  for (Point& point : points)
  {
    point.x() = -point.x();
  }
  return points;
}
}

#endif
