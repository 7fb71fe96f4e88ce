// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Axis/SingularPoints.h"

#include <algorithm>
#include <set>

using medial::Index;
using medial::None;
using medial::Point;
using medial::Side;
using pipelines::forEachShape;
using pipelines::Pipeline;

TEST(SingularPoints, LieOnEachOfTheirBalls)
{
  forEachShape([](Pipeline& p) {
    const medial::SingularPoints& sites = p.sites();
    ASSERT_EQ(sites.balls.size(), medial::count(sites.positions));
    for (Index i = 0; i < sites.balls.size(); ++i)
    {
      for (const Index b : sites.balls[i])
      {
        const medial::Ball& ball = p.balls().balls[b];
        // Samples are on balls up to their precision.
        const double error = (sites.samples[i] == None ? 1e-9 : 1e-7) * p.diagonal;
        ASSERT_NEAR((sites.positions[i] - ball.center).norm(), ball.radius, error)
          << "site " << i << ", sample " << sites.samples[i];
      }
    }
  });
}

TEST(SingularPoints, BallsAreInnerAndInOrder)
{
  forEachShape([](Pipeline& p) {
    for (Index i = 0; i < p.sites().balls.size(); ++i)
    {
      const auto balls = p.sites().balls[i];
      ASSERT_GE(balls.size(), 1);
      ASSERT_TRUE(std::is_sorted(balls.begin(), balls.end(), std::less_equal<>()));
      ASSERT_TRUE(std::all_of(
        balls.begin(), balls.end(), [&](Index b) { return p.balls().sides[b] == Side::Inner; }));
      ASSERT_TRUE(p.sites().samples[i] != None || balls.size() >= 3);
    }
  });
}

TEST(SingularPoints, ThatAreSamplesAreKnownByIt)
{
  forEachShape([](Pipeline& p) {
    const medial::SingularPoints& sites = p.sites();
    std::set<Index> seen;
    for (Index i = 0; i < medial::count(sites.samples); ++i)
    {
      const Index sample = sites.samples[i];
      if (sample != None)
      {
        ASSERT_EQ(sites.positions[i], p.shape.samples[sample]);
        ASSERT_TRUE(seen.insert(sample).second) << "sample " << sample << " twice";
      }
    }
  });
}

TEST(SingularPoints, ThatAreSamplesListAllInnerBallsThroughThem)
{
  forEachShape([](Pipeline& p) {
    const medial::PolarBalls& balls = p.balls();
    std::vector<std::vector<Index>> through(p.shape.samples.size());
    for (Index b = 0; b < balls.ballSamples.size(); ++b)
    {
      for (const Index s : balls.ballSamples[b])
      {
        if (balls.sides[b] == Side::Inner)
        {
          through[s].push_back(b);
        }
      }
    }
    std::vector<std::vector<Index>> listed(p.shape.samples.size());
    for (Index i = 0; i < p.sites().balls.size(); ++i)
    {
      const auto list = p.sites().balls[i];
      if (p.sites().samples[i] != None)
      {
        listed[p.sites().samples[i]].assign(list.begin(), list.end());
      }
    }
    EXPECT_EQ(listed, through); // every sample on an inner ball is there
  });
}

TEST(SingularPoints, AreThereOnce)
{
  forEachShape([](Pipeline& p) {
    EXPECT_EQ(validators::nearDuplicates(p.sites().positions, 1e-9 * p.diagonal), 0);
  });
}

TEST(SingularPoints, LieOnTheBoundaryOfTheUnion)
{
  // Few are a little inside a fourth inner ball: those nearer (in power) to an outer one.
  forEachShape([](Pipeline& p) {
    std::vector<medial::Ball> inner;
    for (std::size_t b = 0; b < p.balls().balls.size(); ++b)
    {
      if (p.balls().sides[b] == Side::Inner)
      {
        inner.push_back(p.balls().balls[b]);
      }
    }
    Index inside = 0;
    for (const Point& site : p.sites().positions)
    {
      const double depth = -validators::clearance(site, inner);
      inside += depth > 1e-8 * p.diagonal ? 1 : 0;
      ASSERT_LT(depth, 0.2 * p.shape.spacing);
    }
    EXPECT_LT(static_cast<double>(inside) / p.sites().positions.size(), 0.02);
  });
}

TEST(SingularPoints, LieNearTheBoundaryOfTheSolid)
{
  forEachShape([](Pipeline& p) {
    for (const Point& site : p.sites().positions)
    {
      ASSERT_LT(std::abs(p.shape.outside(site)), p.shape.spacing);
    }
  });
}

TEST(SingularPoints, MoveWithTheSamples)
{
  const std::vector<Point> samples = shapes::capsule(0.2).samples;
  const auto sitesOf = [](const std::vector<Point>& points) {
    const medial::PolarBalls balls = medial::polarBalls(points);
    return medial::singularPoints(balls, medial::powerShape(balls));
  };
  const medial::SingularPoints reference = sitesOf(samples);
  medial::SingularPoints small = sitesOf(shapes::scaled(samples, 0.0625));
  small.positions = shapes::scaled(small.positions, 16);
  EXPECT_EQ(pipelines::bytesOf(small), pipelines::bytesOf(reference));
  // Which of several flat cells there are at a sample is up to rounding, so single sites differ.
  const medial::SingularPoints turned = sitesOf(shapes::rotated(samples, 5));
  const std::vector<Point> back = shapes::rotated(turned.positions, 5, true);
  EXPECT_NEAR(static_cast<double>(back.size()) / reference.positions.size(), 1, 0.02);
  const double tolerance = 1e-7 * validators::diagonal(samples);
  const validators::NearestPoint nearest(reference.positions);
  const auto elsewhere = std::count_if(back.begin(), back.end(),
    [&](const Point& site) { return nearest.distance(site) > tolerance; });
  EXPECT_LT(static_cast<double>(elsewhere) / back.size(), 0.02);
}

TEST(SingularPoints, AreTheSameOnManyThreads)
{
  Pipeline& p = pipelines::of("two-hole plate");
  const auto sites = medial::singularPoints(p.balls(), p.powerShape(), pipelines::threaded());
  EXPECT_EQ(pipelines::bytesOf(sites), pipelines::bytesOf(p.sites()));
}
