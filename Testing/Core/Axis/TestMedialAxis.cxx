// SPDX-License-Identifier: BSD-3-Clause
#include "Numbers.h"
#include "Pipelines.h"

#include "Axis/MedialAxis.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>

using medial::Betti;
using medial::Index;
using medial::MedialAxis;
using medial::None;
using medial::Point;
using medial::Side;
using pipelines::forEachShape;
using pipelines::Pipeline;

namespace
{
/// The points of a cell, whatever its dimension.
std::vector<Index> corners(const medial::AxisCells& cells, Index cell)
{
  if (cell < cells.firstEdge())
  {
    return { cells.vertices[cell] };
  }
  if (cell < cells.firstTriangle())
  {
    const medial::Edge& edge = cells.edges[cell - cells.firstEdge()];
    return { edge.begin(), edge.end() };
  }
  const medial::Triangle& triangle = cells.triangles[cell - cells.firstTriangle()];
  return { triangle.begin(), triangle.end() };
}

/// How many seeds to try: those of every day, or as many as MEDIAL_TEST_SEEDS says.
unsigned seeds(unsigned usual)
{
  const char* wanted = std::getenv("MEDIAL_TEST_SEEDS");
  return wanted ? static_cast<unsigned>(std::strtoul(wanted, nullptr, 10)) : usual;
}

std::vector<medial::Ball> ballsOf(const MedialAxis& axis)
{
  std::vector<medial::Ball> balls;
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    balls.push_back({ axis.points[i], axis.radii[i] });
  }
  return balls;
}

/// Undersampled, noisy or no surfaces at all: what the certificate is for.
std::vector<std::vector<Point>> hostile()
{
  std::vector<std::vector<Point>> result{ shapes::openBowl(), shapes::gridCube(3),
    shapes::gridCube(6), shapes::torus(0.55).samples, shapes::knot(0.4).samples,
    shapes::twoHolePlate(0.25).samples };
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    result.push_back(shapes::cloud(40 + 30 * static_cast<int>(seed), seed));
  }
  return result;
}
}

TEST(MedialAxis, HasTheTopologyOfTheSolid)
{
  forEachShape([](Pipeline& p) {
    EXPECT_EQ(pipelines::independentBetti(p.axis()), p.shape.betti);
    EXPECT_TRUE(p.axis().certificate);
    EXPECT_FALSE(p.axis().fallback);
  });
}

TEST(MedialAxis, StatesItsBettiNumbers)
{
  forEachShape([](Pipeline& p) {
    EXPECT_EQ(p.axis().betti, pipelines::independentBetti(p.axis()));
    EXPECT_EQ(p.axis().powerShapeBetti, p.powerShape().betti);
  });
}

TEST(MedialAxis, CertificateIsHonest)
{
  const auto samples = hostile();
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    for (const auto fallback : { medial::AxisFallback::Collapse, medial::AxisFallback::Nearest })
    {
      SCOPED_TRACE(testing::Message() << "input " << i << ", fallback " << int(fallback));
      const medial::PolarBalls balls = medial::polarBalls(samples[i]);
      if (std::count(balls.sides.begin(), balls.sides.end(), Side::Inner) == 0)
      {
        EXPECT_THROW(medial::medialAxis(balls, { fallback }), medial::InvalidInput);
        continue;
      }
      const MedialAxis axis = medial::medialAxis(balls, { fallback });
      EXPECT_EQ(axis.betti, pipelines::independentBetti(axis));
      EXPECT_EQ(axis.powerShapeBetti, medial::powerShape(balls).betti);
      EXPECT_EQ(axis.certificate, axis.betti == axis.powerShapeBetti);
      EXPECT_TRUE(axis.certificate || fallback == medial::AxisFallback::Nearest);
      EXPECT_EQ(axis.fallback, axis.kappa == -1);
      EXPECT_FALSE(axis.fallback && fallback == medial::AxisFallback::Nearest);
    }
  }
}

TEST(MedialAxis, GapsAreFilledWhereTheyAre)
{
  // Samples too sparse in a few places: no choice of candidates gives the power shape's topology.
  const unsigned end = seeds(4);
  Index repaired = 0;
  for (unsigned seed = 1; seed <= end; ++seed)
  {
    for (const shapes::Shape& shape : { shapes::twoHolePlate(0.25, seed),
           shapes::twoHolePlate(0.3, seed), shapes::torus(0.55, seed) })
    {
      SCOPED_TRACE(testing::Message() << shape.name << ", seed " << seed);
      const MedialAxis axis = medial::medialAxis(medial::polarBalls(shape.samples));
      EXPECT_EQ(pipelines::independentBetti(axis), axis.powerShapeBetti);
      EXPECT_TRUE(axis.certificate);
      EXPECT_FALSE(axis.fallback);
      repaired += axis.filledGaps > 0;
    }
  }
  EXPECT_GE(repaired, 4);
}

TEST(MedialAxis, HasNoDuplicatePoints)
{
  forEachShape([](Pipeline& p) {
    EXPECT_EQ(validators::nearDuplicates(p.axis().points, 1e-9 * p.diagonal), 0);
  });
}

