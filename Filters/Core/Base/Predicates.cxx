// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Mpzf.h>

#include <cmath>
#include <limits>
#include <optional>

namespace medial
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
/// Sums and products of doubles without rounding. Rationals would do as well, but divide by common factors in
/// each step, which takes most of their time.
using Exact = CGAL::Mpzf;
using Rational = CGAL::Exact_rational;

Kernel::Point_3 kernelPoint(const Point& p)
{
  return { p.x(), p.y(), p.z() };
}

/// Rows a[i] . x = b[i] for the point x, relative to the first centre, of equal power to four balls.
template <typename Number>
struct PowerSystem
{
  Number a[3][3];
  Number b[3];

  explicit PowerSystem(const std::array<Ball, 4>& balls)
  {
    const Number r0 = Number(balls[0].radius);
    for (int i = 0; i < 3; ++i)
    {
      const Number r = Number(balls[i + 1].radius);
      this->b[i] = r0 * r0 - r * r;
      for (int k = 0; k < 3; ++k)
      {
        this->a[i][k] = Number(balls[i + 1].center[k]) - Number(balls[0].center[k]);
        this->b[i] += this->a[i][k] * this->a[i][k];
      }
      this->b[i] = this->b[i] * Number(0.5);
    }
  }

  /// Determinant of the rows with column k replaced by b (k = 3: none), and of the absolute values
  /// of all products in it, which bounds its rounding.
  std::array<Number, 2> determinant(int k, bool bound) const
  {
    const auto at = [this, k](int i, int j) { return j == k ? this->b[i] : this->a[i][j]; };
    Number sum(0), size(0);
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, l = (i + 2) % 3;
      const Number plus = at(0, i) * at(1, j) * at(2, l);
      const Number minus = at(0, i) * at(1, l) * at(2, j);
      sum += plus - minus;
      if (bound)
      {
        size += (plus < 0 ? -plus : plus) + (minus < 0 ? -minus : minus);
      }
    }
    return { sum, size };
  }
};

/// The double next to a / b towards zero. A division of doubles comes within few steps of it.
double quotient(const Exact& a, const Exact& b)
{
  const auto isTooLarge = [&](double q) { return abs(Exact(q) * b) > abs(a); };
  double q = a.to_double() / b.to_double();
  for (int step = 0; step < 4 && q != 0 && std::abs(q) < 1e300; ++step)
  {
    const double next = std::nextafter(q, std::copysign(1e308, q));
    if (isTooLarge(q))
    {
      q = std::nextafter(q, 0.0);
    }
    else if (isTooLarge(next))
    {
      return q;
    }
    else
    {
      q = next;
    }
  }
  return CGAL::to_double(Rational(Rational(a) / Rational(b)));
}

Point exactPowerCenter(const std::array<Ball, 4>& balls)
{
  const PowerSystem<Exact> system(balls);
  const Exact det = system.determinant(3, false)[0];
  Point result = Point::Constant(std::numeric_limits<double>::quiet_NaN());
  if (det == 0)
  {
    return result;
  }
  for (int k = 0; k < 3; ++k)
  {
    const Exact numerator = system.determinant(k, false)[0] + Exact(balls[0].center[k]) * det;
    result[k] = quotient(numerator, det);
  }
  return result;
}

/// Largest size of what is subtracted to get the right-hand sides.
double rightHandSize(const std::array<Ball, 4>& balls)
{
  double size = 0;
  for (int i = 1; i < 4; ++i)
  {
    size = std::max(size,
      (balls[i].center - balls[0].center).squaredNorm() + balls[0].radius * balls[0].radius +
        balls[i].radius * balls[i].radius);
  }
  return size;
}

/// Largest 2x2 minor of the rows: how much an error of a right-hand side moves a numerator.
double largestMinor(const std::array<Ball, 4>& balls)
{
  double size = 0;
  for (int i = 1; i < 4; ++i)
  {
    const Point u = balls[i].center - balls[0].center;
    const Point v = balls[i % 3 + 1].center - balls[0].center;
    size = std::max(size, u.norm() * v.norm());
  }
  return size;
}

/// In floating-point numbers; nothing where their rounding could exceed the tolerance.
template <typename Number>
std::optional<Point> roundedPowerCenter(const std::array<Ball, 4>& balls, double tolerance)
{
  const Number rounding = 16 * std::numeric_limits<Number>::epsilon();
  const PowerSystem<Number> system(balls);
  const auto [det, detSize] = system.determinant(3, true);
  const Number minors = 3 * largestMinor(balls) * rightHandSize(balls);
  Point result;
  for (int k = 0; k < 3; ++k)
  {
    const auto [numerator, size] = system.determinant(k, true);
    const Number x = numerator / det;
    const Number error = rounding * (size + minors + std::abs(x) * detSize) / std::abs(det);
    if (!(error <= tolerance)) // NaN is not <=
    {
      return std::nullopt;
    }
    result[k] = static_cast<double>(x + balls[0].center[k]);
  }
  return result;
}
}

int orientation(const Point& a, const Point& b, const Point& c, const Point& d)
{
  static const Kernel::Orientation_3 orient = Kernel().orientation_3_object();
  return static_cast<int>(orient(kernelPoint(a), kernelPoint(b), kernelPoint(c), kernelPoint(d)));
}

Point powerCenter(const std::array<Ball, 4>& balls, double tolerance)
{
  if (const auto center = roundedPowerCenter<double>(balls, tolerance))
  {
    return *center;
  }
  const auto center = roundedPowerCenter<long double>(balls, tolerance);
  return center ? *center : exactPowerCenter(balls);
}

Ball circumsphere(const std::array<Point, 4>& points, double tolerance)
{
  const Point center = powerCenter(
    { Ball{ points[0], 0 }, Ball{ points[1], 0 }, Ball{ points[2], 0 }, Ball{ points[3], 0 } },
    tolerance);
  return { center, (center - points[0]).norm() };
}
}
