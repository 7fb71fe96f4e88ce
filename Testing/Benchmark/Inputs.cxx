// SPDX-License-Identifier: BSD-3-Clause
#include "Inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace inputs
{
namespace
{
using shapes::cosine;
using shapes::direction;
using shapes::dot;
using shapes::length;
using shapes::sine;
using shapes::uniform;
using shapes::uniformInBox;
using shapes::unit;

using Curve = std::function<Point(double)>;
using Distance = std::function<double(const Point&)>;

constexpr double pi = 3.14159265358979323846;

Point circle(double t)
{
  return { 2 * cosine(t), 2 * sine(t), 0 };
}

Point trefoil(double t)
{
  return { sine(t) + 2 * sine(2 * t), cosine(t) - 2 * cosine(2 * t), -sine(3 * t) };
}

/// On the tube about a closed curve with parameter 0 ... 2 pi.
Point onTube(const Curve& curve, double radius, Random& random)
{
  const double t = uniform(random, 0, 2 * pi);
  const Point tangent = unit(curve(t + 1e-5) - curve(t - 1e-5));
  const Point any = direction(random);
  return curve(t) + radius * unit(any - dot(any, tangent) * tangent);
}

/// Around a segment of length 3 along x.
Point onCapsule(Random& random)
{
  const double radius = 0.5, half = 1.5, middle = uniform(random, 0, 2 * (half + radius));
  const Point any = direction(random);
  if (middle > 2 * half)
  {
    return radius * any + Point(any.x() < 0 ? -half : half, 0, 0);
  }
  return Point(middle - half, 0, 0) + radius * unit(Point(0, any.y(), any.z()));
}

Point onBumpySphere(Random& random)
{
  const Point d = direction(random);
  const double bumps = sine(6 * d.x()) + sine(6 * d.y() + 1) + sine(6 * d.z() + 2);
  return d * (1 + 0.06 * bumps);
}

/// The right half of a plate about a rectangle in the plane x = 0, rounded at its rim.
Point onHalfPlate(Random& random)
{
  const double radius = 0.1;
  const Point wide(0, 1 + radius, 0.7 + radius);
  const Point place = uniformInBox(random, wide);
  const Point foot(0, std::clamp(place.y(), -1.0, 1.0), std::clamp(place.z(), -0.7, 0.7));
  const double outwards = std::min(1.0, length(place - foot) / radius);
  return outwards < 1 ? Point(place + radius * std::sqrt(1 - outwards * outwards) * Point(1, 0, 0))
                      : onHalfPlate(random);
}

Point turned(const Point& p)
{
  const double c = cosine(0.7), s = sine(0.7);
  const Point q(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
  return { q.x(), c * q.y() - s * q.z(), s * q.y() + c * q.z() };
}

double toSegment(const Point& p, const Point& a, const Point& b)
{
  const Point along = b - a;
  return length(p - a - std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0) * along);
}

/// Smaller than both; smooth where they are nearly the same.
double smoothMinimum(double a, double b)
{
  const double width = 0.15, h = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - h * h * width / 4;
}

/// A shaft with two knobs and a thin arch beside it.
double toBone(const Point& p)
{
  const double shaft = toSegment(p, Point(-1.5, 0, 0), Point(1.5, 0, 0)) - 0.25;
  const double knobs =
    std::min(length(p - Point(-1.6, 0, 0)) - 0.5, length(p - Point(1.6, 0.1, 0)) - 0.6);
  const double around = std::hypot(p.x(), std::max(p.y(), 0.0)) - 0.8;
  const double arch = std::hypot(around, p.z(), std::min(p.y(), 0.0)) - 0.1;
  return smoothMinimum(smoothMinimum(shaft, knobs), arch);
}

/// On the surface where a distance is 0: Newton's steps from a place near it.
Point onLevel(const Distance& distance, const Point& corner, Random& random)
{
  const double step = 1e-5;
  Point p;
  do
  {
    p = uniformInBox(random, corner);
  }
  while (std::abs(distance(p)) > 0.08);
  for (int i = 0; i < 4; ++i)
  {
    Point slope;
    for (int k = 0; k < 3; ++k)
    {
      const Point aside = step * Point::Unit(k);
      slope[k] = (distance(p + aside) - distance(p - aside)) / (2 * step);
    }
    p -= distance(p) / dot(slope, slope) * slope;
  }
  return p;
}

/// Accepted points by the cubes that they are in; a cube is as wide as the spacing.
class Darts
{
public:
  Darts(double theSpacing, Index most)
    : spacing(theSpacing)
  {
    while (static_cast<Index>(this->first.size()) < 2 * most)
    {
      this->first.resize(2 * this->first.size(), medial::None);
    }
  }

  bool isFree(const Point& point) const
  {
    for (int i = 0; i < 27; ++i)
    {
      const Point aside(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      for (Index other = this->first[this->slot(point + this->spacing * aside)];
           other != medial::None; other = this->next[other])
      {
        if (length(this->points[other] - point) < this->spacing)
        {
          return false;
        }
      }
    }
    return true;
  }

  void add(const Point& point)
  {
    Index& head = this->first[this->slot(point)];
    this->next.push_back(head);
    head = static_cast<Index>(this->points.size());
    this->points.push_back(point);
  }

  std::vector<Point> points;

private:
  std::size_t slot(const Point& point) const
  {
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k)
    {
      const auto cube = static_cast<std::int64_t>(std::floor(point[k] / this->spacing));
      hash = (hash ^ static_cast<std::uint64_t>(cube)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return hash & (this->first.size() - 1);
  }

  double spacing;
  std::vector<Index> first{ medial::None }; ///< a power of two of them
  std::vector<Index> next;
};

constexpr int throwsPerSample = 12;

/// At most `count` points, this far apart.
std::vector<Point> thrown(const Input& input, double spacing, Index count)
{
  Random random(1);
  Darts darts(spacing, count);
  for (Index i = 0; i < throwsPerSample * count; ++i)
  {
    const Point point = input.draw(random);
    if (static_cast<Index>(darts.points.size()) < count && darts.isFree(point))
    {
      darts.add(point);
    }
  }
  return darts.points;
}
}

const std::vector<Input>& all()
{
  const auto onBone = [](Random& random) { return onLevel(toBone, Point(2.3, 1.1, 0.8), random); };
  static const std::vector<Input> list{
    { "bumpy_sphere", onBumpySphere, false },
    { "bone", onBone, false },
    { "slab", onHalfPlate, true },
    { "slab_in_x", onHalfPlate, true },
    { "torus", [](Random& random) { return onTube(circle, 0.7, random); }, false },
    { "capsule", onCapsule, false },
    { "tube", [](Random& random) { return onTube(trefoil, 0.35, random); }, false },
  };
  return list;
}

std::vector<Point> samples(const Input& input, Index count)
{
  // How many points have room falls with the square of their spacing; a spacing of which some more
  // points have room than are wanted.
  const Index few = 1000, wanted = input.mirrored ? count / 2 : count;
  double spacing = 0.2;
  for (int i = 0; i < 6; ++i)
  {
    const Index room = static_cast<Index>(thrown(input, spacing, 4 * few).size());
    spacing *= std::sqrt(static_cast<double>(room) / few);
  }
  spacing *= 0.97 * std::sqrt(static_cast<double>(few) / wanted);
  std::vector<Point> result = thrown(input, spacing, wanted);
  if (input.mirrored)
  {
    for (Index i = static_cast<Index>(result.size()); i-- > 0;)
    {
      if (2 * result[i].x() > spacing)
      {
        result.emplace_back(-result[i].x(), result[i].y(), result[i].z());
      }
    }
  }
  if (input.name == "slab")
  {
    std::transform(result.begin(), result.end(), result.begin(), turned);
  }
  return result;
}
}
