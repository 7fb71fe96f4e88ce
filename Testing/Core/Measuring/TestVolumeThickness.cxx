// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/VolumeThickness.h"

#include "Measuring/SampleWalls.h"
#include "PoissonDisk.h"
#include "Shapes.h"
#include "VoxelThickness.h"

#include "Base/Errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using medial::Distribution;
using medial::Point;
using medial::PolarBalls;
using medial::ThicknessBounds;
using medial::VolumeThickness;

namespace
{
constexpr double pi = 3.14159265358979323846;

VolumeThickness measured(const PolarBalls& balls, const ThicknessBounds& volume = {})
{
  return volumeThickness(balls, wallDistances(balls, sampleWalls(balls)), volume);
}

double meanThickness(const std::vector<Point>& samples)
{
  return measured(medial::polarBalls(samples)).thickness.mean;
}

/// The mean thickness of the ellipsoid of shapes::ellipsoid() by its exact axis: a flat ellipse, whose balls have the
/// radius c sqrt(1 - x^2 / (a^2 - c^2) - y^2 / (b^2 - c^2)).
double ellipsoidThickness()
{
  const Point half(1.5, 1, 0.5);
  const double c = half.z(), width = half.x() * half.x() - c * c,
               depth = half.y() * half.y() - c * c;
  const double a = width / half.x(), b = depth / half.y();
  constexpr int steps = 120;
  std::vector<std::pair<Point, double>> balls;
  for (int i = -steps; i <= steps; ++i)
  {
    for (int j = -steps; j <= steps; ++j)
    {
      const Point at(a * i / steps, b * j / steps, 0);
      if (i * i + j * j <= steps * steps)
      {
        balls.emplace_back(
          at, c * std::sqrt(1 - at.x() * at.x() / width - at.y() * at.y() / depth));
      }
    }
  }
  shapes::Random random(5);
  double sum = 0;
  int number = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const Point p = shapes::uniformInBox(random, half);
    if (p.cwiseQuotient(half).squaredNorm() < 1)
    {
      double largest = 0;
      for (const auto& [at, radius] : balls)
      {
        largest = (p - at).squaredNorm() <= radius * radius ? std::max(largest, radius) : largest;
      }
      sum += 2 * largest;
      ++number;
    }
  }
  return sum / number;
}

/// Struts between holes, cut by a ball: where a sum of waves in six directions is positive.
class Sponge
{
public:
  explicit Sponge(unsigned seed)
  {
    shapes::Random random(seed);
    for (int i = 0; i < 6; ++i)
    {
      waves.push_back(10 * shapes::direction(random));
      phases.push_back(shapes::uniform(random, 0, 2 * pi));
    }
  }

  double level(const Point& p) const
  {
    double sum = 0.6;
    for (std::size_t i = 0; i < this->waves.size(); ++i)
    {
      sum += std::cos(this->waves[i].dot(p) + this->phases[i]);
    }
    return sum;
  }

  bool contains(const Point& p) const { return p.norm() < 1 && this->level(p) > 0; }

  std::vector<Point> samples(double spacing) const
  {
    return shapes::poissonDisk(
      [this](shapes::Random& random) {
        while (true)
        {
          const Point onBall = shapes::direction(random);
          if (shapes::uniform(random, 0, 1) < 0.3)
          {
            if (this->level(onBall) > 0)
            {
              return onBall;
            }
            continue;
          }
          const Point onWave = this->projected(shapes::uniformInBox(random, Point(1, 1, 1)));
          if (onWave.norm() < 1 && std::abs(this->level(onWave)) < 1e-9)
          {
            return onWave;
          }
        }
      },
      spacing, 3);
  }

private:
  Point projected(Point p) const
  {
    for (int i = 0; i < 20 && std::abs(this->level(p)) > 1e-10; ++i)
    {
      Point slope = Point::Zero();
      for (std::size_t k = 0; k < this->waves.size(); ++k)
      {
        slope -= this->waves[k] * std::sin(this->waves[k].dot(p) + this->phases[k]);
      }
      p -= this->level(p) * slope / slope.squaredNorm();
    }
    return p;
  }

  std::vector<Point> waves;
  std::vector<double> phases;
};
}

TEST(VolumeThickness, IsWithinAPercentOfTheTruthOfManyShapes)
{
  // Spacings are up to 0.28 of the thickness: of the ellipsoid that is 0.33 at its tips.
  EXPECT_NEAR(meanThickness(shapes::sphere(0.3).samples), 2, 0.02);
  EXPECT_NEAR(meanThickness(shapes::torus(0.28).samples), 1.4, 0.014);
  EXPECT_NEAR(meanThickness(shapes::capsule(0.2).samples), 1, 0.01);
  EXPECT_NEAR(meanThickness(shapes::knot(0.17).samples), 0.7, 0.007);
  EXPECT_NEAR(meanThickness(shapes::hollowSphere(0.14).samples), 0.5, 0.005);
  EXPECT_NEAR(meanThickness(shapes::twoHolePlate(0.11).samples), 0.4, 0.004);
  const double ellipsoid = ellipsoidThickness();
  EXPECT_NEAR(meanThickness(shapes::ellipsoid(0.1).samples), ellipsoid, 0.01 * ellipsoid);
}

