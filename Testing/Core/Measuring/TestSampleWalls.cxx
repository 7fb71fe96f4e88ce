// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/SampleWalls.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using medial::Ball;
using medial::Index;
using medial::Point;
using medial::PolarBalls;
using medial::SampleWall;
using medial::Side;

namespace
{
/// The gradient of the distance.
std::vector<Point> exactNormals(const shapes::Shape& shape)
{
  constexpr double step = 1e-5;
  std::vector<Point> result;
  for (const Point& p : shape.samples)
  {
    Point slope;
    for (int k = 0; k < 3; ++k)
    {
      Point more = p, less = p;
      more[k] += step;
      less[k] -= step;
      slope[k] = shape.outside(more) - shape.outside(less);
    }
    result.push_back(slope.normalized());
  }
  return result;
}

/// The largest error of the wall distance of inner balls, where their distance from the boundary is known.
double largestError(const shapes::Shape& shape, const PolarBalls& balls)
{
  const std::vector<double> distances = wallDistances(balls, sampleWalls(balls));
  double result = 0;
  for (std::size_t b = 0; b < balls.balls.size(); ++b)
  {
    if (balls.sides[b] == Side::Inner)
    {
      const double truth = -shape.outside(balls.balls[b].center);
      result = std::max(result, std::abs(distances[b] - truth) / truth);
    }
  }
  return result;
}

double largestBulge(const shapes::Shape& shape, const PolarBalls& balls)
{
  double result = 0;
  for (std::size_t b = 0; b < balls.balls.size(); ++b)
  {
    if (balls.sides[b] == Side::Inner)
    {
      const double truth = -shape.outside(balls.balls[b].center);
      result = std::max(result, balls.balls[b].radius / truth - 1);
    }
  }
  return result;
}
}

TEST(SampleWalls, NormalsAreThoseOfTheSurface)
{
  for (const shapes::Shape& shape :
    { shapes::sphere(), shapes::torus(), shapes::hollowSphere(0.08) })
  {
    SCOPED_TRACE(testing::Message() << shape.name << ", seed " << shape.seed);
    const std::vector<Point> exact = exactNormals(shape);
    const std::vector<SampleWall> walls = sampleWalls(medial::polarBalls(shape.samples));
    double worst = 1;
    for (std::size_t s = 0; s < walls.size(); ++s)
    {
      worst = std::min(worst, walls[s].normal.dot(exact[s]));
    }
    EXPECT_GT(worst, std::cos(0.1));
  }
}

TEST(SampleWalls, CurvatureIsThatOfTheSurface)
{
  // Outwards the normals of a sphere of radius 1 turn by as much as one goes.
  for (const bool isKnown : { false, true })
  {
    const shapes::Shape shape = shapes::sphere(0.1);
    PolarBalls balls = medial::polarBalls(shape.samples);
    if (isKnown)
    {
      balls.normals = shape.samples;
    }
    for (const SampleWall& wall : sampleWalls(balls))
    {
      const Point along = wall.normal.unitOrthogonal();
      EXPECT_NEAR(along.dot(wall.curvature * along), -1, 0.1);
      EXPECT_NEAR((wall.curvature * wall.normal).norm(), 0, 1e-12);
    }
  }
}

TEST(SampleWalls, DistancesAreRightWhereBallsBulge)
{
  for (const shapes::Shape& shape : { shapes::twoHolePlate(0.1), shapes::hollowSphere(0.12) })
  {
    SCOPED_TRACE(testing::Message() << shape.name << ", seed " << shape.seed);
    PolarBalls balls = medial::polarBalls(shape.samples);
    const double bulge = largestBulge(shape, balls);
    EXPECT_LT(largestError(shape, balls), 0.5 * bulge) << "fitted normals";
    balls.normals = exactNormals(shape);
    EXPECT_LT(largestError(shape, balls), 0.5 * bulge) << "exact normals";
  }
}

TEST(SampleWalls, DistancesAreRightInTubes)
{
  const shapes::Shape shape = shapes::torus();
  EXPECT_LT(largestError(shape, medial::polarBalls(shape.samples)), 0.006);
}

TEST(SampleWalls, DistancesAreRadiiWhereNoWallIsKnown)
{
  PolarBalls balls = medial::polarBalls(shapes::torus().samples);
  const std::vector<SampleWall> none(balls.samples.size());
  const std::vector<double> distances = wallDistances(balls, none);
  for (std::size_t b = 0; b < distances.size(); ++b)
  {
    EXPECT_EQ(distances[b], balls.balls[b].radius);
  }
}
