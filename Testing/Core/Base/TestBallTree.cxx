// SPDX-License-Identifier: BSD-3-Clause
#include "Base/BallTree.h"

#include "Numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using medial::Ball;
using medial::BallTree;
using medial::count;
using medial::Index;
using medial::Point;

namespace
{
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr unsigned seed = 7;

struct Case
{
  std::string name;
  std::vector<Ball> balls;
  std::vector<Point> queries;
};

double distanceByLoop(const std::vector<Ball>& balls, const Point& x)
{
  double least = infinity;
  for (const Ball& ball : balls)
  {
    least = std::min(least, (x - ball.center).norm() - ball.radius);
  }
  return least;
}

double protrusionByLoop(
  const std::vector<Ball>& balls, const std::vector<Index>& groups, const Ball& ball, Index group)
{
  double least = infinity;
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    if (groups[i] != group)
    {
      least =
        std::min(least, (balls[i].center - ball.center).norm() + ball.radius - balls[i].radius);
    }
  }
  return std::max(0.0, least);
}

Index largestByLoop(const std::vector<Ball>& balls, const Point& x, double tolerance)
{
  Index result = medial::None;
  for (Index i = 0; i < count(balls); ++i)
  {
    const bool isAround = (balls[i].center - x).norm() <= balls[i].radius + tolerance;
    if (isAround && (result == medial::None || balls[i].radius > balls[result].radius))
    {
      result = i;
    }
  }
  return result;
}

Index leastPowerByLoop(const std::vector<Ball>& balls, const Point& x)
{
  const auto power = [&](Index i) {
    const double distance = (balls[i].center - x).norm();
    return (distance - balls[i].radius) * (distance + balls[i].radius);
  };
  Index result = 0;
  for (Index i = 1; i < count(balls); ++i)
  {
    result = power(i) < power(result) ? i : result;
  }
  return result;
}

/// Numbers without pattern, the same in every run.
class Source
{
public:
  double number(double low, double high) { return shapes::uniform(this->engine, low, high); }
  Point point(double size)
  {
    return { this->number(-size, size), this->number(-size, size), this->number(-size, size) };
  }
  Point gridPoint(int size) { return this->point(size + 0.5).array().round(); }

private:
  shapes::Random engine{ seed };
};

/// Balls and queries that `make(source)` gives, one after another.
template <typename MakeBall, typename MakeQuery>
Case randomCase(
  const std::string& name, int size, const MakeBall& makeBall, const MakeQuery& makeQuery)
{
  Source source;
  Case result{ name, {}, {} };
  for (int i = 0; i < size; ++i)
  {
    result.balls.push_back(makeBall(source));
  }
  for (int i = 0; i < 300; ++i)
  {
    result.queries.push_back(makeQuery(source));
  }
  for (const Ball& ball : result.balls)
  {
    result.queries.push_back(ball.center);
    result.queries.push_back(ball.center + ball.radius * Point::UnitX());
  }
  return result;
}

Point anywhere(Source& source)
{
  return source.point(2);
}

/// Balls as they come, and in unusual arrangements.
void addOrdinary(std::vector<Case>& result)
{
  const auto onGrid = [](Source& source) { return source.gridPoint(4); };
  for (const int size : { 1, 7, 8, 9, 1000 })
  {
    result.push_back(randomCase(
      "random, " + std::to_string(size), size,
      [](Source& source) {
        return Ball{ source.point(1), source.number(0, 0.3) };
      },
      anywhere));
  }
  result.push_back(randomCase(
    "points", 500,
    [](Source& source) {
      return Ball{ source.point(1), 0 };
    },
    anywhere));
  result.push_back(randomCase(
    "one centre", 100,
    [](Source& source) {
      return Ball{ Point(0.1, 0.2, 0.3), source.number(0, 1) };
    },
    anywhere));
  result.push_back(randomCase(
    "the same ball", 100,
    [](Source&) {
      return Ball{ Point(0.1, 0.2, 0.3), 0.4 };
    },
    anywhere));
  result.push_back(randomCase(
    "a grid with ties", 500,
    [](Source& source) {
      return Ball{ source.gridPoint(3), std::round(source.number(0, 2)) };
    },
    onGrid));
}

/// Balls for which a bound of the search is tight or its rounding matters.
void addDegenerate(std::vector<Case>& result)
{
  result.push_back(randomCase(
    "a plane", 500,
    [](Source& source) {
      const Point p = source.point(1);
      return Ball{ Point(p.x(), p.y(), 1.0 / 3), 0.1 };
    },
    anywhere));
  result.push_back(randomCase(
    "one large ball among small ones", 500,
    [](Source& source) {
      return Ball{ source.point(1), source.number(0, 1) > 0.99 ? 3 : 1e-9 };
    },
    anywhere));
  // All spheres pass through the origin, as polar balls pass through a sample.
  result.push_back(randomCase(
    "through one point", 1000,
    [](Source& source) {
      const Point center = source.point(1);
      return Ball{ center, center.norm() };
    },
    [](Source& source) { return source.point(1e-15); }));
  result.push_back(randomCase(
    "far from the origin", 500,
    [](Source& source) {
      return Ball{ Point::Constant(1e9) + source.point(1), 0.1 };
    },
    [](Source& source) { return Point(Point::Constant(1e9) + source.point(2)); }));
  result.push_back(randomCase(
    "squares that underflow", 500,
    [](Source& source) {
      return Ball{ source.point(1e-160), source.number(0, 1e-162) };
    },
    [](Source& source) { return source.point(2e-160); }));
}

