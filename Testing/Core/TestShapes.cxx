// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "Validators.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

using namespace validators;

TEST(Shapes, SamplesLieOnTheBoundaryOneSpacingApart)
{
  for (const shapes::Shape& shape : shapes::all())
  {
    SCOPED_TRACE(testing::Message() << shape.name << ", seed " << shape.seed);
    EXPECT_GE(shape.samples.size(), 200u);
    EXPECT_EQ(nearDuplicates(shape.samples, 0.99 * shape.spacing), 0);
    for (const Point& sample : shape.samples)
    {
      ASSERT_NEAR(shape.outside(sample), 0, 1e-12);
    }
  }
}

TEST(Shapes, LeaveNoGap)
{
  const std::vector<std::pair<shapes::Shape, shapes::Shape>> draws{
    { shapes::box(0.1, 1), shapes::box(0.1, 9) }, { shapes::torus(0.2, 1), shapes::torus(0.2, 9) },
    { shapes::knot(0.17, 1), shapes::knot(0.17, 9) },
    { shapes::twoHolePlate(0.09, 1), shapes::twoHolePlate(0.09, 9) }
  };
  for (const auto& [shape, other] : draws)
  {
    SCOPED_TRACE(testing::Message() << shape.name << ", seeds 1 and 9");
    EXPECT_LT(hausdorffDistance(other.samples, shape.samples), 1.1 * shape.spacing);
  }
}

TEST(Shapes, DistanceToTheAxisIsTheRadiusOfTheBallsAtTheSamples)
{
  EXPECT_NEAR(shapes::sphere().axisDistance(Point(0, 0, 1)), 1, 1e-12);
  EXPECT_NEAR(shapes::box().axisDistance(Point(0, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(shapes::box().axisDistance(Point(1.5, 1, 0)), 0, 1e-12);
  EXPECT_NEAR(shapes::box().axisDistance(Point(0, 0, 0.5)), 0.5, 1e-12);
  EXPECT_NEAR(shapes::ellipsoid().axisDistance(Point(0.3, 0.2, 0.1)), 0.1, 1e-12);
  EXPECT_NEAR(shapes::ellipsoid().axisDistance(Point(1.5, 0, 0)), 1.0 / 6, 1e-9);
  EXPECT_NEAR(shapes::hollowSphere().axisDistance(Point(0, 0, 1)), 0.25, 1e-12);
}

TEST(Shapes, MotionsAreUndone)
{
  const std::vector<Point> points = shapes::capsule().samples;
  EXPECT_LT(hausdorffDistance(points, shapes::rotated(shapes::rotated(points, 4), 4, true)), 1e-12);
  EXPECT_GT(hausdorffDistance(points, shapes::rotated(points, 4)), 0.1);
  EXPECT_EQ(shapes::scaled(shapes::scaled(points, 1024), 1.0 / 1024), points);
  const std::vector<Index> order = shapes::shuffledOrder(points.size(), 7);
  EXPECT_EQ(hausdorffDistance(points, shapes::reordered(points, order)), 0);
  EXPECT_NE(shapes::reordered(points, order), points);
}

TEST(Shapes, FloatsAreRoundedToTheLastOne)
{
  for (const Point& point :
    shapes::roundedToFloats(shapes::moved(shapes::sphere().samples, Point(3e6, 5e5, 2e6))))
  {
    for (const double coordinate : point)
    {
      ASSERT_EQ(std::fmod(coordinate, 1.0 / 32), 0);
    }
  }
}

TEST(Shapes, AreTheSameInEveryRun)
{
  EXPECT_EQ(shapes::sphere(0.3, 5).samples, shapes::sphere(0.3, 5).samples);
  EXPECT_NE(shapes::sphere(0.3, 5).samples, shapes::sphere(0.3, 6).samples);
}
