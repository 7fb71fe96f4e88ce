// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/StartCells.h"
#include "Base/Triangulations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using medial::Ball;
using medial::count;
using medial::Index;
using medial::Point;
using medial::StartCells;
using medial::Tetrahedra;

namespace
{
constexpr Index onRing = 1000;
constexpr double turn = 2 * 3.14159265358979323846 / onRing;

/// A ball in the middle of a ring of others, and one above and below: the first one has two cells for each of the ring.
std::vector<Ball> wheel()
{
  std::vector<Ball> balls{ { { 0, 0, 0 }, 0.1 }, { { 0, 0, 1 }, 0.1 }, { { 0, 0, -1 }, 0.1 } };
  for (Index i = 0; i < onRing; ++i)
  {
    balls.push_back({ { std::cos(i * turn), std::sin(i * turn), 0 }, 0.1 });
  }
  return balls;
}

Tetrahedra triangulated(const std::vector<Ball>& balls)
{
  medial::RegularTriangulation triangulation;
  triangulation.insert(balls);
  return triangulation.tetrahedra();
}
}

TEST(StartCells, OfABallWithManyCellsLieInTheDirectionOfThePoint)
{
  const std::vector<Ball> balls = wheel();
  const Tetrahedra mesh = triangulated(balls);
  const StartCells starts(mesh, balls);
  ASSERT_EQ(starts.cellCount(0), 2 * onRing);
  for (Index i = 0; i < onRing; ++i)
  {
    const Point direction(std::cos(i * turn), std::sin(i * turn), 0);
    const medial::Tetrahedron& cell = mesh.cells[starts.towards(2 * direction, 0)];
    ASSERT_NE(std::find(cell.begin(), cell.end(), 0), cell.end());
    Point middle(0, 0, 0); // of the cell's balls on the ring
    for (const Index ball : cell)
    {
      middle += ball > 2 ? balls[ball].center : Point(0, 0, 0);
    }
    EXPECT_GT(middle.normalized().dot(direction), 0.9) << "direction " << i;
  }
}

TEST(StartCells, OfABallWithFewCellsIsOneOfThem)
{
  const std::vector<Ball> balls = wheel();
  const Tetrahedra mesh = triangulated(balls);
  const StartCells starts(mesh, balls);
  for (Index ball = 3; ball < count(balls); ++ball)
  {
    ASSERT_LT(starts.cellCount(ball), 10);
    const medial::Tetrahedron& cell = mesh.cells[starts.towards({ 0, 0, 5 }, ball)];
    EXPECT_NE(std::find(cell.begin(), cell.end(), ball), cell.end()) << "ball " << ball;
  }
}
