// SPDX-License-Identifier: BSD-3-Clause
#include "Numbers.h"

#include <cmath>

namespace shapes
{
namespace
{
constexpr double pi = 3.14159265358979323846;

/// The sum of the Taylor series whose terms begin with `first` of this degree, for angles up to pi / 4.
double series(double angle, double first, int degree)
{
  double sum = 0, term = first;
  for (int k = degree; k < degree + 18; k += 2)
  {
    sum += term;
    term *= -angle * angle / ((k + 1) * (k + 2));
  }
  return sum;
}

/// cos(angle + quarters pi / 2).
double turnedCosine(double angle, int quarters)
{
  const double nearest = std::floor(angle / (pi / 2) + 0.5);
  const double rest = angle - nearest * (pi / 2);
  switch ((static_cast<int>(nearest) + quarters) & 3)
  {
    case 0:
      return series(rest, 1, 0);
    case 1:
      return -series(rest, rest, 1);
    case 2:
      return -series(rest, 1, 0);
    default:
      return series(rest, rest, 1);
  }
}
}

double uniform(Random& random, double from, double to)
{
  return from + (to - from) * (static_cast<double>(random()) / 4294967296.0);
}

Point uniformInBox(Random& random, const Point& corner)
{
  Point result;
  for (int k = 0; k < 3; ++k)
  {
    result[k] = uniform(random, -corner[k], corner[k]);
  }
  return result;
}

Point direction(Random& random)
{
  while (true)
  {
    const Point p = uniformInBox(random, Point(1, 1, 1));
    if (length(p) <= 1 && length(p) > 0.1)
    {
      return unit(p);
    }
  }
}

double normal(Random& random, double deviation)
{
  double sum = -6;
  for (int i = 0; i < 12; ++i)
  {
    sum += uniform(random, 0, 1);
  }
  return deviation * sum;
}

Point normalPoint(Random& random, double deviation)
{
  Point result;
  for (double& coordinate : result)
  {
    coordinate = normal(random, deviation);
  }
  return result;
}

double sine(double angle)
{
  return turnedCosine(angle, 3);
}

double cosine(double angle)
{
  return turnedCosine(angle, 0);
}

double dot(const Point& a, const Point& b)
{
  return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

double length(const Point& vector)
{
  return std::sqrt(dot(vector, vector));
}

Point unit(const Point& vector)
{
  return vector / length(vector);
}
}
