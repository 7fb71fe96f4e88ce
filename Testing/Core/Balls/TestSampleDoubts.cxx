// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Balls/PolarBalls.h"
#include "Balls/PowerShape.h"
#include "Base/Frame.h"
#include "Base/Warnings.h"
#include "PoissonDisk.h"
#include "Samples/NoiseEstimate.h"
#include "Shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

using medial::Index;
using medial::Point;
using medial::Warning;
using medial::Warnings;
using pipelines::forEachShape;
using pipelines::Pipeline;

namespace
{
Warnings warningsOf(const std::vector<Point>& samples, const medial::Execution& execution = {},
  const medial::MergeOptions& merging = {})
{
  return medial::polarBallsAndSamples(samples, merging, execution).samples.warnings;
}

std::set<std::string> codes(const Warnings& warnings)
{
  std::set<std::string> result;
  for (const Warning& warning : warnings)
  {
    result.insert(warning.code);
  }
  return result;
}

/// The warning with a code; fails, and returns an empty one, where there is none.
Warning warning(const Warnings& warnings, const std::string& code)
{
  for (const Warning& candidate : warnings)
  {
    if (candidate.code == code)
    {
      EXPECT_FALSE(candidate.text.empty());
      return candidate;
    }
  }
  ADD_FAILURE() << "no warning " << code << " among " << testing::PrintToString(codes(warnings));
  return {};
}

bool doubtsSolid(const Warnings& warnings)
{
  return std::any_of(
    warnings.begin(), warnings.end(), [](const Warning& w) { return w.doubtsSolid; });
}

std::vector<Point> noisy(std::vector<Point> points, double amplitude, unsigned seed)
{
  shapes::Random random(seed);
  for (Point& point : points)
  {
    const double distance = shapes::uniform(random, 0, amplitude);
    point += distance * shapes::direction(random);
  }
  return points;
}

std::vector<Point> joined(std::vector<Point> points, const std::vector<Point>& more)
{
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

/// Random points in a box about the origin.
std::vector<Point> scattered(Index howMany, const Point& halfSides, unsigned seed)
{
  shapes::Random random(seed);
  std::vector<Point> result;
  std::generate_n(
    std::back_inserter(result), howMany, [&] { return shapes::uniformInBox(random, halfSides); });
  return result;
}

std::vector<Point> below(const std::vector<Point>& points, double z)
{
  std::vector<Point> result;
  std::copy_if(points.begin(), points.end(), std::back_inserter(result),
    [z](const Point& p) { return p.z() < z; });
  return result;
}

/// Two parallel square sheets; nothing says which side of them is inside.
std::vector<Point> sheets(double thickness, double spacing)
{
  const auto sheet = [&](double z, unsigned seed) {
    return shapes::poissonDisk(
      [z](shapes::Random& random) {
        Point p = shapes::uniformInBox(random, Point::Constant(1));
        p.z() = z;
        return p;
      },
      spacing, seed);
  };
  return joined(sheet(0, 1), sheet(thickness, 2));
}

/// Code and number of each warning: what must not depend on unit, position and order.
std::vector<std::string> summary(const Warnings& warnings)
{
  std::vector<std::string> result;
  for (const Warning& w : warnings)
  {
    result.push_back(
      w.code + " " + std::to_string(w.count) + (w.doubtsSolid ? " doubts" : " remark"));
  }
  return result;
}
}

TEST(SampleDoubts, AreNoneForDenseSamples)
{
  forEachShape([](Pipeline& p) {
    EXPECT_EQ(codes(p.ballsAndSamples().samples.warnings), std::set<std::string>());
  });
}

TEST(SampleDoubts, AreNoneForAGrid)
{
  EXPECT_EQ(codes(warningsOf(shapes::gridCube(12))), std::set<std::string>());
}

TEST(SampleDoubts, AreRaisedWhereverTheTopologyIsWrong)
{
  int wrong = 0;
  const auto expectDoubts = [&wrong](
                              const shapes::Shape& shape, const std::vector<Point>& samples) {
    const medial::PolarBallsAndSamples made = medial::polarBallsAndSamples(samples);
    if (medial::powerShape(made.balls).betti != shape.betti)
    {
      ++wrong;
      EXPECT_TRUE(doubtsSolid(made.samples.warnings)) << shape.name << ", seed " << shape.seed;
    }
  };
  for (unsigned seed = 1; seed <= 10; ++seed)
  {
    for (const double spacing : { 0.25, 0.3, 0.35, 0.4, 0.45 })
    {
      const shapes::Shape plate = shapes::twoHolePlate(spacing, seed);
      SCOPED_TRACE(testing::Message() << "spacing " << spacing);
      expectDoubts(plate, plate.samples);
    }
  }
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    for (const double noise : { 0.7, 1.5 })
    {
      const shapes::Shape torus = shapes::torus(0.2, seed);
      SCOPED_TRACE(testing::Message() << "noise " << noise);
      expectDoubts(torus, noisy(torus.samples, noise * torus.spacing, seed));
    }
  }
  EXPECT_GE(wrong, 30) << "too few wrong solids to tell";
}

