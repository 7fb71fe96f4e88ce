// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"

#include "PoissonDisk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace shapes
{
namespace
{
using Distance = std::function<double(const Point&)>;
using Projection = std::function<Point(const Point&)>;

constexpr double pi = 3.14159265358979323846;

/// All points within a radius of an axis. The axis is that solid's medial axis.
struct Offset
{
  Projection axis; ///< its point nearest to a place
  double radius;
  Point corner; ///< of a box about the origin that holds the axis
};

Draw surfaceOf(const Offset& solid)
{
  return [solid](Random& random) {
    const Point corner = solid.corner + Point::Constant(2 * solid.radius);
    while (true)
    {
      const Point place = uniformInBox(random, corner);
      const Point foot = solid.axis(place);
      const double distance = length(place - foot);
      if (distance > 0.2 * solid.radius && distance < 2 * solid.radius)
      {
        return Point(foot + (solid.radius / distance) * (place - foot));
      }
    }
  };
}

/// A point on the tube about a curve with parameter 0 ... 2 pi.
Draw tubeAbout(const std::function<Point(double)>& curve, double radius)
{
  return [curve, radius](Random& random) {
    const double t = uniform(random, 0, 2 * pi);
    const Point tangent = unit(curve(t + 1e-5) - curve(t - 1e-5));
    const Point any = direction(random);
    return Point(curve(t) + radius * unit(any - dot(any, tangent) * tangent));
  };
}

Shape offsetShape(const std::string& name, const Offset& solid, double spacing, unsigned seed,
  const Betti& betti, const Draw& draw = {})
{
  Shape shape;
  shape.name = name;
  shape.samples = poissonDisk(draw ? draw : surfaceOf(solid), spacing, seed);
  shape.seed = seed;
  shape.spacing = spacing;
  shape.betti = betti;
  shape.volume = 0;
  shape.smooth = true;
  shape.axisDistance = [axis = solid.axis](const Point& p) { return (p - axis(p)).norm(); };
  shape.outside = [distance = shape.axisDistance, radius = solid.radius](
                    const Point& p) { return distance(p) - radius; };
  return shape;
}

Projection circle(double radius, const Point& centre = Point::Zero())
{
  return [=](const Point& p) {
    const Point out(p.x() - centre.x(), p.y() - centre.y(), 0);
    const double distance = length(out);
    return distance > 0 ? Point(centre + out * (radius / distance))
                        : Point(centre + Point(radius, 0, 0));
  };
}

/// The nearest point of a closed curve with parameter 0 ... 2 pi: nearest of many, then bisection.
Projection closedCurve(const std::function<Point(double)>& curve)
{
  constexpr int steps = 400;
  std::vector<Point> table;
  for (int i = 0; i < steps; ++i)
  {
    table.push_back(curve(2 * pi * i / steps));
  }
  return [curve, table](const Point& p) {
    const auto nearer = [&p](const Point& a, const Point& b) {
      return (a - p).squaredNorm() < (b - p).squaredNorm();
    };
    const auto nearest = std::min_element(table.begin(), table.end(), nearer) - table.begin();
    double parameter = 2 * pi * static_cast<double>(nearest) / steps;
    for (double step = 2 * pi / steps; step > 1e-12; step /= 2)
    {
      for (const double candidate : { parameter - step, parameter + step })
      {
        parameter = nearer(curve(candidate), curve(parameter)) ? candidate : parameter;
      }
    }
    return curve(parameter);
  };
}

/// Moves a shape.
Shape shifted(Shape shape, const Point& by)
{
  shape.samples = moved(shape.samples, by);
  shape.outside = [outside = shape.outside, by](const Point& p) { return outside(p - by); };
  shape.axisDistance = [axis = shape.axisDistance, by](const Point& p) { return axis(p - by); };
  return shape;
}

/// A flat plate about the plane z = 0 with two round holes.
struct Plate
{
  double x = 1.4, y = 0.8, hole = 0.35, holeAt = 0.65;

  Point nearest(const Point& p) const
  {
    const Point clamped(
      std::clamp(p.x(), -this->x, this->x), std::clamp(p.y(), -this->y, this->y), 0);
    const Point centre(p.x() < 0 ? -this->holeAt : this->holeAt, 0, 0);
    const bool inHole = length(clamped - centre) < this->hole;
    return inHole ? circle(this->hole, centre)(p) : clamped;
  }

  /// Volume within `radius` of it: prisms, half cylinders, corners, and half tori in the holes.
  double offsetVolume(double radius) const
  {
    const double area = 4 * this->x * this->y - 2 * pi * this->hole * this->hole;
    const double halfDisk = pi * radius * radius / 2;
    const double halfTorus = halfDisk * 2 * pi * (this->hole - 4 * radius / (3 * pi));
    return 2 * radius * area + halfDisk * 4 * (this->x + this->y) +
      4.0 / 3.0 * pi * radius * radius * radius + 2 * halfTorus;
  }
};
}

Shape sphere(double spacing, unsigned seed)
{
  const Offset solid{ [](const Point&) { return Point(0, 0, 0); }, 1, Point::Zero() };
  Shape shape = offsetShape("sphere", solid, spacing, seed, { 1, 0, 0 });
  shape.volume = 4.0 / 3.0 * pi;
  return shape;
}

Shape ellipsoid(double spacing, unsigned seed)
{
  const Point half(1.5, 1, 0.5);
  Shape shape;
  shape.name = "ellipsoid";
  shape.samples = poissonDisk(
    [half](Random& random) { return Point(direction(random).cwiseProduct(half)); }, spacing, seed);
  shape.seed = seed;
  shape.spacing = spacing;
  shape.betti = { 1, 0, 0 };
  shape.volume = 4.0 / 3.0 * pi * half.prod();
  shape.smooth = true;
  shape.outside = [half](const Point& p) {
    const double level = p.cwiseQuotient(half).norm();
    const double slope = p.cwiseQuotient(half.cwiseProduct(half)).norm();
    return level > 0 ? (level - 1) * level / slope : -half.z();
  };
  // The evolute's flat ellipse: where the curvature spheres of the long sections end.
  const double a = half.x() - half.z() * half.z() / half.x();
  const double b = half.y() - half.z() * half.z() / half.y();
  const Projection rim =
    closedCurve([a, b](double t) { return Point(a * std::cos(t), b * std::sin(t), 0); });
  shape.axisDistance = [a, b, rim](const Point& p) {
    return std::hypot(p.x() / a, p.y() / b) <= 1 ? std::abs(p.z()) : (p - rim(p)).norm();
  };
  return shape;
}

Shape torus(double spacing, unsigned seed)
{
  Shape shape =
    offsetShape("torus", { circle(2), 0.7, Point(2, 2, 0) }, spacing, seed, { 1, 1, 0 });
  shape.volume = 2 * pi * pi * 2 * 0.7 * 0.7;
  return shape;
}

Shape capsule(double spacing, unsigned seed)
{
  const Projection segment = [](const Point& p) {
    return Point(std::clamp(p.x(), -1.5, 1.5), 0, 0);
  };
  Shape shape =
    offsetShape("capsule", { segment, 0.5, Point(1.5, 0, 0) }, spacing, seed, { 1, 0, 0 });
  shape.volume = pi * 0.5 * 0.5 * 3 + 4.0 / 3.0 * pi * 0.125;
  return shape;
}

Shape knot(double spacing, unsigned seed)
{
  const auto trefoil = [](double t) {
    return Point(sine(t) + 2 * sine(2 * t), cosine(t) - 2 * cosine(2 * t), -sine(3 * t));
  };
  const double radius = 0.35;
  Shape shape = offsetShape("knot", { closedCurve(trefoil), radius, Point(3, 3, 1) }, spacing, seed,
    { 1, 1, 0 }, tubeAbout(trefoil, radius));
  double around = 0;
  for (int i = 0; i < 10000; ++i)
  {
    around += (trefoil(2 * pi * (i + 1) / 10000) - trefoil(2 * pi * i / 10000)).norm();
  }
  shape.volume = pi * radius * radius * around;
  return shape;
}

Shape twoHolePlate(double spacing, unsigned seed)
{
  const Plate plate;
  const double radius = 0.2;
  const Offset solid{ [plate](const Point& p) { return plate.nearest(p); }, radius,
    Point(plate.x, plate.y, 0) };
  Shape shape = offsetShape("two-hole plate", solid, spacing, seed, { 1, 2, 0 });
  shape.volume = plate.offsetVolume(radius);
  return shape;
}

Shape hollowSphere(double spacing, unsigned seed)
{
  const Projection middle = [](const Point& p) {
    return length(p) > 0 ? Point(0.75 * unit(p)) : Point(0.75, 0, 0);
  };
  Shape shape = offsetShape(
    "hollow sphere", { middle, 0.25, Point::Constant(0.75) }, spacing, seed, { 1, 0, 1 });
  shape.volume = 4.0 / 3.0 * pi * (1 - 0.125);
  return shape;
}

Shape twoObjects(double spacing, unsigned seed)
{
  const Offset point{ [](const Point&) { return Point(0, 0, 0); }, 0.9, Point::Zero() };
  const Offset ring{ circle(1.1), 0.35, Point(1.1, 1.1, 0) };
  const Shape ball = shifted(offsetShape("", point, spacing, seed, {}), Point(-2, 0, 0));
  const Shape loop = shifted(offsetShape("", ring, spacing, seed + 1, {}), Point(1.5, 0, 0));
  Shape shape = ball;
  shape.name = "two objects";
  shape.samples.insert(shape.samples.end(), loop.samples.begin(), loop.samples.end());
  shape.betti = { 2, 1, 0 };
  shape.volume = 4.0 / 3.0 * pi * 0.9 * 0.9 * 0.9 + 2 * pi * pi * 1.1 * 0.35 * 0.35;
  shape.outside = [a = ball.outside, b = loop.outside](
                    const Point& p) { return std::min(a(p), b(p)); };
  shape.axisDistance = [a = ball.axisDistance, b = loop.axisDistance](
                         const Point& p) { return std::min(a(p), b(p)); };
  return shape;
}

Shape head(double spacing, unsigned seed)
{
  struct Ellipsoid
  {
    Point centre, half;
    /// Right in sign, and near 0.
    double outside(const Point& p) const
    {
      const double level = length((p - this->centre).cwiseQuotient(this->half));
      return (level - 1) * this->half.minCoeff();
    }
  };
  const Point half(0.5, 0.15, 0.4);
  const std::array<Ellipsoid, 3> solids{ Ellipsoid{ Point::Zero(), Point::Ones() },
    Ellipsoid{ Point(-1.1, 0, 0), half }, Ellipsoid{ Point(1.1, 0, 0), half } };
  Shape shape{};
  shape.name = "head";
  shape.outside = [solids](const Point& p) {
    return std::min({ solids[0].outside(p), solids[1].outside(p), solids[2].outside(p) });
  };
  const Draw draw = [solids, outside = shape.outside](Random& random) {
    while (true)
    {
      const Ellipsoid& solid = solids[random() % solids.size()];
      const Point point = solid.centre + direction(random).cwiseProduct(solid.half);
      if (outside(point) > -1e-12)
      {
        return point;
      }
    }
  };
  shape.samples = poissonDisk(draw, spacing, seed);
  shape.seed = seed;
  shape.spacing = spacing;
  shape.betti = { 1, 0, 0 };
  shape.smooth = false;
  return shape;
}

const std::vector<Shape>& all()
{
  static const std::vector<Shape> shapes{ sphere(), ellipsoid(), torus(), capsule(), knot(),
    twoHolePlate(), hollowSphere(), twoObjects(), box() };
  return shapes;
}

std::vector<Point> gridCube(int perEdge)
{
  std::vector<Point> result;
  for (int i = 0; i < perEdge * perEdge * perEdge; ++i)
  {
    const std::array<int, 3> at{ i % perEdge, i / perEdge % perEdge, i / perEdge / perEdge };
    const bool onBoundary =
      std::any_of(at.begin(), at.end(), [perEdge](int k) { return k == 0 || k == perEdge - 1; });
    if (onBoundary)
    {
      result.emplace_back(at[0], at[1], at[2]);
    }
  }
  return result;
}

std::vector<Point> openBowl()
{
  std::vector<Point> points = sphere().samples;
  points.erase(
    std::remove_if(points.begin(), points.end(), [](const Point& p) { return p.z() > 0.3; }),
    points.end());
  return points;
}

std::vector<Point> cloud(int size, unsigned seed)
{
  Random random(seed);
  std::vector<Point> points;
  for (int i = 0; i < size; ++i)
  {
    points.push_back(uniformInBox(random, Point(0.5, 0.5, 0.5)));
  }
  return points;
}
}
