// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Polygons.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace medial
{
namespace
{
/// Large polygons try so many fans at the most: a fan takes linear time.
constexpr Index fansTried = 32;

bool diagonalsAreNew(const std::vector<Index>& polygon, Index apex, const EdgeSet& edges)
{
  const Index n = count(polygon);
  for (Index k = 2; k + 1 < n; ++k)
  {
    if (edges.contains(polygon[apex], polygon[(apex + k) % n]))
    {
      return false;
    }
  }
  return true;
}

/// @param enough  a value of at most this much need not be the least
double leastArea(
  const std::vector<Index>& polygon, Index apex, const std::vector<Point>& points, double enough)
{
  const Index n = count(polygon);
  double least = std::numeric_limits<double>::infinity();
  const Point& a = points[polygon[apex]];
  for (Index k = 1; k + 1 < n && least > enough; ++k)
  {
    const Point &b = points[polygon[(apex + k) % n]], &c = points[polygon[(apex + k + 1) % n]];
    least = std::min(least, (b - a).cross(c - a).squaredNorm());
  }
  return least;
}

std::vector<Triangle> aroundCentroid(
  const std::vector<Index>& polygon, std::vector<Point>& points, EdgeSet& edges)
{
  Point centroid = Point::Zero();
  for (const Index p : polygon)
  {
    centroid += points[p] / static_cast<double>(polygon.size());
  }
  const Index center = count(points);
  points.push_back(centroid);
  std::vector<Triangle> result;
  for (Index k = 0; k < count(polygon); ++k)
  {
    edges.insert(center, polygon[k]);
    result.push_back({ center, polygon[k], polygon[(k + 1) % count(polygon)] });
  }
  return result;
}
}

IndexLists trianglesAtPoints(const std::vector<Triangle>& triangles, Index pointCount)
{
  return listsByKey(pointCount, [&triangles](const auto& add) {
    for (Index t = 0; t < count(triangles); ++t)
    {
      for (const Index corner : triangles[t])
      {
        add(corner, t);
      }
    }
  });
}

std::vector<Triangle> triangulate(
  const std::vector<Index>& polygon, std::vector<Point>& points, EdgeSet& edges)
{
  const Index n = count(polygon);
  if (n == 3)
  {
    return { { polygon[0], polygon[1], polygon[2] } };
  }
  Index best = None;
  double bestArea = -1;
  for (Index apex = 0; apex < std::min(n, fansTried); ++apex)
  {
    const double area = leastArea(polygon, apex, points, bestArea);
    if (area > bestArea && diagonalsAreNew(polygon, apex, edges))
    {
      best = apex;
      bestArea = area;
    }
  }
  if (best == None)
  {
    return aroundCentroid(polygon, points, edges);
  }
  std::vector<Triangle> result;
  for (Index k = 1; k + 1 < n; ++k)
  {
    if (k > 1)
    {
      edges.insert(polygon[best], polygon[(best + k) % n]);
    }
    result.push_back({ polygon[best], polygon[(best + k) % n], polygon[(best + k + 1) % n] });
  }
  return result;
}
}
