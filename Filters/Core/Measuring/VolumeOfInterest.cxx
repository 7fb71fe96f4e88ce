// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/VolumeOfInterest.h"

#include "Base/Errors.h"
#include "Base/Frame.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{
constexpr double FullTurn = 6.28318530717958647693;

/// The corners of a flat convex polygon. Six cuts of a triangle leave at most nine.
using Polygon = std::vector<Point>;

using Box = Eigen::AlignedBox3d;

/// What of a polygon lies on one side of a plane: where sign * (coordinate - bound) <= 0.
void cut(Polygon& polygon, int axis, double bound, double sign)
{
  thread_local Polygon kept;
  kept.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double overA = sign * (a[axis] - bound), overB = sign * (b[axis] - bound);
    if (overA <= 0)
    {
      kept.push_back(a);
    }
    if ((overA < 0 && overB > 0) || (overA > 0 && overB < 0))
    {
      kept.push_back(a + (b - a) * (overA / (overA - overB)));
      kept.back()[axis] = bound;
    }
  }
  polygon.swap(kept);
}

void cut(Polygon& polygon, const Box& box, int axis)
{
  cut(polygon, axis, box.min()[axis], -1);
  cut(polygon, axis, box.max()[axis], 1);
}

Polygon cornersOf(const std::vector<Point>& points, const Triangle& t)
{
  return { points[t[0]], points[t[1]], points[t[2]] };
}

/// Its normal, as long as its area.
Point normalOf(const Polygon& polygon)
{
  Point result = Point::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    result += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]) / 2;
  }
  return result;
}

/// The volume between what of a polygon is higher than `height` and the floor there; negative where it looks
/// downwards.
double volumeAbove(Polygon polygon, double height)
{
  cut(polygon, 2, height, -1);
  double result = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
  {
    const Point &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
    result += normalOf(Polygon{ a, b, c }).z() * ((a.z() + b.z() + c.z()) / 3 - height);
  }
  return result;
}

/// The volume within the box below one triangle.
double volumeBelow(Polygon polygon, const Box& box)
{
  cut(polygon, box, 0);
  cut(polygon, box, 1);
  return volumeAbove(polygon, box.min().z()) - volumeAbove(polygon, box.max().z());
}

double angleAt(const Point& corner, const Point& a, const Point& b)
{
  const Point u = a - corner, v = b - corner;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}
}

Eigen::AlignedBox3d volumeOfInterest(
  const std::vector<Point>& samples, const std::optional<Box>& bounds, double margin)
{
  if (samples.empty() && !bounds)
  {
    throw InvalidInput("there are no samples to measure in the box of: give some, or bounds");
  }
  if (!std::isfinite(margin))
  {
    throw InvalidInput("a margin of ", margin, ": give a length");
  }
  Box box = bounds ? *bounds : boundingBox(samples);
  const Point least = box.min() + Point::Constant(margin),
              most = box.max() - Point::Constant(margin);
  if (!(least.array() < most.array()).all() || !least.allFinite() || !most.allFinite())
  {
    throw InvalidInput("nothing is left of the volume of interest, whose sides are ",
      box.sizes().x(), ", ", box.sizes().y(), " and ", box.sizes().z(), ", within a margin of ",
      margin, ": give larger bounds or a smaller margin");
  }
  return { least, most };
}

std::vector<Point> areasWithin(const Box& box, const std::vector<Point>& points,
  const std::vector<Triangle>& triangles, const Execution& execution)
{
  std::vector<Point> result(triangles.size());
  execution.forEach(count(triangles), [&](Index t) {
    Polygon polygon = cornersOf(points, triangles[t]);
    for (int axis = 0; axis < 3; ++axis)
    {
      cut(polygon, box, axis);
    }
    result[t] = normalOf(polygon);
  });
  return result;
}

double areaOf(const std::vector<Point>& areas)
{
  double sum = 0;
  for (const Point& area : areas)
  {
    sum += area.norm();
  }
  return sum;
}

double volumeWithin(const Box& box, const std::vector<Point>& points,
  const std::vector<Triangle>& triangles, const Execution& execution)
{
  std::vector<double> volumes(triangles.size());
  execution.forEach(count(triangles),
    [&](Index t) { volumes[t] = volumeBelow(cornersOf(points, triangles[t]), box); });
  double sum = 0;
  for (const double volume : volumes)
  {
    sum += volume;
  }
  return sum;
}

double eulerWithin(const Box& box, const std::vector<Point>& points,
  const std::vector<Triangle>& triangles, const Execution& execution)
{
  std::vector<double> angles(points.size(), 0);
  std::vector<char> used(points.size(), 0);
  for (Index t = 0; t < count(triangles); ++t)
  {
    execution.pollAt(t);
    for (int k = 0; k < 3; ++k)
    {
      const Index corner = triangles[t][k];
      used[corner] = 1;
      angles[corner] += angleAt(
        points[corner], points[triangles[t][(k + 1) % 3]], points[triangles[t][(k + 2) % 3]]);
    }
  }
  double turned = 0;
  for (Index p = 0; p < count(points); ++p)
  {
    turned += used[p] && box.contains(points[p]) ? FullTurn - angles[p] : 0;
  }
  return turned / (2 * FullTurn);
}
}
