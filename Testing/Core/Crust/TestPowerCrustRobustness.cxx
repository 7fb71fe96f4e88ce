// SPDX-License-Identifier: BSD-3-Clause
// What must not change the crust: unit, place, order, threads; and what it refuses.
#include "Pipelines.h"

#include "Crust/PowerCrust.h"

#include <algorithm>
#include <cmath>
#include <limits>

using medial::Crust;
using medial::CrustOptions;
using medial::Index;
using medial::Point;
using medial::Side;
using pipelines::facesOf;
using pipelines::keepBelow;
using pipelines::Pipeline;

namespace
{
Crust crustOf(const std::vector<Point>& samples)
{
  return medial::powerCrust(medial::polarBalls(samples));
}
}

TEST(PowerCrust, ScalesWithTheSamplesToTheLastBit)
{
  const std::vector<Point> samples = shapes::twoHolePlate(0.12).samples;
  const medial::PolarBalls all = medial::polarBalls(samples);
  const Crust reference = medial::powerCrust(all, keepBelow(all, 0.4));
  for (const int exponent : { -20, -1, 20 })
  {
    SCOPED_TRACE(testing::Message() << "2^" << exponent);
    const double factor = std::ldexp(1, exponent);
    const medial::PolarBalls other = medial::polarBalls(shapes::scaled(samples, factor));
    EXPECT_EQ(pipelines::bytesOf(medial::powerCrust(other, keepBelow(other, 0.4 * factor))),
      pipelines::bytesOf(pipelines::inUnits(reference, factor)));
  }
}

TEST(PowerCrust, MovesWithTheSamples)
{
  // Which of several flat cells there are at a sample is up to rounding, so single vertices differ.
  for (const shapes::Shape& shape : { shapes::capsule(0.2), shapes::torus(0.3) })
  {
    SCOPED_TRACE(shape.name);
    const Crust reference = crustOf(shape.samples);
    const auto expectLike = [&](const Crust& crust, const std::vector<Point>& back, double unit) {
      EXPECT_EQ(crust.betti, reference.betti);
      EXPECT_TRUE(validators::isTwoManifold(facesOf(crust)));
      EXPECT_LT(validators::hausdorffDistance(back, reference.points), 2 * shape.spacing);
      EXPECT_LT(validators::hausdorffDistance(reference.points, back), 2 * shape.spacing);
      EXPECT_NEAR(crust.volume / std::pow(unit, 3) / reference.volume, 1, 0.01);
    };
    for (const double factor : { 1e-6, 1e6 })
    {
      const Crust crust = crustOf(shapes::scaled(shape.samples, factor));
      expectLike(crust, shapes::scaled(crust.points, 1 / factor), factor);
    }
    const Crust moved = crustOf(shapes::moved(shape.samples, Point(37, -11, 5)));
    expectLike(moved, shapes::moved(moved.points, Point(-37, 11, -5)), 1);
    const Crust turned = crustOf(shapes::rotated(shape.samples, 8));
    expectLike(turned, shapes::rotated(turned.points, 8, true), 1);
  }
}

TEST(PowerCrust, DependsOnTheOrderOfSamplesInItsNumbersOnly)
{
  const std::vector<Point> samples = shapes::twoHolePlate(0.12).samples;
  const Crust reference = crustOf(samples);
  const auto order = shapes::shuffledOrder(samples.size(), 4);
  const Crust crust = crustOf(shapes::reordered(samples, order));
  const auto polygons = [](const Crust& c) {
    validators::Polygons result{ c.points, {} };
    for (Index f = 0; f < medial::count(c.triangles); ++f)
    {
      result.polygons.emplace_back(c.triangles[f].begin(), c.triangles[f].end());
    }
    return result;
  };
  EXPECT_EQ(crust.points.size(), reference.points.size());
  EXPECT_TRUE(validators::samePolygons(polygons(crust), polygons(reference), 1e-10));
}

TEST(PowerCrust, IsTheSameOnManyThreads)
{
  Pipeline& p = pipelines::of("box");
  EXPECT_EQ(pipelines::bytesOf(
              medial::powerCrust(p.balls(), p.keptAfterPruning(), {}, pipelines::threaded())),
    pipelines::bytesOf(p.crustAfterPruning()));
}

TEST(PowerCrust, ReportsProgressAndStops)
{
  const medial::PolarBalls all = medial::polarBalls(shapes::torus(0.3).samples);
  pipelines::expectProgressAndAbort(
    [&](const medial::Execution& execution) { medial::powerCrust(all, {}, {}, execution); });
}

TEST(PowerCrust, OfNoSurfaceAtAllIsStillClosed)
{
  std::vector<std::vector<Point>> inputs{ shapes::openBowl(), shapes::gridCube(5) };
  for (unsigned seed = 0; seed < 4; ++seed)
  {
    inputs.push_back(shapes::cloud(150, seed));
  }
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    SCOPED_TRACE(testing::Message() << "input " << i);
    const medial::PolarBalls all = medial::polarBalls(inputs[i]);
    if (std::count(all.sides.begin(), all.sides.end(), Side::Inner) == 0)
    {
      EXPECT_THROW(medial::powerCrust(all), medial::InvalidInput);
      continue;
    }
    const Crust crust = medial::powerCrust(all);
    EXPECT_EQ(
      crust.closed, validators::isClosed(facesOf(crust)) && validators::isOriented(facesOf(crust)));
    EXPECT_EQ(crust.manifold, validators::isTwoManifold(facesOf(crust)));
    EXPECT_TRUE(std::all_of(crust.points.begin(), crust.points.end(),
      [](const Point& point) { return point.allFinite(); }));
  }
}

TEST(PowerCrust, RefusesToKeepNothing)
{
  const medial::PolarBalls& all = pipelines::of("capsule").balls();
  EXPECT_THROW(
    medial::powerCrust(all, std::vector<char>(all.balls.size(), 0)), medial::InvalidInput);
  EXPECT_THROW(medial::powerCrust({}), medial::InvalidInput);
}

TEST(PowerCrust, RefusesAListThatDoesNotFit)
{
  const medial::PolarBalls& all = pipelines::of("capsule").balls();
  EXPECT_THROW(medial::powerCrust(all, { 1, 1, 1 }), medial::InvalidInput);
}

TEST(PowerCrust, RefusesAClearanceThatIsNotPositive)
{
  const medial::PolarBalls& all = pipelines::of("capsule").balls();
  for (const double bad : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    CrustOptions options;
    options.clearance = bad;
    EXPECT_THROW(medial::powerCrust(all, {}, options), medial::InvalidInput) << bad;
  }
}