TEST(VolumeThickness, IsThatOfVoxelsOfNoSizeOfASponge)
{
  constexpr unsigned seed = 2;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  const Sponge sponge(seed);
  const PolarBalls balls = medial::polarBalls(sponge.samples(0.05));
  const double half = 0.5;
  ThicknessBounds cube;
  cube.bounds = Eigen::AlignedBox3d(Point::Constant(-half), Point::Constant(half));
  cube.margin = 0; // the solid isn't cut at the cube's faces
  const VolumeThickness measuredInCube = measured(balls, cube);

  constexpr double size = 1.05, step = 0.026;
  const auto inCube = [half](const Point& p) { return p.cwiseAbs().maxCoeff() < half; };
  const auto inside = [&](const Point& p) { return sponge.contains(p); };
  const double thickness = shapes::voxelThickness(inside, inCube, size, step);
  EXPECT_NEAR(measuredInCube.thickness.mean, thickness, 0.02 * thickness);
  const auto gap = [&](const Point& p) { return p.norm() < 1 && !sponge.contains(p); };
  const double separation = shapes::voxelThickness(gap, inCube, size, step);
  EXPECT_NEAR(measuredInCube.separation.mean, separation, 0.04 * separation);
}

TEST(VolumeThickness, MeasuresGapsWhereTheirBallsAreInTheBounds)
{
  const VolumeThickness hollow = measured(medial::polarBalls(shapes::hollowSphere().samples));
  EXPECT_NEAR(hollow.separation.mean, 1, 0.01);
  const VolumeThickness ball = measured(medial::polarBalls(shapes::sphere().samples));
  EXPECT_EQ(ball.separation.number, 0); // nothing is opposite
  EXPECT_TRUE(std::isnan(ball.separation.mean));
}

TEST(VolumeThickness, LeavesOutAMarginAtTheFacesOfTheBounds)
{
  const PolarBalls box = medial::polarBalls(shapes::box().samples); // 3 x 2 x 1 about the origin
  ThicknessBounds volume;
  volume.bounds = Eigen::AlignedBox3d(Point(-1.5, -1, -0.5), Point(1.5, 1, 0.5));
  volume.margin = 0;
  const VolumeThickness all = measured(box, volume);
  volume.margin = 0.3;
  const VolumeThickness middle = measured(box, volume);
  EXPECT_LT(middle.thickness.number, all.thickness.number);
  EXPECT_GT(middle.thickness.mean, all.thickness.mean); // thin are only the sharp edges
  volume.margin = -1;
  const VolumeThickness half = measured(box, volume);
  EXPECT_DOUBLE_EQ(half.margin, all.thickness.mean / 2);
}

TEST(VolumeThickness, RefusesAVolumeOfInterestThatIsEmpty)
{
  const PolarBalls ball = medial::polarBalls(shapes::sphere().samples);
  ThicknessBounds volume;
  volume.bounds = Eigen::AlignedBox3d(Point(0, 0, 0), Point(1, 1, 0));
  EXPECT_THROW(measured(ball, volume), medial::InvalidInput);
  volume.bounds = Eigen::AlignedBox3d(Point::Constant(-0.5), Point::Constant(0.5));
  volume.margin = 0.5;
  EXPECT_THROW(measured(ball, volume), medial::InvalidInput);
}

TEST(VolumeThickness, IsUnknownWhereHalfOfItLeavesNothingOfTheBounds)
{
  ThicknessBounds volume;
  volume.bounds = Eigen::AlignedBox3d(Point::Constant(-0.5), Point::Constant(0.5));
  const VolumeThickness found = measured(medial::polarBalls(shapes::sphere().samples), volume);
  EXPECT_EQ(found.thickness.number, 0); // of a sphere of diameter 2
  EXPECT_TRUE(std::isnan(found.thickness.mean));
  EXPECT_NEAR(found.margin, 1, 0.01);
  EXPECT_EQ(found.share, 1);
}

TEST(VolumeThickness, GrowsWithTheUnitAndIgnoresThePosition)
{
  const std::vector<Point> samples = shapes::twoHolePlate().samples;
  const double here = meanThickness(samples);
  EXPECT_NEAR(meanThickness(shapes::scaled(samples, 1000)), 1000 * here, 1e-6 * here);
  EXPECT_NEAR(meanThickness(shapes::moved(samples, Point(70, -30, 10))), here, 1e-3 * here);
  EXPECT_NEAR(meanThickness(shapes::rotated(samples, 4)), here, 3e-3 * here);
}