TEST(SampleDoubts, ContestedSidesSayHowTheTopologyMayDiffer)
{
  const Warning found = warning(warningsOf(sheets(0.03, 0.05)), "contested_sides");
  EXPECT_TRUE(found.doubtsSolid);
  EXPECT_GT(found.count, 10);
  EXPECT_NE(found.text.find("tunnels"), std::string::npos);
  ASSERT_TRUE(found.place.has_value());
}

TEST(SampleDoubts, NoiseIsARemarkAsLongAsTheTopologyIsKept)
{
  const Warnings found = warningsOf(noisy(shapes::sphere(0.1).samples, 0.12, 1));
  EXPECT_FALSE(warning(found, "noise").doubtsSolid);
  EXPECT_FALSE(doubtsSolid(found));
}

TEST(SampleDoubts, PartsAsThinAsTheSpacingDoubtTheSolid)
{
  const Warning found = warning(warningsOf(shapes::twoHolePlate(0.22).samples), "thin_parts");
  EXPECT_TRUE(found.doubtsSolid);
  EXPECT_GT(found.count, 50);
}

TEST(SampleDoubts, AGapAsNarrowAsTheSpacingIsARemark)
{
  const std::vector<Point> sphere = shapes::sphere(0.08).samples;
  const Warnings found = warningsOf(joined(sphere, shapes::moved(sphere, Point(2.05, 0, 0))));
  EXPECT_FALSE(warning(found, "narrow_gaps").doubtsSolid);
  EXPECT_FALSE(doubtsSolid(found));
}

TEST(SampleDoubts, NearDuplicatesThatAreNotMergedAreARemark)
{
  const std::vector<Point> sphere = shapes::sphere().samples;
  medial::MergeOptions none;
  none.tolerance = 0;
  const Warnings found =
    warningsOf(joined(sphere, shapes::moved(sphere, Point(1e-5, 0, 0))), {}, none);
  EXPECT_EQ(warning(found, "clustered_samples").count, 2 * medial::count(sphere));
}

TEST(SampleDoubts, PointsOfAVolumeDoubtTheSolid)
{
  const Warnings found = warningsOf(shapes::cloud(1500, 1));
  EXPECT_TRUE(warning(found, "volume_samples").doubtsSolid);
  EXPECT_TRUE(warning(found, "too_many_features").doubtsSolid);
  warning(found, "noise");
}

TEST(SampleDoubts, InteriorSamplesDoubtTheSolid)
{
  const std::vector<Point> inside = scattered(30, Point::Constant(0.5), 1);
  const Warning found =
    warning(warningsOf(joined(shapes::sphere(0.1).samples, inside)), "interior_samples");
  EXPECT_TRUE(found.doubtsSolid);
  EXPECT_GE(found.count, 5);
  EXPECT_LE(found.count, 30);
  ASSERT_TRUE(found.place.has_value());
  EXPECT_LT(found.place->norm(), 0.9);
}

