// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Balls/CrowdedPoles.h"

#include <algorithm>
#include <cmath>

using medial::Index;
using medial::None;
using medial::Point;
using medial::PolarBalls;
using medial::Side;
using pipelines::howMany;

namespace
{
/// For each sample its distance to the nearest other one.
std::vector<double> nearestDistances(const std::vector<Point>& samples)
{
  std::vector<double> result;
  for (const Point& sample : samples)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const Point& other : samples)
    {
      least = &other == &sample ? least : std::min(least, (other - sample).norm());
    }
    result.push_back(least);
  }
  return result;
}

bool isOn(const PolarBalls& balls, Index sample, Index ball)
{
  const auto own = balls.ballSamples[ball];
  return std::find(own.begin(), own.end(), sample) != own.end();
}

/// How many samples have an inner or outer ball on which they don't lie.
Index samplesOfOthersBalls(const PolarBalls& balls)
{
  Index result = 0;
  for (const std::vector<Index>* ofSample : { &balls.innerBall, &balls.outerBall })
  {
    for (Index s = 0; s < medial::count(*ofSample); ++s)
    {
      const Index ball = (*ofSample)[s];
      result += ball != None && !isOn(balls, s, ball);
    }
  }
  return result;
}
}

TEST(CrowdedPoles, LeaveFewBallsInATubeOfManySamples)
{
  constexpr double pi = 3.14159265358979;
  for (const double spacing : { 0.08, 0.06 })
  {
    const shapes::Shape torus = shapes::torus(spacing);
    const PolarBalls balls = medial::polarBalls(torus.samples);
    const double axis = 2 * pi * 2;
    // Each sample would have one of its own: 5,700 and 10,300, 37 and 49 in each spacing.
    EXPECT_LT(howMany(balls, Side::Inner), 8 * axis / spacing)
      << torus.samples.size() << " samples, seed " << torus.seed;
    EXPECT_GT(howMany(balls, Side::Inner), axis / spacing);
  }
}

TEST(CrowdedPoles, HaveABallThatTheirSamplesAreNearTo)
{
  const shapes::Shape torus = shapes::torus(0.07);
  const PolarBalls balls = medial::polarBalls(torus.samples);
  EXPECT_GT(samplesOfOthersBalls(balls), 0.5 * torus.samples.size());
  const std::vector<double> nearest = nearestDistances(torus.samples);
  for (const std::vector<Index>* ofSample : { &balls.innerBall, &balls.outerBall })
  {
    for (Index s = 0; s < medial::count(*ofSample); ++s)
    {
      ASSERT_NE((*ofSample)[s], None);
      const medial::Ball& ball = balls.balls[(*ofSample)[s]];
      ASSERT_LE(std::abs((balls.samples[s] - ball.center).norm() - ball.radius),
        medial::crowdPrecision * nearest[s]);
      ASSERT_EQ(validators::pointsInside(ball, torus.samples, 1e-9), 0);
    }
  }
}

TEST(CrowdedPoles, AreNotInShapesWithoutTubes)
{
  for (const shapes::Shape& shape : { shapes::ellipsoid(), shapes::head(), shapes::box() })
  {
    const PolarBalls balls = medial::polarBalls(shape.samples);
    EXPECT_EQ(samplesOfOthersBalls(balls), 0) << shape.name << ", seed " << shape.seed;
  }
}

TEST(CrowdedPoles, LeaveTheCrustNearTheSurface)
{
  const shapes::Shape torus = shapes::torus(0.07);
  const PolarBalls balls = medial::polarBalls(torus.samples);
  ASSERT_GT(samplesOfOthersBalls(balls), 0.5 * torus.samples.size());
  const medial::Crust crust = medial::powerCrust(balls);
  EXPECT_EQ(crust.betti, torus.betti);
  EXPECT_NEAR(crust.volume, torus.volume, 0.01 * torus.volume);
  double sum = 0; // with a ball for each pole: 0.069 spacings at most, 0.0018 on average
  for (const Point& point : crust.points)
  {
    sum += std::abs(torus.outside(point));
    ASSERT_LT(std::abs(torus.outside(point)), 0.08 * torus.spacing) << point.transpose();
  }
  EXPECT_LT(sum / crust.points.size(), 0.003 * torus.spacing);
}
