// SPDX-License-Identifier: BSD-3-Clause
// No two points of the crust are at one place, and no triangle is flat, whatever the samples are.
#include "Pipelines.h"

#include "Base/Frame.h"
#include "Base/SolidMeasures.h"
#include "Crust/PowerCrust.h"
#include "Crust/Slivers.h"

#include <algorithm>
#include <map>

using medial::Crust;
using medial::CrustSurface;
using medial::Index;
using medial::None;
using medial::Point;
using medial::Triangle;

namespace
{
/// How small something may be, of the diagonal of all, and of its square.
constexpr double tolerance = 1e-12;

/// Of the samples of made surfaces.
constexpr double spacing = 0.1;

double diagonalOf(const std::vector<Point>& points)
{
  return medial::boundingBox(points).diagonal().norm();
}

Index flatTriangles(const CrustSurface& surface)
{
  const double diagonal = diagonalOf(surface.points);
  return static_cast<Index>(
    std::count_if(surface.triangles.begin(), surface.triangles.end(), [&](const Triangle& t) {
      const Point &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
      const double doubled = (b - a).cross(c - a).norm();
      const double longest = std::max({ (b - a).norm(), (c - a).norm(), (c - b).norm() });
      return doubled / 2 <= tolerance * diagonal * diagonal ||
        doubled <= tolerance * diagonal * longest;
    }));
}

/// As who reads an STL file makes it: in single precision, where a place is a point.
medial::SolidMeasures readBack(const CrustSurface& surface)
{
  const std::vector<Point> rounded = shapes::roundedToFloats(surface.points);
  std::map<std::array<double, 3>, Index> numbers;
  std::vector<Point> points;
  std::vector<Index> number;
  for (const Point& p : rounded)
  {
    const auto [known, added] = numbers.insert({ { p.x(), p.y(), p.z() }, medial::count(points) });
    number.push_back(known->second);
    if (added)
    {
      points.push_back(p);
    }
  }
  std::vector<Triangle> triangles;
  for (const Triangle& t : surface.triangles)
  {
    triangles.push_back({ number[t[0]], number[t[1]], number[t[2]] });
  }
  return medial::solidMeasures(points, triangles);
}

void expectNoSlivers(const Crust& crust)
{
  ASSERT_TRUE(crust.manifold);
  EXPECT_EQ(validators::nearDuplicates(crust.points, tolerance * diagonalOf(crust.points)), 0);
  EXPECT_EQ(flatTriangles(crust), 0);
  const medial::SolidMeasures read = readBack(crust);
  EXPECT_TRUE(read.closed);
  EXPECT_TRUE(read.manifold);
  EXPECT_EQ(read.betti, crust.betti);
}

/// A surface in a frame whose triangles have no balls.
CrustSurface surfaceOf(std::vector<Point> points, std::vector<Triangle> triangles)
{
  CrustSurface surface;
  surface.sampleOfPoint.assign(points.size(), None);
  surface.innerBall.resize(triangles.size());
  surface.outerBall.resize(triangles.size());
  for (Index t = 0; t < medial::count(triangles); ++t)
  {
    surface.innerBall[t] = t;
    surface.outerBall[t] = t + 100;
  }
  surface.points = std::move(points);
  surface.triangles = std::move(triangles);
  return surface;
}

/// A double pyramid over a polygon, with tips above and below.
CrustSurface doublePyramid(std::vector<Point> polygon)
{
  const Index n = medial::count(polygon);
  polygon.emplace_back(0, 0, 0.3);
  polygon.emplace_back(0, 0, -0.3);
  std::vector<Triangle> triangles;
  for (Index k = 0; k < n; ++k)
  {
    triangles.push_back({ k, (k + 1) % n, n });
    triangles.push_back({ (k + 1) % n, k, n + 1 });
  }
  return surfaceOf(std::move(polygon), std::move(triangles));
}
}

TEST(Slivers, AreNotInCrusts)
{
  pipelines::forEachShape([](pipelines::Pipeline& p) {
    expectNoSlivers(p.crust());
    expectNoSlivers(p.crustAfterPruning());
  });
}

TEST(Slivers, AreNotInCrustsOfSamplesThatAreNoSurface)
{
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const medial::PolarBalls balls = medial::polarBalls(shapes::cloud(400, seed));
    expectNoSlivers(medial::powerCrust(balls));
    expectNoSlivers(medial::powerCrust(balls, pipelines::keepBelow(balls, 0.5)));
  }
}

TEST(Slivers, AreNotInCrustsOfGrids)
{
  for (const int perEdge : { 5, 12, 24 })
  {
    SCOPED_TRACE(testing::Message() << perEdge << " per edge");
    const std::vector<Point> grid = shapes::gridCube(perEdge);
    expectNoSlivers(medial::powerCrust(medial::polarBalls(grid)));
    expectNoSlivers(medial::powerCrust(medial::polarBalls(shapes::rotated(grid, 3))));
    expectNoSlivers(medial::powerCrust(medial::polarBalls(shapes::roundedToFloats(grid))));
  }
}

