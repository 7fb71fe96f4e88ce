// SPDX-License-Identifier: BSD-3-Clause
#include "Numbers.h"

#include "Base/Tetrahedra.h"
#include "Base/Triangulations.h"

#include <gtest/gtest.h>

#include <vector>

using medial::Point;
using medial::Tetrahedron;

namespace
{
/// As singular points: on a few spheres up to rounding, many on each.
std::vector<Point> pointsOnSpheres(shapes::Random& random)
{
  std::vector<Point> result;
  for (int sphere = 0; sphere < 8; ++sphere)
  {
    const Point center = shapes::uniformInBox(random, Point(1, 1, 1));
    for (int i = 0; i < 60; ++i)
    {
      result.push_back(center + 0.3 * shapes::direction(random));
    }
  }
  return result;
}

std::vector<Tetrahedron> sortedCells(const std::vector<Point>& points)
{
  std::vector<Tetrahedron> cells = medial::delaunay(points).cells;
  medial::sortCells(cells);
  return cells;
}
}

// Decisions that are not exact contradict each other. Which ones are asked for depends on where the axes are, because
// these order the points.
TEST(Triangulations, delaunayOfPointsOnSpheresDoesNotDependOnTheAxes)
{
  shapes::Random random(7);
  std::vector<Point> points = pointsOnSpheres(random);
  const std::vector<Tetrahedron> cells = sortedCells(points);
  EXPECT_GT(cells.size(), points.size());
  for (int turn = 0; turn < 6; ++turn)
  {
    for (Point& p : points)
    {
      p = turn % 3 == 2 ? Point(-p.y(), -p.z(), -p.x()) : Point(p.y(), p.z(), p.x());
    }
    EXPECT_EQ(sortedCells(points), cells) << turn;
  }
}
