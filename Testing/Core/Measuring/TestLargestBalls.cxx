// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/LargestBalls.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <vector>

using medial::Ball;
using medial::Index;
using medial::LargestBalls;
using medial::None;
using medial::Point;
using medial::PolarBalls;
using medial::Side;

namespace
{
Index largestByLoop(const PolarBalls& balls, Side side, const Point& place, double tolerance)
{
  Index result = None;
  for (Index b = 0; b < medial::count(balls.balls); ++b)
  {
    const Ball& ball = balls.balls[b];
    if (balls.sides[b] == side && !balls.touchesGuard[b] &&
      (ball.center - place).norm() <= ball.radius + tolerance &&
      (result == None || ball.radius > balls.balls[result].radius))
    {
      result = b;
    }
  }
  return result;
}
}

TEST(LargestBalls, AreThoseOfALoopOverAll)
{
  for (const shapes::Shape& shape : { shapes::knot(), shapes::box() })
  {
    SCOPED_TRACE(testing::Message() << shape.name << ", seed " << shape.seed);
    const PolarBalls balls = medial::polarBalls(shape.samples);
    const double tolerance = 0.25 * balls.spacing;
    for (const Side side : { Side::Inner, Side::Outer })
    {
      const LargestBalls tree(balls, side, [&](Index b) { return !balls.touchesGuard[b]; });
      const std::vector<Index> atSamples = largestBallsAt(balls, side, balls.samples, tolerance);
      for (std::size_t s = 0; s < balls.samples.size(); s += 7)
      {
        const Index expected = largestByLoop(balls, side, balls.samples[s], tolerance);
        ASSERT_EQ(atSamples[s], expected);
        ASSERT_EQ(tree.around(balls.samples[s], tolerance), expected);
      }
    }
  }
}

TEST(LargestBalls, AreThoseOfALoopOverAllInTheVolume)
{
  const PolarBalls balls = medial::polarBalls(shapes::knot().samples);
  std::vector<Point> places = shapes::cloud(100000, 3); // more than are looked at together
  for (Point& place : places)
  {
    place *= 4;
  }
  for (const Side side : { Side::Inner, Side::Outer })
  {
    const std::vector<Index> found = medial::largestBallsAt(balls, side, places, 0);
    for (std::size_t i = 0; i < places.size(); i += 501)
    {
      ASSERT_EQ(found[i], largestByLoop(balls, side, places[i], 0));
    }
  }
}

TEST(LargestBalls, TakeTheLowestNumberOfSeveral)
{
  PolarBalls balls;
  balls.balls = { { Point(2, 0, 0), 1 }, { Point(-1, 0, 0), 2 }, { Point(1, 0, 0), 2 },
    { Point(0, 0, 0), 1 } };
  balls.sides = { Side::Inner, Side::Inner, Side::Inner, Side::Inner };
  EXPECT_EQ(LargestBalls(balls, Side::Inner).around(Point::Zero()), 1);
  EXPECT_EQ(LargestBalls(balls, Side::Inner).around(Point(9, 0, 0)), None);
  EXPECT_EQ(LargestBalls(balls, Side::Outer).around(Point::Zero()), None);
}

TEST(LargestBalls, HoldASampleOfEachWallOnce)
{
  const shapes::Shape shape = shapes::twoHolePlate();
  const PolarBalls balls = medial::polarBalls(shape.samples);
  for (const Index ball :
    medial::largestBallsAt(balls, Side::Inner, balls.samples, 0.25 * balls.spacing))
  {
    ASSERT_NE(ball, None); // each sample is on its own inner ball
  }
}