TEST(Slivers, ShortEdgesAreContracted)
{
  CrustSurface surface =
    doublePyramid({ { 0.3, 0, 0 }, { 0, 0.3, 0 }, { -1e-9, 0.3, 0 }, { -0.3, 0, 0 } });
  surface.sampleOfPoint[2] = 7;
  medial::removeSlivers(surface, spacing);
  ASSERT_EQ(surface.points.size(), 5u);
  EXPECT_EQ(surface.triangles.size(), 6u);
  // The sample stays, and stays where it is.
  const auto sample = std::find(surface.sampleOfPoint.begin(), surface.sampleOfPoint.end(), 7);
  ASSERT_NE(sample, surface.sampleOfPoint.end());
  EXPECT_EQ(surface.points[sample - surface.sampleOfPoint.begin()], Point(-1e-9, 0.3, 0));
  for (Index t = 0; t < 6; ++t)
  {
    EXPECT_EQ(surface.outerBall[t], surface.innerBall[t] + 100);
    EXPECT_TRUE(surface.innerBall[t] < 2 || surface.innerBall[t] > 3); // these are gone
  }
}

TEST(Slivers, FlatTrianglesTakeTheOtherDiagonal)
{
  // Point 1 is on the line from 0 to 2, but triangle (0, 1, 2) is there, below it.
  CrustSurface surface = doublePyramid({ { 0.3, 0, 0 }, { 0, 0.3, 0 }, { -0.3, 0, 0 } });
  const Index middle = medial::count(surface.points);
  surface.points.emplace_back((surface.points[0] + surface.points[1]) / 2);
  surface.sampleOfPoint.push_back(None);
  surface.triangles[0] = { 0, middle, 3 };
  surface.triangles.push_back({ middle, 1, 3 });
  surface.triangles.push_back({ 1, middle, 0 });
  surface.innerBall.insert(surface.innerBall.end(), { 6, 7 });
  surface.outerBall.insert(surface.outerBall.end(), { 106, 107 });
  const CrustSurface before = surface;
  ASSERT_TRUE(medial::solidMeasures(before.points, before.triangles).manifold);
  ASSERT_EQ(flatTriangles(before), 1);
  medial::removeSlivers(surface, spacing);
  EXPECT_EQ(flatTriangles(surface), 0);
  EXPECT_EQ(surface.points, before.points);
  EXPECT_EQ(surface.triangles.size(), before.triangles.size());
  EXPECT_TRUE(medial::solidMeasures(surface.points, surface.triangles).manifold);
  EXPECT_EQ(std::count(surface.innerBall.begin(), surface.innerBall.end(), 7), 0);
  EXPECT_EQ(std::count(surface.innerBall.begin(), surface.innerBall.end(), 1), 2);
}

TEST(Slivers, PiecesThatTouchAreMovedApart)
{
  // Two double pyramids that share a place.
  CrustSurface surface = doublePyramid({ { 0.3, 0, 0 }, { 0, 0.3, 0 }, { -0.3, 0, 0 } });
  const CrustSurface one = surface;
  for (const Point& p : one.points)
  {
    surface.points.emplace_back(-p.x() + 0.6, p.y(), p.z());
    surface.sampleOfPoint.push_back(None);
  }
  surface.sampleOfPoint[0] = surface.sampleOfPoint[5] = 3;
  for (const Triangle& t : one.triangles)
  {
    surface.triangles.push_back({ t[0] + 5, t[2] + 5, t[1] + 5 });
    surface.innerBall.push_back(0);
    surface.outerBall.push_back(100);
  }
  medial::removeSlivers(surface, spacing);
  ASSERT_EQ(surface.points.size(), 10u);
  EXPECT_EQ(std::count(surface.sampleOfPoint.begin(), surface.sampleOfPoint.end(), 3), 1);
  EXPECT_EQ(surface.points[0], one.points[0]);
  EXPECT_GT((surface.points[0] - surface.points[5]).norm(), 1e-7);
  EXPECT_LT((surface.points[0] - surface.points[5]).norm(), 1e-6);
  EXPECT_GT(surface.points[5].x(), surface.points[0].x()); // into its own solid
}

TEST(Slivers, OfDenseSamplesAreSmallerOnes)
{
  CrustSurface surface =
    doublePyramid({ { 0.3, 0, 0 }, { 0, 0.3, 0 }, { -1e-7, 0.3, 0 }, { -0.3, 0, 0 } });
  CrustSurface copy = surface;
  medial::removeSlivers(copy, spacing);
  EXPECT_EQ(copy.points.size(), 5u);
  medial::removeSlivers(surface, 1e-5);
  EXPECT_EQ(surface.points.size(), 6u);
}

TEST(Slivers, DifferentSamplesStay)
{
  CrustSurface surface =
    doublePyramid({ { 0.3, 0, 0 }, { 0, 0.3, 0 }, { -1e-7, 0.3, 0 }, { -0.3, 0, 0 } });
  surface.sampleOfPoint[1] = 6;
  surface.sampleOfPoint[2] = 7;
  const std::vector<Point> before = surface.points;
  medial::removeSlivers(surface, spacing);
  EXPECT_EQ(surface.points, before);
}