std::vector<Case> cases()
{
  std::vector<Case> result;
  addOrdinary(result);
  addDegenerate(result);
  return result;
}

std::vector<Index> groupsOf(const std::vector<Ball>& balls, Index groupCount)
{
  Source source;
  std::vector<Index> groups;
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    groups.push_back(static_cast<Index>(source.number(0, groupCount)));
  }
  return groups;
}
}

TEST(BallTree, DistanceIsThatOfALoopOverAllBallsToTheLastBit)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(testing::Message() << c.name << ", seed " << seed);
    const BallTree tree(c.balls);
    for (const Point& query : c.queries)
    {
      const double distance = distanceByLoop(c.balls, query);
      ASSERT_EQ(tree.distance(query), distance);
      ASSERT_TRUE(tree.isWithin(query, distance));
      ASSERT_FALSE(tree.isWithin(query, std::nextafter(distance, -infinity)));
    }
  }
}

TEST(BallTree, ProtrusionIsThatOfALoopOverAllBallsToTheLastBit)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(testing::Message() << c.name << ", seed " << seed);
    for (const Index groupCount : { 1, 2, 20 })
    {
      const std::vector<Index> groups = groupsOf(c.balls, groupCount);
      const BallTree tree(c.balls, groups);
      for (Index i = 0; i < count(c.balls); ++i)
      {
        ASSERT_EQ(tree.protrusion(c.balls[i], groups[i]),
          protrusionByLoop(c.balls, groups, c.balls[i], groups[i]));
      }
    }
  }
}

TEST(BallTree, LargestAroundIsThatOfALoopOverAllBalls)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(testing::Message() << c.name << ", seed " << seed);
    const BallTree tree(c.balls);
    for (const double tolerance : { 0.0, 0.1 })
    {
      for (const Point& query : c.queries)
      {
        ASSERT_EQ(tree.largestAround(query, tolerance), largestByLoop(c.balls, query, tolerance));
      }
    }
  }
}

TEST(BallTree, LeastPowerIsThatOfALoopOverAllBalls)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(testing::Message() << c.name << ", seed " << seed);
    const BallTree tree(c.balls);
    for (const Point& query : c.queries)
    {
      ASSERT_EQ(tree.leastPower(query), leastPowerByLoop(c.balls, query));
    }
  }
}

TEST(BallTree, StopsAtWhatIsEnough)
{
  for (const Case& c : cases())
  {
    SCOPED_TRACE(testing::Message() << c.name << ", seed " << seed);
    const BallTree tree(c.balls);
    for (const Point& query : c.queries)
    {
      const double exact = distanceByLoop(c.balls, query);
      for (const double enough : { exact - 0.1, exact, exact + 0.1 })
      {
        const double found = tree.distance(query, enough);
        ASSERT_GE(found, exact);
        ASSERT_TRUE(found == exact || found <= enough);
      }
    }
  }
}

TEST(BallTree, WithoutOtherBallsIsInfinitelyFar)
{
  EXPECT_EQ(BallTree({}).distance(Point::Zero()), infinity);
  EXPECT_EQ(BallTree({}, {}).protrusion({ Point::Zero(), 1 }, 0), infinity);
  const BallTree tree({ { Point::Zero(), 1 }, { Point::UnitX(), 1 } }, { 3, 3 });
  EXPECT_EQ(tree.protrusion({ Point::Zero(), 1 }, 3), infinity);
  EXPECT_EQ(tree.protrusion({ Point::Zero(), 1 }, 4), 0);
}

TEST(BallTree, DistanceIsNegativeInside)
{
  const BallTree tree({ { Point::Zero(), 2 }, { Point(10, 0, 0), 1 } });
  EXPECT_EQ(tree.distance(Point(0, 0.5, 0)), -1.5);
  EXPECT_EQ(tree.distance(Point(2, 0, 0)), 0);
  EXPECT_EQ(tree.distance(Point(7, 0, 0)), 2);
}

TEST(BoundingDiagonal, SpansTheBallsNotTheirCentres)
{
  EXPECT_EQ(medial::boundingDiagonal({}), 0);
  EXPECT_DOUBLE_EQ(medial::boundingDiagonal({ { Point::Zero(), 1 } }), std::sqrt(12.0));
  EXPECT_DOUBLE_EQ(
    medial::boundingDiagonal({ { Point::Zero(), 1 }, { Point(3, 0, 0), 1 } }), std::sqrt(33.0));
}
