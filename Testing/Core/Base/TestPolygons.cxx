// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Polygons.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using medial::EdgeSet;
using medial::Index;
using medial::Point;
using medial::Triangle;
using medial::triangulate;

namespace
{
constexpr double pi = 3.14159265358979323846;

/// A regular polygon, counter-clockwise seen from above.
std::vector<Point> regular(Index size)
{
  std::vector<Point> points;
  for (Index i = 0; i < size; ++i)
  {
    const double angle = 2 * pi * i / size;
    points.emplace_back(std::cos(angle), std::sin(angle), 0);
  }
  return points;
}

std::vector<Index> corners(Index size)
{
  std::vector<Index> result;
  for (Index i = 0; i < size; ++i)
  {
    result.push_back(i);
  }
  return result;
}

EdgeSet sides(Index size)
{
  EdgeSet edges;
  for (Index i = 0; i < size; ++i)
  {
    edges.insert(i, (i + 1) % size);
  }
  return edges;
}

/// Sum over the triangles; negative where one is turned.
double area(const std::vector<Triangle>& triangles, const std::vector<Point>& points)
{
  double sum = 0;
  for (const Triangle& t : triangles)
  {
    const double own = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).z() / 2;
    EXPECT_GT(own, 0);
    sum += own;
  }
  return sum;
}
}

TEST(Polygons, AreCoveredByTheirTriangles)
{
  for (Index size = 3; size < 50; ++size)
  {
    std::vector<Point> points = regular(size);
    EdgeSet edges = sides(size);
    const std::vector<Triangle> triangles = triangulate(corners(size), points, edges);
    EXPECT_EQ(medial::count(triangles), size - 2);
    EXPECT_EQ(medial::count(points), size);
    EXPECT_NEAR(area(triangles, points), size / 2.0 * std::sin(2 * pi / size), 1e-12);
  }
}

TEST(Polygons, AvoidDiagonalsThatAreEdgesElsewhere)
{
  std::vector<Point> points = regular(4);
  EdgeSet edges = sides(4);
  edges.insert(0, 2);
  const std::vector<Triangle> triangles = triangulate(corners(4), points, edges);
  ASSERT_EQ(triangles.size(), 2u);
  EXPECT_EQ(points.size(), 4u);
  EXPECT_TRUE(edges.contains(1, 3)); // for the polygons after this one
  EXPECT_NEAR(area(triangles, points), 2, 1e-12);
}

TEST(Polygons, GetTheirCentroidWhereNoDiagonalIsNew)
{
  std::vector<Point> points = regular(4);
  EdgeSet edges = sides(4);
  edges.insert(0, 2);
  edges.insert(1, 3);
  const std::vector<Triangle> triangles = triangulate(corners(4), points, edges);
  ASSERT_EQ(triangles.size(), 4u);
  ASSERT_EQ(points.size(), 5u);
  EXPECT_LT(points[4].norm(), 1e-15);
  EXPECT_NEAR(area(triangles, points), 2, 1e-12);
  for (Index corner = 0; corner < 4; ++corner)
  {
    EXPECT_TRUE(edges.contains(corner, 4));
  }
}

TEST(Polygons, TakeTheFanWithTheLargestSmallestTriangle)
{
  // A trapezium with a corner in the middle of its long side: only a fan from there has no flat triangle.
  std::vector<Point> points{ { -1, 0, 0 }, { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 1, 0 },
    { -0.5, 1, 0 } };
  EdgeSet edges = sides(5);
  const std::vector<Triangle> triangles = triangulate(corners(5), points, edges);
  EXPECT_NEAR(area(triangles, points), 1.5, 1e-12);
}