TEST(SampleDoubts, OutliersAreARemark)
{
  const Warnings found =
    warningsOf(joined(shapes::sphere().samples, { Point(4, 5, 6), Point(-7, 0, 1) }));
  EXPECT_EQ(summary(found), std::vector<std::string>{ "isolated_samples 2 remark" });
}

TEST(SampleDoubts, SingleSamplesOffTheSurfaceAreARemark)
{
  const std::vector<Point> sphere = shapes::sphere(0.1).samples;
  const std::vector<Point> directions{ Point(1, 0, 0), Point(-0.6, 0.8, 0), Point(0, -0.6, 0.8),
    Point(0, -0.6, -0.8), Point(-0.6, -0.8, 0) };
  for (const double radius : { 0.6, 0.7, 1.3, 1.5, 4.0 }) // at 0.3 it is two local spacings away
  {
    for (const int howMany : { 1, 2, 5 })
    {
      const std::vector<Point> lone =
        shapes::scaled({ directions.begin(), directions.begin() + howMany }, radius);
      const Warning found = warning(warningsOf(joined(sphere, lone)), "isolated_samples");
      EXPECT_EQ(found.count, howMany) << radius;
      ASSERT_TRUE(found.place.has_value());
      EXPECT_NEAR(found.place->norm(), radius, 1e-9);
    }
  }
}

TEST(SampleDoubts, OutliersThatDecideTheTopologyDoubtTheSolid)
{
  int wrong = 0;
  const auto expectDoubts = [&wrong](const shapes::Shape& knot, const std::vector<Point>& strays) {
    const medial::PolarBallsAndSamples made =
      medial::polarBallsAndSamples(joined(knot.samples, strays));
    if (made.powerShape != knot.betti)
    {
      ++wrong;
      EXPECT_TRUE(doubtsSolid(made.samples.warnings)) << "seed " << knot.seed;
    }
  };
  // Some of these strays make a piece of their own.
  const shapes::Shape first = shapes::knot();
  expectDoubts(first, scattered(medial::count(first.samples) / 50, Point(3.3, 3.3, 1.3), 97));
  // These cut the tube, or not.
  for (unsigned seed = 9; seed <= 14; ++seed)
  {
    const shapes::Shape knot = shapes::knot(0.17, seed);
    const Eigen::AlignedBox3d box = medial::boundingBox(knot.samples);
    const auto strays = scattered(medial::count(knot.samples) / 10, box.sizes() / 2, seed);
    expectDoubts(knot, shapes::moved(strays, box.center()));
  }
  EXPECT_GE(wrong, 2) << "too few wrong solids to tell";
}

TEST(SampleDoubts, ALargeGapDoubtsTheSolidAndASmallOneIsARemark)
{
  const std::vector<Point> sphere = shapes::sphere(0.06).samples;
  const Warning large = warning(warningsOf(below(sphere, 0.7)), "gaps");
  EXPECT_EQ(large.count, 1);
  EXPECT_TRUE(large.doubtsSolid);
  ASSERT_TRUE(large.place.has_value());
  EXPECT_GT(large.place->z(), 0.6);
  const Warning small = warning(warningsOf(below(sphere, 0.97)), "gaps");
  EXPECT_EQ(small.count, 1);
  EXPECT_FALSE(small.doubtsSolid);
}

TEST(SampleDoubts, AnOpenSurfaceDoubtsTheSolid)
{
  const Warnings found = warningsOf(below(shapes::sphere(0.1).samples, 0));
  EXPECT_TRUE(warning(found, "no_inner_balls").doubtsSolid);
}

