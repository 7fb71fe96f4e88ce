// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/ThinPlaces.h"

#include "Axis/MedialAxis.h"
#include "Base/Errors.h"
#include "PoissonDisk.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using medial::AxisComplex;
using medial::AxisThickness;
using medial::Edge;
using medial::Index;
using medial::MedialAxis;
using medial::Point;
using medial::PolarBalls;
using medial::ThinPlace;

namespace
{
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A line of points, one apart.
AxisComplex line(Index size)
{
  AxisComplex result;
  for (Index i = 0; i < size; ++i)
  {
    result.points.emplace_back(i, 0, 0);
    if (i > 0)
    {
      result.cells.edges.push_back({ i - 1, i });
    }
  }
  return result;
}

AxisThickness allWalls(const std::vector<double>& thickness)
{
  return { thickness, std::vector<char>(thickness.size(), 1) };
}

std::vector<Index> pointsOf(const std::vector<ThinPlace>& places)
{
  std::vector<Index> result;
  for (const ThinPlace& place : places)
  {
    result.push_back(place.point);
  }
  return result;
}

/// The places of a solid, as the filter finds them.
struct Found
{
  MedialAxis axis;
  std::vector<ThinPlace> places;
};

Found thinPlacesOf(const std::vector<Point>& samples)
{
  const PolarBalls balls = medial::polarBalls(samples);
  Found result{ medial::medialAxis(balls), {} };
  const auto walls = sampleWalls(balls);
  result.places =
    thinPlaces(result.axis, axisThickness(result.axis, balls, walls, wallDistances(balls, walls)));
  return result;
}

/// A rod along x with two necks: around the x axis, with this radius.
double rodRadius(double x)
{
  return 0.5 - 0.2 * std::exp(-(x - 1) * (x - 1) / 0.1) - 0.25 * std::exp(-(x + 1) * (x + 1) / 0.1);
}

std::vector<Point> rodWithTwoNecks(double spacing)
{
  return shapes::poissonDisk(
    [](shapes::Random& random) {
      const double x = shapes::uniform(random, -2.5, 2.5), angle = shapes::uniform(random, 0, 7);
      if (std::abs(x) <= 2)
      {
        const double r = rodRadius(x);
        return Point(x, r * shapes::cosine(angle), r * shapes::sine(angle));
      }
      Point end = 0.5 * shapes::direction(random); // half a ball
      end.x() = std::copysign(std::abs(end.x()), x);
      return Point(end + Point(std::copysign(2, x), 0, 0));
    },
    spacing, 2);
}
}

TEST(ThinPlaces, AreMinimaThatPersist)
{
  // Minima of 2, 1 and 3; the way from 3 rises by a third only, that from 2 by a half.
  const std::vector<double> thickness{ 4, 2, 3, 1, 4, 3, 5 };
  const AxisComplex axis = line(7);
  std::vector<ThinPlace> places = thinPlaces(axis, allWalls(thickness), 0.4);
  EXPECT_EQ(pointsOf(places), (std::vector<Index>{ 3, 1 }));
  EXPECT_EQ(places[0].depth, infinite);
  EXPECT_DOUBLE_EQ(places[1].depth, 0.5);
  EXPECT_EQ(places[1].thickness, 2);
  places = thinPlaces(axis, allWalls(thickness), 0.3);
  EXPECT_EQ(pointsOf(places), (std::vector<Index>{ 3, 1, 5 }));
  EXPECT_DOUBLE_EQ(places[2].depth, 4 / 3.0 - 1);
}

TEST(ThinPlaces, TakeTheLowestPointOfAPlateau)
{
  EXPECT_EQ(pointsOf(thinPlaces(line(5), allWalls({ 2, 1, 1, 1, 2 }))), (std::vector<Index>{ 1 }));
}

TEST(ThinPlaces, AreNotOnTheWayToAnEdge)
{
  // A wall of 3 between edges, where it gets thinner and thinner.
  AxisThickness thickness{ { 1, 2, 3, 3.01, 2.5, 0.5 }, { 0, 0, 1, 1, 0, 0 } };
  EXPECT_EQ(pointsOf(thinPlaces(line(6), thickness)), (std::vector<Index>{ 2 }));
  // The same between necks: the way leads down to them.
  thickness.isWall = { 1, 0, 1, 1, 0, 1 };
  EXPECT_EQ(pointsOf(thinPlaces(line(6), thickness)), (std::vector<Index>{ 5, 0 }));
  thickness.isWall.assign(6, 0);
  EXPECT_TRUE(thinPlaces(line(6), thickness).empty());
}

TEST(ThinPlaces, CountOnceInTheBallOfAThinnerOne)
{
  const AxisThickness thickness{ { 4.1, 1, 4 }, { 1, 0, 1 } };
  EXPECT_EQ(pointsOf(thinPlaces(line(3), thickness)), (std::vector<Index>{ 2 }));
}

TEST(ThinPlaces, AreTheNecksOfARod)
{
  // Balls in a round rod touch three or four samples.
  for (const double spacing : { 0.05, 0.08, 0.1 })
  {
    SCOPED_TRACE(spacing);
    const Found found = thinPlacesOf(rodWithTwoNecks(spacing));
    ASSERT_EQ(found.places.size(), 2u);
    EXPECT_NEAR(found.axis.points[found.places[0].point].x(), -1, 0.1);
    EXPECT_NEAR(found.places[0].thickness, 0.5, 0.02);
    EXPECT_NEAR(found.axis.points[found.places[1].point].x(), 1, 0.1);
    EXPECT_NEAR(found.places[1].thickness, 0.6, 0.02);
  }
}

TEST(ThinPlaces, AreNoSharpEdges)
{
  const Found found = thinPlacesOf(shapes::box(0.07).samples); // 3 x 2 x 1
  for (const ThinPlace& place : found.places)
  {
    EXPECT_GT(place.thickness, 0.9);
  }
  EXPECT_FALSE(found.places.empty());
}

TEST(ThinPlaces, RefuseANegativeDepth)
{
  EXPECT_THROW(thinPlaces(line(2), allWalls({ 1, 2 }), -0.1), medial::InvalidInput);
}
