// SPDX-License-Identifier: BSD-3-Clause
#include "Validators.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace validators
{
NearestPoint::NearestPoint(std::vector<Point> thePoints)
  : points(std::move(thePoints))
  , order(this->points.size())
{
  std::iota(this->order.begin(), this->order.end(), 0);
  std::sort(this->order.begin(), this->order.end(),
    [this](Index a, Index b) { return this->points[a].x() < this->points[b].x(); });
  for (const Index i : this->order)
  {
    this->x.push_back(this->points[i].x());
  }
}

Index NearestPoint::operator()(const Point& place, Index except) const
{
  Index nearest = None;
  double best = std::numeric_limits<double>::infinity();
  const auto look = [&](std::size_t k) {
    const Index i = this->order[k];
    const double distance = (this->points[i] - place).norm();
    if (i != except && distance < best)
    {
      best = distance;
      nearest = i;
    }
  };
  const std::size_t start = static_cast<std::size_t>(
    std::lower_bound(this->x.begin(), this->x.end(), place.x()) - this->x.begin());
  std::size_t up = start, down = start;
  bool goUp = true, goDown = true;
  while (goUp || goDown)
  {
    goUp = up < this->x.size() && this->x[up] - place.x() < best;
    if (goUp)
    {
      look(up++);
    }
    goDown = down > 0 && place.x() - this->x[down - 1] < best;
    if (goDown)
    {
      look(--down);
    }
  }
  return nearest;
}

double NearestPoint::distance(const Point& place, Index except) const
{
  const Index nearest = (*this)(place, except);
  return nearest == None ? std::numeric_limits<double>::infinity()
                         : (this->points[nearest] - place).norm();
}

Index nearDuplicates(const std::vector<Point>& points, double tolerance)
{
  const NearestPoint nearest(points);
  Index result = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    result += nearest.distance(points[i], static_cast<Index>(i)) <= tolerance ? 1 : 0;
  }
  return result;
}

double meanSpacing(const std::vector<Point>& points)
{
  const NearestPoint nearest(points);
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    sum += nearest.distance(points[i], static_cast<Index>(i));
  }
  return sum / static_cast<double>(points.size());
}

double hausdorffDistance(const std::vector<Point>& from, const std::vector<Point>& to)
{
  const NearestPoint nearest(to);
  double largest = 0;
  for (const Point& point : from)
  {
    largest = std::max(largest, nearest.distance(point));
  }
  return largest;
}

double diagonal(const std::vector<Point>& points)
{
  Point lower = points.at(0), upper = points.at(0);
  for (const Point& point : points)
  {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  return (upper - lower).norm();
}

Point nearestOnTriangle(const Point& p, const Point& a, const Point& b, const Point& c)
{
  const Point u = b - a, v = c - a;
  const Point normal = u.cross(v);
  const double area = normal.squaredNorm();
  if (area > 0)
  {
    const double s = (p - a).cross(v).dot(normal) / area;
    const double t = u.cross(p - a).dot(normal) / area;
    if (s >= 0 && t >= 0 && s + t <= 1)
    {
      return a + s * u + t * v;
    }
  }
  Point best = a;
  const std::array<std::array<const Point*, 2>, 3> sides{ { { &a, &b }, { &b, &c }, { &c, &a } } };
  for (const auto& side : sides)
  {
    const Point along = *side[1] - *side[0];
    const double length = along.squaredNorm();
    const double t = length > 0 ? (p - *side[0]).dot(along) / length : 0;
    const Point candidate = *side[0] + std::clamp(t, 0.0, 1.0) * along;
    if ((candidate - p).norm() < (best - p).norm())
    {
      best = candidate;
    }
  }
  return best;
}

Index pointsInside(const Ball& ball, const std::vector<Point>& points, double tolerance)
{
  return static_cast<Index>(std::count_if(points.begin(), points.end(),
    [&](const Point& point) { return (point - ball.center).norm() < ball.radius - tolerance; }));
}

double clearance(const Point& point, const std::vector<Ball>& balls)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Ball& ball : balls)
  {
    least = std::min(least, (point - ball.center).norm() - ball.radius);
  }
  return least;
}

double orientation(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return (b - a).cross(c - a).dot(d - a);
}

bool samePolygons(const Polygons& a, const Polygons& b, double tolerance)
{
  if (a.points.size() != b.points.size() || a.polygons.size() != b.polygons.size())
  {
    return false;
  }
  const NearestPoint nearest(b.points);
  std::vector<Index> image;
  for (const Point& point : a.points)
  {
    image.push_back(nearest(point));
    if (image.back() == None || (b.points[image.back()] - point).norm() > tolerance)
    {
      return false;
    }
  }
  if (std::set<Index>(image.begin(), image.end()).size() != image.size())
  {
    return false;
  }
  std::multiset<std::set<Index>> carried, there;
  for (const std::vector<Index>& polygon : a.polygons)
  {
    std::set<Index> corners;
    for (const Index corner : polygon)
    {
      corners.insert(image[corner]);
    }
    carried.insert(corners);
  }
  for (const std::vector<Index>& polygon : b.polygons)
  {
    there.insert(std::set<Index>(polygon.begin(), polygon.end()));
  }
  return carried == there;
}
}