/// A leaf, thinner than its samples can show: 25 of more than 2,500 samples.
TEST(SampleDoubts, SamplesThatTheSurfaceMissesDoubtTheSolid)
{
  const std::vector<Point> sphere = shapes::sphere(0.07).samples;
  std::vector<Point> leaf;
  for (int i = 0; i < 5; ++i)
  {
    for (int k = 0; k < 5; ++k)
    {
      leaf.push_back({ 1.2 + 0.07 * i, 0.07 * k, 0.002 * ((i + k) % 2) });
    }
  }
  const Warnings found = warningsOf(joined(sphere, leaf));
  EXPECT_TRUE(warning(found, "lost_surface").doubtsSolid);
  EXPECT_GT(warning(found, "lost_surface").place.value_or(Point::Zero()).x(), 1.19);
  EXPECT_EQ(codes(found).count("one_sided_samples"), 0);
}

TEST(SampleDoubts, ANeedleSampledTooThinlyAlongItDoubtsTheSolid)
{
  std::vector<Point> needle = shapes::sphere(0.1).samples;
  for (Point& point : needle)
  {
    point.x() *= 1e4;
  }
  EXPECT_TRUE(warning(warningsOf(needle), "one_sided_samples").doubtsSolid);
}

TEST(SampleDoubts, FloatsFarFromTheOriginAreARemark)
{
  const std::vector<Point> sphere = shapes::sphere().samples;
  const std::vector<Point> far = shapes::moved(sphere, Point(3e6, 5e5, 2e6));
  EXPECT_EQ(codes(warningsOf(far)), std::set<std::string>());
  EXPECT_FALSE(warning(warningsOf(shapes::roundedToFloats(far)), "float_rounding").doubtsSolid);
  EXPECT_EQ(codes(warningsOf(shapes::roundedToFloats(sphere))), std::set<std::string>());
}

TEST(SampleDoubts, IntegersAreNoRoundedFloats)
{
  const std::vector<Point> grid = shapes::moved(shapes::gridCube(12), Point(4e6, 0, 0));
  EXPECT_EQ(codes(warningsOf(grid)), std::set<std::string>());
}

TEST(SampleDoubts, DependOnNeitherUnitNorPositionNorOrderNorThreads)
{
  const std::vector<std::vector<Point>> inputs{ sheets(0.03, 0.07), shapes::cloud(400, 2),
    below(shapes::sphere(0.1).samples, 0.7),
    joined(shapes::sphere(0.15).samples, scattered(9, Point::Constant(0.4), 1)) };
  for (const std::vector<Point>& input : inputs)
  {
    const std::vector<std::string> expected = summary(warningsOf(input));
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(summary(warningsOf(shapes::scaled(input, std::ldexp(1, -30)))), expected);
    EXPECT_EQ(summary(warningsOf(shapes::scaled(input, 1000))), expected);
    EXPECT_EQ(summary(warningsOf(shapes::moved(input, Point(8, -16, 4)))), expected);
    EXPECT_EQ(summary(warningsOf(shapes::reordered(input, shapes::shuffledOrder(input.size(), 5)))),
      expected);
    const Warnings threaded = warningsOf(input, pipelines::threaded());
    const Warnings alone = warningsOf(input);
    ASSERT_EQ(threaded.size(), alone.size());
    for (std::size_t i = 0; i < alone.size(); ++i)
    {
      EXPECT_EQ(threaded[i].text, alone[i].text);
      EXPECT_EQ(threaded[i].place, alone[i].place);
    }
  }
}

TEST(NoiseEstimate, TellsNoiseFromCurvature)
{
  const auto estimate = [](const std::vector<Point>& points) {
    return medial::noiseEstimate(points, medial::Neighbors(points));
  };
  const shapes::Shape torus = shapes::torus(0.12);
  EXPECT_LT(estimate(torus.samples), 0.05);
  EXPECT_LT(estimate(shapes::box().samples), 0.05) << "sharp edges are no noise";
  double last = 0;
  for (const double amplitude : { 0.2, 0.6, 1.2 })
  {
    const double noise = estimate(noisy(torus.samples, amplitude * torus.spacing, 3));
    EXPECT_GT(noise, 1.5 * last);
    last = noise;
  }
  EXPECT_GT(estimate(shapes::cloud(1000, 1)), 0.6);
}