TEST(MedialAxis, HasNoDuplicatePointsWhereSamplesWereRounded)
{
  // Poles that were the same are now some 1e-8 apart: near the tolerance.
  for (const shapes::Shape& shape : { shapes::sphere(), shapes::sphere(0.08), shapes::capsule(),
         shapes::twoObjects(), shapes::hollowSphere() })
  {
    SCOPED_TRACE(testing::Message() << shape.name << " of " << shape.samples.size());
    const std::vector<Point> samples = shapes::roundedToFloats(shape.samples);
    const MedialAxis axis = medial::medialAxis(medial::polarBalls(samples));
    EXPECT_EQ(axis.betti, shape.betti);
    EXPECT_EQ(pipelines::independentBetti(axis), shape.betti);
    EXPECT_TRUE(axis.certificate);
    EXPECT_EQ(validators::nearDuplicates(axis.points, 1e-9 * validators::diagonal(samples)), 0);
  }
}

TEST(MedialAxis, HasNoDuplicatePointsInAnyRoundedSphere)
{
  // All poles of a rounded sphere crowd around its centre, and merging adds vertices between them.
  const unsigned end = seeds(40);
  for (unsigned seed = 0; seed < end; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const std::vector<Point> samples = shapes::roundedToFloats(shapes::sphere(0.1, seed).samples);
    const MedialAxis axis = medial::medialAxis(medial::polarBalls(samples));
    EXPECT_EQ(axis.betti, (Betti{ 1, 0, 0 }));
    EXPECT_TRUE(axis.certificate);
    EXPECT_EQ(validators::nearDuplicates(axis.points, 1e-9 * validators::diagonal(samples)), 0);
  }
}

TEST(MedialAxis, HasNoDuplicatePointsInAnyNearlyRoundSphere)
{
  // A thousand poles crowd around its centre. Where samples are nearly exact, one ball stands for all of them; beyond
  // that merging adds vertices between them.
  const unsigned end = seeds(40);
  for (unsigned seed = 0; seed < end; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    shapes::Random random(seed);
    std::vector<Point> samples = shapes::sphere(0.1, seed).samples;
    const bool isNearlyExact = seed % 2 == 0;
    for (Point& sample : samples)
    {
      sample += shapes::normalPoint(random, isNearlyExact ? 1e-6 : 1e-3);
    }
    const MedialAxis axis = medial::medialAxis(medial::polarBalls(samples));
    EXPECT_TRUE(isNearlyExact ? axis.points.size() == 1 : axis.points.size() > 100)
      << axis.points.size();
    EXPECT_TRUE(axis.certificate);
    EXPECT_EQ(validators::nearDuplicates(axis.points, 1e-9 * validators::diagonal(samples)), 0);
  }
}

TEST(MedialAxis, UsesEveryPointAndRepeatsNoCell)
{
  forEachShape([](Pipeline& p) {
    const validators::Complex complex = complexes::complexOf(p.axis().cells);
    EXPECT_EQ(validators::unusedPoints(medial::count(p.axis().points), complex), 0);
    EXPECT_EQ(validators::repeatedSimplices(complex), 0);
  });
}

TEST(MedialAxis, CellsAreInNoHigherCell)
{
  forEachShape([](Pipeline& p) {
    std::set<Index> inHigher;
    std::set<medial::Edge> sides;
    for (medial::Triangle t : p.axis().cells.triangles)
    {
      std::sort(t.begin(), t.end());
      inHigher.insert(t.begin(), t.end());
      sides.insert({ medial::Edge{ t[0], t[1] }, { t[1], t[2] }, { t[0], t[2] } });
    }
    for (medial::Edge edge : p.axis().cells.edges)
    {
      std::sort(edge.begin(), edge.end());
      inHigher.insert(edge.begin(), edge.end());
      EXPECT_EQ(sides.count(edge), 0u);
    }
    for (const Index vertex : p.axis().cells.vertices)
    {
      EXPECT_EQ(inHigher.count(vertex), 0u);
    }
  });
}

TEST(MedialAxis, ArraysHaveAnEntryForEach)
{
  forEachShape([](Pipeline& p) {
    const MedialAxis& axis = p.axis();
    EXPECT_EQ(axis.radii.size(), axis.points.size());
    EXPECT_EQ(axis.ballOfPoint.size(), axis.points.size());
    EXPECT_EQ(medial::count(axis.polygonOfCell), axis.cells.size());
    EXPECT_EQ(medial::count(axis.samplesOfCell), axis.cells.size());
    EXPECT_EQ(axis.ballOwner.size(), p.balls().balls.size());
    EXPECT_EQ(axis.ballVolumes, p.balls().volumes);
  });
}

TEST(MedialAxis, LiesOnTheExactAxis)
{
  forEachShape([](Pipeline& p) {
    double sum = 0, largest = 0;
    for (const Point& point : p.axis().points)
    {
      const double distance = p.shape.axisDistance(point);
      sum += distance;
      largest = std::max(largest, distance);
    }
    EXPECT_LT(sum / p.axis().points.size(), 0.003 * p.diagonal);
    EXPECT_LT(largest, 0.3 * p.shape.spacing);
  });
}

