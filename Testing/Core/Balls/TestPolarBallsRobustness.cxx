// SPDX-License-Identifier: BSD-3-Clause
// What must not change the balls: unit, place, order, threads; and what they refuse.
#include "Pipelines.h"

#include "Balls/PolarBalls.h"

#include <cmath>
#include <limits>
#include <string>

using medial::Index;
using medial::None;
using medial::Point;
using medial::PolarBalls;
using medial::Side;
using pipelines::howMany;
using pipelines::Pipeline;

namespace
{
std::string messageOf(const std::vector<Point>& samples, const medial::MergeOptions& options = {})
{
  try
  {
    medial::polarBallsAndSamples(samples, options);
  }
  catch (const medial::InvalidInput& error)
  {
    return error.what();
  }
  return "";
}
}

TEST(PolarBalls, ScaleWithTheSamplesToTheLastBit)
{
  const std::vector<Point> samples = shapes::capsule(0.2).samples;
  const PolarBalls reference = medial::polarBalls(samples);
  for (const int exponent : { -20, -3, 1, 20 })
  {
    SCOPED_TRACE(testing::Message() << "2^" << exponent);
    const double factor = std::ldexp(1, exponent);
    const PolarBalls balls = medial::polarBalls(shapes::scaled(samples, factor));
    EXPECT_EQ(pipelines::bytesOf(balls), pipelines::bytesOf(pipelines::inUnits(reference, factor)));
  }
}

TEST(PolarBalls, AreAsManyInAnyUnitAndPlace)
{
  for (const shapes::Shape& shape : { shapes::capsule(0.2), shapes::twoHolePlate(0.11) })
  {
    const PolarBalls reference = medial::polarBalls(shape.samples);
    const std::vector<std::vector<Point>> others{ shapes::scaled(shape.samples, 1e-6),
      shapes::scaled(shape.samples, 1e6), shapes::moved(shape.samples, Point(37, -11, 5)),
      shapes::rotated(shape.samples, 3) };
    for (std::size_t i = 0; i < others.size(); ++i)
    {
      SCOPED_TRACE(testing::Message() << shape.name << ", motion " << i);
      const PolarBalls balls = medial::polarBalls(others[i]);
      EXPECT_EQ(howMany(balls, Side::Inner), howMany(reference, Side::Inner));
      EXPECT_EQ(howMany(balls, Side::Outer), howMany(reference, Side::Outer));
    }
  }
}

TEST(PolarBalls, DependOnTheOrderOfSamplesInTheirNumbersOnly)
{
  const std::vector<Point> samples = shapes::capsule(0.2).samples;
  const PolarBalls reference = medial::polarBalls(samples);
  for (unsigned seed = 0; seed < 3; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const std::vector<Index> order = shapes::shuffledOrder(samples.size(), seed);
    const PolarBalls balls = medial::polarBalls(shapes::reordered(samples, order));
    ASSERT_EQ(balls.balls.size(), reference.balls.size());
    for (std::size_t i = 0; i < samples.size(); ++i)
    {
      const auto center = [](const PolarBalls& b, Index ball) {
        return ball == None ? Point(0, 0, 0) : b.balls[ball].center;
      };
      EXPECT_EQ(
        center(balls, balls.innerBall[i]), center(reference, reference.innerBall[order[i]]));
      EXPECT_EQ(
        center(balls, balls.outerBall[i]), center(reference, reference.outerBall[order[i]]));
    }
  }
}

TEST(PolarBalls, AreTheSameOnManyThreadsAndInEveryRun)
{
  for (const char* name : { "two-hole plate", "box" })
  {
    SCOPED_TRACE(name);
    Pipeline& p = pipelines::of(name);
    EXPECT_EQ(
      pipelines::bytesOf(medial::polarBallsAndSamples(p.shape.samples, {}, pipelines::threaded())),
      pipelines::bytesOf(p.ballsAndSamples()));
  }
}

TEST(PolarBalls, ReportProgressAndStop)
{
  const std::vector<Point> samples = shapes::torus(0.3).samples;
  pipelines::expectProgressAndAbort(
    [&](const medial::Execution& execution) { medial::polarBalls(samples, execution); });
}

