// SPDX-License-Identifier: BSD-3-Clause
#include "Numbers.h"

#include "Base/Frame.h"
#include "Base/Predicates.h"

#include <gtest/gtest.h>

#include <array>

using medial::Ball;
using medial::Point;

namespace
{
/// A ball whose sphere passes exactly through a place: its centre is there plus a vector of whole numbers with
/// a whole length (2ac, 2bc, aa + bb - cc), scaled by a power of two.
Ball through(const Point& place, double a, double b, double c)
{
  const double scale = 1.0 / (1 << 24);
  const Point aside(2 * a * c, 2 * b * c, a * a + b * b - c * c);
  return { place + scale * aside, scale * (a * a + b * b + c * c) };
}

/// Four balls through a place; the smaller the step, the flatter the tetrahedron of their centres.
std::array<Ball, 4> flatBalls(const Point& place, double step)
{
  return { through(place, 1000, 2000, 3000), through(place, 1000 + step, 2000, 3000),
    through(place, 1000, 2000 + step, 3000), Ball{ place, 0 } };
}
}

TEST(Predicates, PowerCentersOfFlatTetrahedraAreRightToTheLastBits)
{
  const Point place(1, 2, 3);
  for (const double step : { 1000.0, 1.0, 1.0 / 64, 1.0 / 4096 })
  {
    const Point found = medial::powerCenter(flatBalls(place, step), medial::constructionError);
    EXPECT_LT((found - place).norm(), 4e-15) << "step " << step;
  }
}

TEST(Predicates, PowerCentersDoNotDependOnTheToleranceBeyondIt)
{
  shapes::Random random(1);
  for (int i = 0; i < 1000; ++i)
  {
    std::array<Ball, 4> balls;
    for (Ball& ball : balls)
    {
      ball = { shapes::direction(random), shapes::uniform(random, 0.5, 1) };
    }
    const Point rounded = medial::powerCenter(balls, 1e-9);
    const Point exact = medial::powerCenter(balls, 0);
    EXPECT_LT((rounded - exact).norm(), 2e-9 + 1e-15 * exact.norm());
  }
}

TEST(Predicates, CentresInAPlaneHaveNoPowerCenter)
{
  std::array<Ball, 4> balls = flatBalls(Point(1, 2, 3), 1);
  balls[3].center = balls[1].center + (balls[2].center - balls[0].center);
  EXPECT_FALSE(medial::powerCenter(balls, medial::constructionError).allFinite());
}
