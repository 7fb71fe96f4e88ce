// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/SiteView.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{
constexpr double degrees = 180 / 3.14159265358979323846;

/// Two points mirrored in a point, line or plane at the distance `half`, from `aside` beside it.
SiteView mirrored(double half, double aside)
{
  return { half > 0 ? 2 * std::atan2(half, aside) * degrees : 0, 2 * half };
}

/// How far beyond its first ball's centre, towards the second's, the spheres of two balls meet.
double meetingPlane(const Ball& a, const Ball& b, double distance)
{
  return (a.radius * a.radius - b.radius * b.radius + distance * distance) / (2 * distance);
}

SiteView ofThree(const std::vector<Ball>& corners)
{
  const Point &a = corners[0].center, &b = corners[1].center, &c = corners[2].center;
  const double d = (b - a).norm();
  const Point u = (b - a) / d;
  const double i = u.dot(c - a);
  const double j = (c - a - i * u).norm();
  const double x = meetingPlane(corners[0], corners[1], d);
  const double ra = corners[0].radius, rc = corners[2].radius;
  const double y = (ra * ra - rc * rc + i * i + j * j - 2 * i * x) / (2 * j);
  const double square = ra * ra - x * x - y * y;
  if (!(square > 0)) // also where the centres are on a line
  {
    return { 0, 0 };
  }
  return mirrored(std::sqrt(square), std::hypot(x - (d + i) / 3, y - j / 3));
}
}

SiteView siteView(const Point& from, const std::vector<Point>& sites)
{
  SiteView result{ 0, 0 };
  for (std::size_t k = 0; k < sites.size(); ++k)
  {
    for (std::size_t l = 0; l < k; ++l)
    {
      const Point u = sites[k] - from, v = sites[l] - from;
      const double angle = std::atan2(u.cross(v).norm(), u.dot(v)) * degrees;
      result.objectAngle = std::max(result.objectAngle, angle);
      result.lambda = std::max(result.lambda, (sites[k] - sites[l]).norm());
    }
  }
  return result;
}

SiteView siteView(const std::vector<Ball>& corners)
{
  if (corners.size() == 1)
  {
    return mirrored(corners[0].radius, 0);
  }
  if (corners.size() == 3)
  {
    return ofThree(corners);
  }
  const double d = (corners[1].center - corners[0].center).norm();
  const double x = meetingPlane(corners[0], corners[1], d);
  const double square = corners[0].radius * corners[0].radius - x * x;
  return square > 0 ? mirrored(std::sqrt(square), std::abs(x - d / 2)) : SiteView{ 0, 0 };
}
}
