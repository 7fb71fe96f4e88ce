// SPDX-License-Identifier: BSD-3-Clause
// What must not change the axis: unit, place, order, threads; and what it refuses.
#include "Pipelines.h"

#include "Axis/MedialAxis.h"

#include <algorithm>
#include <cmath>

using medial::MedialAxis;
using medial::Point;
using medial::Side;
using pipelines::Pipeline;

namespace
{
/// Equal topology and balls; points, triangles and places nearly so.
void expectAlike(const MedialAxis& a, const MedialAxis& b, const std::vector<Point>& placed,
  double spacing, double share)
{
  EXPECT_EQ(a.betti, b.betti);
  EXPECT_EQ(a.certificate, b.certificate);
  EXPECT_EQ(a.fallback, b.fallback);
  EXPECT_NEAR(static_cast<double>(b.points.size()) / a.points.size(), 1, share);
  EXPECT_NEAR((1.0 + b.cells.triangles.size()) / (1.0 + a.cells.triangles.size()), 1, 2 * share);
  EXPECT_LT(validators::hausdorffDistance(placed, a.points), spacing);
  EXPECT_LT(validators::hausdorffDistance(a.points, placed), spacing);
}
}

TEST(MedialAxis, ScalesWithTheSamplesToTheLastBit)
{
  for (const shapes::Shape& shape : { shapes::capsule(0.2), shapes::twoHolePlate(0.12) })
  {
    const MedialAxis reference = medial::medialAxis(medial::polarBalls(shape.samples));
    for (const int exponent : { -20, -1, 20 })
    {
      SCOPED_TRACE(testing::Message() << shape.name << " by 2^" << exponent);
      const double factor = std::ldexp(1, exponent);
      const std::vector<Point> samples = shapes::scaled(shape.samples, factor);
      EXPECT_EQ(pipelines::bytesOf(medial::medialAxis(medial::polarBalls(samples))),
        pipelines::bytesOf(pipelines::inUnits(reference, factor)));
    }
  }
}

TEST(MedialAxis, MovesWithTheSamples)
{
  // Which of several flat cells there are at a sample is up to rounding, so single points differ.
  for (const shapes::Shape& shape :
    { shapes::capsule(), shapes::ellipsoid(), shapes::torus(), shapes::twoHolePlate(0.12) })
  {
    const MedialAxis reference = medial::medialAxis(medial::polarBalls(shape.samples));
    const auto axisOf = [](const std::vector<Point>& samples) {
      return medial::medialAxis(medial::polarBalls(samples));
    };
    for (const double factor : { 1e-6, 1e6 })
    {
      SCOPED_TRACE(testing::Message() << shape.name << " by " << factor);
      const MedialAxis axis = axisOf(shapes::scaled(shape.samples, factor));
      expectAlike(reference, axis, shapes::scaled(axis.points, 1 / factor), shape.spacing, 0.03);
    }
    {
      SCOPED_TRACE(testing::Message() << shape.name << " moved");
      const Point by(37, -11, 5);
      const MedialAxis axis = axisOf(shapes::moved(shape.samples, by));
      expectAlike(reference, axis, shapes::moved(axis.points, -by), shape.spacing, 0.03);
    }
    for (const unsigned seed : { 1u, 2u })
    {
      SCOPED_TRACE(testing::Message() << shape.name << " rotated, seed " << seed);
      const MedialAxis axis = axisOf(shapes::rotated(shape.samples, seed));
      expectAlike(reference, axis, shapes::rotated(axis.points, seed, true), shape.spacing, 0.03);
    }
  }
}

TEST(MedialAxis, DependsOnTheOrderOfSamplesInItsNumbersOnly)
{
  for (const shapes::Shape& shape :
    { shapes::capsule(), shapes::torus(), shapes::twoHolePlate(), shapes::box() })
  {
    const MedialAxis reference = medial::medialAxis(medial::polarBalls(shape.samples));
    for (unsigned seed = 3; seed < 5; ++seed)
    {
      SCOPED_TRACE(testing::Message() << shape.name << ", seed " << seed);
      const auto order = shapes::shuffledOrder(shape.samples.size(), seed);
      const MedialAxis axis =
        medial::medialAxis(medial::polarBalls(shapes::reordered(shape.samples, order)));
      EXPECT_EQ(axis.betti, reference.betti);
      EXPECT_EQ(axis.points.size(), reference.points.size());
      EXPECT_EQ(axis.cells.triangles.size(), reference.cells.triangles.size());
      EXPECT_TRUE(validators::samePolygons(
        pipelines::polygonsOf(reference), pipelines::polygonsOf(axis), 1e-10));
    }
  }
}

TEST(MedialAxis, IsTheSameOnManyThreadsAndInEveryRun)
{
  for (const char* name : { "two-hole plate", "box", "knot" })
  {
    SCOPED_TRACE(name);
    Pipeline& p = pipelines::of(name);
    EXPECT_EQ(pipelines::bytesOf(medial::medialAxis(p.balls(), {}, pipelines::threaded())),
      pipelines::bytesOf(p.axis()));
    EXPECT_EQ(pipelines::bytesOf(medial::medialAxis(p.balls())), pipelines::bytesOf(p.axis()));
  }
}

TEST(MedialAxis, ReportsProgressAndStops)
{
  const medial::PolarBalls balls = medial::polarBalls(shapes::torus(0.3).samples);
  pipelines::expectProgressAndAbort(
    [&](const medial::Execution& execution) { medial::medialAxis(balls, {}, execution); });
}

TEST(MedialAxis, RefusesBallsWithoutInnerOnes)
{
  medial::PolarBalls balls = pipelines::of("capsule").balls();
  std::replace(balls.sides.begin(), balls.sides.end(), Side::Inner, Side::Outer);
  EXPECT_THROW(medial::medialAxis(balls), medial::InvalidInput);
  EXPECT_THROW(medial::medialAxis(medial::polarBalls(shapes::gridCube(2))), medial::InvalidInput);
  EXPECT_THROW(medial::medialAxis({}), medial::InvalidInput);
}