TEST(MedialAxis, ReachesTheWholeSolid)
{
  // The union of its balls comes to every sample; at sharp edges nearly so.
  forEachShape([](Pipeline& p) {
    const std::vector<medial::Ball> balls = ballsOf(p.axis());
    double farthest = 0;
    for (const Point& sample : p.shape.samples)
    {
      farthest = std::max(farthest, validators::clearance(sample, balls));
    }
    EXPECT_LT(farthest, (p.shape.smooth ? 0.1 : 1.5) * p.shape.spacing);
  });
}

TEST(MedialAxis, RadiusIsTheDistanceToTheNearestSite)
{
  forEachShape([](Pipeline& p) {
    const validators::NearestPoint nearestSite(p.sites().positions);
    const validators::NearestPoint nearestSample(p.shape.samples);
    for (std::size_t i = 0; i < p.axis().points.size(); ++i)
    {
      const auto& nearest = p.axis().ballOfPoint[i] == None ? nearestSite : nearestSample;
      ASSERT_NEAR(nearest.distance(p.axis().points[i]), p.axis().radii[i], 1e-7 * p.diagonal)
        << "point " << i << ", ball " << p.axis().ballOfPoint[i];
    }
  });
}

TEST(MedialAxis, PointsOnABallAreItsPole)
{
  forEachShape([](Pipeline& p) {
    for (std::size_t i = 0; i < p.axis().points.size(); ++i)
    {
      const Index ball = p.axis().ballOfPoint[i];
      if (ball != None)
      {
        ASSERT_EQ(p.balls().sides[ball], Side::Inner);
        ASSERT_EQ(p.axis().points[i], p.balls().balls[ball].center);
        ASSERT_EQ(p.axis().radii[i], p.balls().balls[ball].radius);
      }
    }
  });
}

TEST(MedialAxis, HasNearlyAllInnerPoles)
{
  // [AK00]: all of them, for the exact axis of the union of balls (paper, Observation 1).
  forEachShape([](Pipeline& p) {
    std::set<Index> onAxis(p.axis().ballOfPoint.begin(), p.axis().ballOfPoint.end());
    onAxis.erase(None);
    const auto inner = std::count(p.balls().sides.begin(), p.balls().sides.end(), Side::Inner);
    EXPECT_GT(static_cast<double>(onAxis.size()) / static_cast<double>(inner), 0.9);
  });
}

TEST(MedialAxis, EveryInnerBallHasAnOwnerOnTheAxis)
{
  forEachShape([](Pipeline& p) {
    std::set<Index> onAxis(p.axis().ballOfPoint.begin(), p.axis().ballOfPoint.end());
    onAxis.erase(None);
    for (Index b = 0; b < medial::count(p.axis().ballOwner); ++b)
    {
      const Index owner = p.axis().ballOwner[b];
      if (p.balls().sides[b] != Side::Inner)
      {
        ASSERT_EQ(owner, None);
        continue;
      }
      ASSERT_EQ(onAxis.count(owner), 1u) << "ball " << b;
      ASSERT_TRUE(onAxis.count(b) == 0 || owner == b);
    }
  });
}

TEST(MedialAxis, CellsAreAsFarFromTheirTwoSites)
{
  forEachShape([](Pipeline& p) {
    const MedialAxis& axis = p.axis();
    for (Index cell = 0; cell < axis.cells.size(); ++cell)
    {
      const medial::Edge& samples = axis.samplesOfCell[cell];
      for (const Index corner : corners(axis.cells, cell))
      {
        for (const Index sample : samples)
        {
          if (sample != None)
          {
            ASSERT_NEAR((axis.points[corner] - p.shape.samples[sample]).norm(), axis.radii[corner],
              1e-7 * p.diagonal)
              << "cell " << cell;
          }
        }
      }
    }
  });
}

TEST(MedialAxis, TrianglesOfAPolygonHaveTheSameSites)
{
  forEachShape([](Pipeline& p) {
    const MedialAxis& axis = p.axis();
    std::map<Index, medial::Edge> samples;
    for (Index cell = 0; cell < axis.cells.size(); ++cell)
    {
      const Index polygon = axis.polygonOfCell[cell];
      ASSERT_EQ(polygon != None, cell >= axis.cells.firstTriangle());
      if (polygon != None)
      {
        ASSERT_EQ(samples.emplace(polygon, axis.samplesOfCell[cell]).first->second,
          axis.samplesOfCell[cell]);
      }
    }
  });
}

TEST(MedialAxis, OfASphereIsItsCenter)
{
  const MedialAxis& axis = pipelines::of("sphere").axis();
  ASSERT_EQ(axis.points.size(), 1u);
  EXPECT_LT(axis.points[0].norm(), 1e-12);
  EXPECT_NEAR(axis.radii[0], 1, 1e-12);
  EXPECT_EQ(axis.cells.vertices, std::vector<Index>{ 0 });
  EXPECT_EQ(axis.cells.size(), 1);
}