TEST(PolarBalls, RefuseTooFewSamples)
{
  EXPECT_NE(messageOf({}), "");
  EXPECT_NE(messageOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }).find("4"), std::string::npos);
  EXPECT_NE(messageOf(std::vector<Point>(50, Point(1, 2, 3))).find("distinct"), std::string::npos);
  EXPECT_NE(
    messageOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 1, 0 }, { 1, 0, 0 } }).find("distinct"),
    std::string::npos);
}

TEST(PolarBalls, RefuseSamplesOnALine)
{
  std::vector<Point> line;
  for (int i = 0; i < 30; ++i)
  {
    line.push_back(Point(0.1, 0.2, 0.3) + 0.1 * i * Point(1, 2, -0.7));
  }
  EXPECT_NE(messageOf(line).find("line"), std::string::npos);
}

TEST(PolarBalls, RefuseSamplesInAPlane)
{
  std::vector<Point> plane, tilted;
  for (int i = 0; i < 100; ++i)
  {
    plane.emplace_back(i % 10, i / 10, 0.25);
    tilted.push_back(
      Point(3, 1, 2) + i % 10 * Point(0.1, 0.7, 0.3) + i / 10 * Point(0.4, -0.1, 0.2));
  }
  EXPECT_NE(messageOf(plane).find("plane"), std::string::npos);
  EXPECT_NE(messageOf(tilted).find("plane"), std::string::npos);
}

TEST(PolarBalls, RefuseTwoDistantSpecksBecauseOfTheirSize)
{
  std::vector<Point> specks;
  for (int i = 0; i < 200; ++i)
  {
    const Point within(i % 5, i / 5 % 5, i / 25 % 4);
    specks.push_back(Point::Constant(i % 2) + 1e-10 * within);
  }
  const medial::MergeOptions none{ 0, 0 };
  const std::string message = messageOf(specks, none);
  EXPECT_EQ(message.find("plane"), std::string::npos) << message;
  EXPECT_NE(message.find("of one line, which is 1.73205 long"), std::string::npos) << message;
  EXPECT_NE(messageOf(specks).find("within the merge tolerance"), std::string::npos);
}

// A plate, and a bar, whose thickness is within the merge tolerance.
TEST(PolarBalls, RefuseWhatMergingMadeFlatAndTellSo)
{
  std::vector<Point> plate, bar;
  for (int i = 0; i < 200; ++i)
  {
    plate.emplace_back(i % 10, i / 10 % 10, 0.01 * (i / 100));
    bar.emplace_back(i / 4, 0.01 * (i % 2), 0.01 * (i / 2 % 2));
  }
  const medial::MergeOptions wide{ 0.05, 0 }, none{ 0, 0 };
  const std::string cause =
    " lie within the merge tolerance of others; set a smaller merge tolerance";
  EXPECT_NE(messageOf(plate, wide).find("in one plane, because 100" + cause), std::string::npos)
    << messageOf(plate, wide);
  EXPECT_NE(messageOf(bar, wide).find("on one line, because 150" + cause), std::string::npos)
    << messageOf(bar, wide);
  EXPECT_EQ(messageOf(plate, none).find("plane"), std::string::npos);
  plate.resize(100);
  plate.push_back(plate.front() + Point(0.01, 0, 0)); // flat anyway
  EXPECT_NE(messageOf(plate, wide).find("in one plane; points"), std::string::npos)
    << messageOf(plate, wide);
}

TEST(PolarBalls, RefuseCoordinatesThatAreNotFinite)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    std::vector<Point> samples = shapes::sphere(0.5).samples;
    samples[7].y() = bad;
    EXPECT_NE(messageOf(samples).find("finite"), std::string::npos) << bad;
    EXPECT_NE(messageOf(samples).find("7"), std::string::npos) << "names the sample";
  }
}

TEST(PolarBalls, RefuseCoordinatesNearTheEndOfTheRange)
{
  const std::vector<Point> samples = shapes::torus(0.5).samples;
  EXPECT_NE(messageOf(shapes::scaled(samples, 1e300)), "");
  EXPECT_NE(messageOf(shapes::scaled(samples, 5e307)), "");
  EXPECT_NE(messageOf(shapes::scaled(samples, 1e-300)), "");
}
