// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/CleanScan.h"

#include "Balls/PolarBalls.h"
#include "Base/Errors.h"
#include "Base/Warnings.h"
#include "Executions.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{
using medial::CleanOptions;
using medial::CleanScan;
using medial::Index;
using medial::Point;

/// @param noise  in spacings of the shape, which are the least distances of its samples
std::vector<Point> noisy(const shapes::Shape& shape, double noise, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, noise * shape.spacing);
  std::vector<Point> result = shape.samples;
  for (Point& p : result)
  {
    p += Point(normal(random), normal(random), normal(random));
  }
  return result;
}

/// Root of the mean squared distance from the surface, in spacings.
double deviation(const shapes::Shape& shape, const std::vector<Point>& samples)
{
  double sum = 0;
  for (const Point& p : samples)
  {
    sum += std::pow(shape.outside(p) / shape.spacing, 2);
  }
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

double volumeOf(const medial::PolarBalls& balls)
{
  double result = 0;
  for (const double volume : balls.volumes)
  {
    result += volume;
  }
  return result;
}

bool isDoubted(const medial::PolarBallsAndSamples& made)
{
  const medial::Warnings& warnings = made.samples.warnings;
  return std::any_of(warnings.begin(), warnings.end(),
    [](const medial::Warning& warning) { return warning.doubtsSolid; });
}

TEST(CleanScan, GivesNoisySamplesTheTopologyAndVolumeOfTheSolid)
{
  const shapes::Shape torus = shapes::torus(0.06);
  for (const double noise : { 0.1, 0.3, 0.5 })
  {
    SCOPED_TRACE(noise);
    const std::vector<Point> scan = noisy(torus, noise);
    const CleanScan made = medial::cleanScan(scan);
    EXPECT_LT(deviation(torus, made.samples), 0.6 * deviation(torus, scan));
    EXPECT_LT(made.noiseAfter, 0.5 * made.noiseBefore);
    const medial::PolarBallsAndSamples balls = medial::polarBallsAndSamples(made.samples);
    EXPECT_EQ(balls.powerShape, torus.betti);
    EXPECT_FALSE(isDoubted(balls));
    EXPECT_NEAR(volumeOf(balls.balls), torus.volume, 0.01 * torus.volume);
    EXPECT_TRUE(noise < 0.5 || isDoubted(medial::polarBallsAndSamples(scan)))
      << "cleaning would not be needed";
  }
}

TEST(CleanScan, LeavesCleanSamplesWhereTheyAre)
{
  const shapes::Shape torus = shapes::torus();
  const CleanScan made = medial::cleanScan(torus.samples);
  EXPECT_EQ(made.smoothingRounds, 0);
  EXPECT_EQ(made.outliers, 0);
  EXPECT_EQ(made.thinned, 0);
  ASSERT_EQ(made.samples.size(), torus.samples.size());
  for (std::size_t i = 0; i < made.samples.size(); ++i)
  {
    EXPECT_NEAR((made.samples[i] - torus.samples[i]).norm(), 0, 1e-12);
    EXPECT_EQ(made.ids[i], static_cast<Index>(i));
  }
}

TEST(CleanScan, DropsOutliersAndRepeatedSamples)
{
  const shapes::Shape torus = shapes::torus();
  std::vector<Point> scan = torus.samples;
  scan.insert(scan.begin(), Point(0, 0, 3));
  scan.emplace_back(5, 0, 0.2);
  scan.push_back(scan[7]);
  const CleanScan made = medial::cleanScan(scan);
  EXPECT_EQ(made.outliers, 2);
  EXPECT_EQ(made.samples.size(), torus.samples.size());
  EXPECT_EQ(made.ids.front(), 1);
  CleanOptions all;
  all.outlierFactor = 0;
  EXPECT_EQ(medial::cleanScan(scan, all).samples.size(), torus.samples.size() + 2);
}

TEST(CleanScan, ThinsOutWhatIsTooClose)
{
  const shapes::Shape torus = shapes::torus();
  std::vector<Point> scan = torus.samples;
  for (const Point& p : torus.samples)
  {
    scan.push_back(p + Point(1e-3, 0, 0));
  }
  CleanOptions options;
  options.smoothingRounds = 0;
  options.thinning = 0.3;
  const CleanScan made = medial::cleanScan(scan, options);
  EXPECT_EQ(made.thinned, static_cast<Index>(torus.samples.size()));
  EXPECT_LT(made.ids.back(), static_cast<Index>(torus.samples.size())); // the lower one stays
}

TEST(CleanScan, EstimatesNormalsOutwards)
{
  const shapes::Shape torus = shapes::torus(0.12);
  CleanOptions options;
  options.estimateNormals = true;
  const CleanScan made = medial::cleanScan(noisy(torus, 0.2), options);
  ASSERT_EQ(made.normals.size(), made.samples.size());
  for (std::size_t i = 0; i < made.samples.size(); ++i)
  {
    const Point outwards = made.samples[i] + 0.1 * made.normals[i];
    EXPECT_GT(torus.outside(outwards), torus.outside(made.samples[i]));
    EXPECT_NEAR(made.normals[i].norm(), 1, 1e-6);
  }
}

TEST(CleanScan, DoesNotDependOnTheUnit)
{
  const std::vector<Point> scan = noisy(shapes::torus(), 0.3);
  const CleanScan one = medial::cleanScan(scan);
  const CleanScan other = medial::cleanScan(shapes::scaled(scan, 1024));
  EXPECT_EQ(shapes::scaled(one.samples, 1024), other.samples);
  EXPECT_EQ(one.ids, other.ids);
}

TEST(CleanScan, RefusesWhatItCantClean)
{
  const std::vector<Point> scan = shapes::torus(0.4).samples;
  const auto refuses = [&](double factor, Index rounds, double thinning) {
    CleanOptions options;
    options.outlierFactor = factor;
    options.smoothingRounds = rounds;
    options.thinning = thinning;
    EXPECT_THROW(medial::cleanScan(scan, options), medial::InvalidInput);
  };
  refuses(0.5, -1, -1);
  refuses(std::numeric_limits<double>::quiet_NaN(), -1, -1);
  refuses(3, 101, -1);
  refuses(3, -1, 1.5);
  EXPECT_THROW(medial::cleanScan({ scan.begin(), scan.begin() + 19 }), medial::InvalidInput);
  EXPECT_THROW(medial::cleanScan({}), medial::InvalidInput);
  EXPECT_THROW(medial::cleanScan(std::vector<Point>(50, Point(1, 2, 3))), medial::InvalidInput);
}

TEST(CleanScan, CanBeStopped)
{
  const std::vector<Point> scan = noisy(shapes::torus(), 0.3);
  pipelines::expectProgressAndAbort(
    [&scan](const medial::Execution& execution) { medial::cleanScan(scan, {}, execution); });
}
}
