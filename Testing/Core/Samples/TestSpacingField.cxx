// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/SpacingField.h"

#include "Numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using medial::Point;
using medial::SpacingField;

constexpr unsigned seed = 5;

/// Points of a square and at most how much is allowed at each: little at a few.
struct Given
{
  std::vector<Point> points;
  std::vector<double> spacings;
};

Given given()
{
  shapes::Random random(seed);
  Given result;
  for (int i = 0; i < 2000; ++i)
  {
    const double x = shapes::uniform(random, 0, 1);
    result.points.emplace_back(x, shapes::uniform(random, 0, 1), 0);
    result.spacings.push_back(i % 400 == 0 ? 0.002 : shapes::uniform(random, 0.5, 1.5));
  }
  return result;
}

TEST(SpacingField, IsTheSameEverywhereIfNothingIsGiven)
{
  const SpacingField field(0.3);
  EXPECT_EQ(field.at(Point(7, 8, 9)), 0.3);
  EXPECT_FALSE(field.tightest());
}

TEST(SpacingField, IsAtMostWhatIsGiven)
{
  const Given all = given();
  const SpacingField field(0.3, all.points, all.spacings);
  for (std::size_t i = 0; i < all.points.size(); ++i)
  {
    EXPECT_LE(field.at(all.points[i]), all.spacings[i]);
    EXPECT_LE(field.at(all.points[i]), 0.3);
  }
}

/// It grows as slowly on the surface, not only from the points where little is given.
TEST(SpacingField, GrowsSlowlyOnTheSurface)
{
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  const Given all = given();
  const SpacingField field(0.3, all.points, all.spacings);
  shapes::Random engine(seed);
  for (int i = 0; i < 2000; ++i)
  {
    const Point &a = all.points[engine() % 2000], &b = all.points[engine() % 2000];
    constexpr double detour = 2; // of paths from neighbour to neighbour, at most
    EXPECT_LE(field.at(a), field.at(b) + detour * SpacingField::grading * (a - b).norm() + 1e-12);
  }
}

/// No less than what some point asks for with its distance.
TEST(SpacingField, IsNowhereLessThanAsked)
{
  const Given all = given();
  const SpacingField field(0.3, all.points, all.spacings);
  for (std::size_t i = 0; i < all.points.size(); i += 7)
  {
    double least = 0.3;
    for (std::size_t j = 0; j < all.points.size(); ++j)
    {
      const double distance = (all.points[j] - all.points[i]).norm();
      least = std::min(least, all.spacings[j] + SpacingField::grading * distance);
    }
    EXPECT_GE(field.at(all.points[i]), least - 1e-12);
  }
}

TEST(SpacingField, IsTheLargestFarAway)
{
  const SpacingField field(0.3, { Point::Zero() }, { 0.01 });
  EXPECT_EQ(field.at(Point::Zero()), 0.01);
  EXPECT_DOUBLE_EQ(field.at(Point(0.5, 0, 0)), 0.01 + SpacingField::grading * 0.5);
  EXPECT_EQ(field.at(Point(5, 0, 0)), 0.3);
  ASSERT_TRUE(field.tightest());
  EXPECT_EQ(*field.tightest(), Point(Point::Zero()));
}

TEST(SpacingField, CanBeHeldUp)
{
  const SpacingField field = SpacingField(0.3, { Point::Zero() }, { 0.01 }).atLeast(0.1);
  EXPECT_EQ(field.at(Point::Zero()), 0.1);
  EXPECT_EQ(field.at(Point(5, 0, 0)), 0.3);
}
}
