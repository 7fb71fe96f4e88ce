// SPDX-License-Identifier: BSD-3-Clause
#include "Complexes.h"

#include "Base/Lists.h"
#include "Shapes.h"
#include "Validators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

using namespace validators;

namespace
{
/// The faces of a cube of side 2 about the origin, looking outwards.
const std::vector<Point> cubePoints{ { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 },
  { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } };

const std::vector<std::vector<Index>> cubeFaces{ { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 },
  { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };

IndexLists lists(const std::vector<std::vector<Index>>& faces)
{
  IndexLists result;
  for (const std::vector<Index>& face : faces)
  {
    result.items.insert(result.items.end(), face.begin(), face.end());
    result.close();
  }
  return result;
}

/// The same faces with other corner numbers, in reverse order if asked.
std::vector<std::vector<Index>> renumbered(
  std::vector<std::vector<Index>> faces, Index offset, bool inwards = false)
{
  for (std::vector<Index>& face : faces)
  {
    for (Index& corner : face)
    {
      corner += offset;
    }
    if (inwards)
    {
      std::reverse(face.begin(), face.end());
    }
  }
  return faces;
}

std::vector<std::vector<Index>> both(
  std::vector<std::vector<Index>> a, const std::vector<std::vector<Index>>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// A grid of quads closed both ways: a torus, or with a twist a Klein bottle.
std::vector<std::vector<Index>> closedGrid(Index rows, Index columns, bool twist)
{
  std::vector<std::vector<Index>> faces;
  const auto at = [&](Index i, Index j) {
    const bool turned = twist && i == rows;
    const Index column = turned ? (columns - j % columns) % columns : j % columns;
    return i % rows * columns + column;
  };
  for (Index i = 0; i < rows; ++i)
  {
    for (Index j = 0; j < columns; ++j)
    {
      faces.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return faces;
}

std::vector<Triangle> triangles(const IndexLists& faces)
{
  const IndexLists fans = triangulated(faces);
  std::vector<Triangle> result;
  for (Index f = 0; f < fans.size(); ++f)
  {
    result.push_back({ fans[f][0], fans[f][1], fans[f][2] });
  }
  return result;
}

std::vector<Point> torusGridPoints(Index rows, Index columns)
{
  std::vector<Point> points;
  for (Index k = 0; k < rows * columns; ++k)
  {
    const double u = 2 * M_PI * (k / columns) / rows, v = 2 * M_PI * (k % columns) / columns;
    const double radius = 2 + std::cos(v);
    points.emplace_back(radius * std::cos(u), radius * std::sin(u), std::sin(v));
  }
  return points;
}
}

TEST(Validators, BettiNumbersAreKnownOfSmallComplexes)
{
  EXPECT_EQ(bettiNumbers({}), (Betti{ 0, 0, 0 }));
  EXPECT_EQ(bettiNumbers({ { 0, 5 }, {}, {}, {} }), (Betti{ 2, 0, 0 }));
  EXPECT_EQ(bettiNumbers({ {}, { { 0, 1 }, { 1, 2 }, { 2, 0 } }, {}, {} }), (Betti{ 1, 1, 0 }));
  EXPECT_EQ(bettiNumbers({ {}, {}, { { 0, 1, 2 } }, {} }), (Betti{ 1, 0, 0 }));
  EXPECT_EQ(bettiNumbers({ {}, {}, { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 2, 3 }, { 1, 2, 3 } }, {} }),
    (Betti{ 1, 0, 1 }));
  EXPECT_EQ(bettiNumbers({ {}, {}, {}, { { 0, 1, 2, 3 } } }), (Betti{ 1, 0, 0 }));
}

TEST(Validators, BettiNumbersAreThoseOfClosedSurfaces)
{
  EXPECT_EQ(bettiNumbers({ {}, {}, triangles(lists(cubeFaces)), {} }), (Betti{ 1, 0, 1 }));
  EXPECT_EQ(
    bettiNumbers({ {}, {}, triangles(lists(closedGrid(7, 5, false))), {} }), (Betti{ 1, 2, 1 }));
  // Over Z/2 a Klein bottle looks like a torus.
  EXPECT_EQ(
    bettiNumbers({ {}, {}, triangles(lists(closedGrid(7, 5, true))), {} }), (Betti{ 1, 2, 1 }));
}

TEST(Validators, BettiNumbersFitTheEulerCharacteristic)
{
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Complex complex = complexes::complexOf(complexes::randomComplex(seed).cells);
    const Betti betti = bettiNumbers(complex);
    EXPECT_EQ(betti[0] - betti[1] + betti[2], eulerCharacteristic(complex));
  }
}

TEST(Validators, BettiNumbersRefuseARepeatedCorner)
{
  EXPECT_THROW(bettiNumbers({ {}, {}, { { 0, 1, 1 } }, {} }), std::invalid_argument);
}

TEST(Validators, RepeatedSimplicesAreFoundInAnyOrderOfCorners)
{
  EXPECT_EQ(repeatedSimplices({ {}, { { 0, 1 } }, { { 0, 1, 2 }, { 1, 2, 3 } }, {} }), 0);
  EXPECT_EQ(repeatedSimplices({ {}, {}, { { 0, 1, 2 }, { 2, 0, 1 } }, {} }), 1);
  EXPECT_EQ(repeatedSimplices({ { 4, 4 }, { { 0, 1 }, { 1, 0 } }, {}, {} }), 2);
}

TEST(Validators, UnusedPointsAreCounted)
{
  EXPECT_EQ(unusedPoints(6, { { 4 }, { { 0, 3 } }, {}, {} }), 3);
  EXPECT_EQ(unusedPoints(3, { {}, {}, { { 0, 1, 2 } }, {} }), 0);
}

TEST(Validators, FloodFillStopsAtEdgesOfThreeTriangles)
{
  const std::vector<Triangle> fan{ { 0, 1, 2 }, { 0, 1, 3 }, { 0, 1, 4 } };
  EXPECT_EQ(floodFill(fan), (std::vector<Index>{ 0, 1, 2 }));
  const std::vector<Triangle> strip{ { 0, 1, 2 }, { 2, 1, 3 }, { 7, 8, 9 }, { 2, 3, 4 } };
  EXPECT_EQ(floodFill(strip), (std::vector<Index>{ 0, 0, 1, 0 }));
}

TEST(Validators, LevelsCountFromTheBorderInwards)
{
  // A closed surface with a fin: the surface has no edge of its own.
  std::vector<Triangle> all = triangles(lists(closedGrid(4, 5, false)));
  all.push_back({ 0, 1, 100 });
  const std::vector<Index> labels = floodFill(all);
  EXPECT_EQ(levels(all, labels), (std::vector<int>{ 2, 1 }));
  all.pop_back();
  EXPECT_EQ(levels(all, floodFill(all)), (std::vector<int>{ 0 }));
}

TEST(Validators, SameGroupsIgnoresLabelsOnly)
{
  EXPECT_TRUE(sameGroups({ 0, 0, 1, 2 }, { 5, 5, 3, 0 }));
  EXPECT_FALSE(sameGroups({ 0, 0, 1 }, { 0, 1, 1 }));
  EXPECT_FALSE(sameGroups({ 0, 0, 1 }, { 0, 0, 0 }));
  EXPECT_FALSE(sameGroups({ 0, 0, 0 }, { 0, 0, 1 }));
  EXPECT_FALSE(sameGroups({ 0 }, { 0, 0 }));
}

TEST(Validators, AcceptACube)
{
  const IndexLists cube = lists(cubeFaces);
  EXPECT_TRUE(isClosed(cube));
  EXPECT_TRUE(isOriented(cube));
  EXPECT_TRUE(isTwoManifold(cube));
  EXPECT_EQ(eulerCharacteristic(cube), 2);
  EXPECT_DOUBLE_EQ(enclosedVolume(cubePoints, cube), 8);
  EXPECT_EQ(bettiOfSolid(cubePoints, cube), (Betti{ 1, 0, 0 }));
  EXPECT_TRUE(isTwoManifold(triangulated(cube)));
}

TEST(Validators, RefuseAHole)
{
  std::vector<std::vector<Index>> faces = cubeFaces;
  faces.pop_back();
  EXPECT_FALSE(isClosed(lists(faces)));
  EXPECT_FALSE(isTwoManifold(lists(faces)));
  EXPECT_TRUE(isOriented(lists(faces)));
  EXPECT_THROW(bettiOfSolid(cubePoints, lists(faces)), std::invalid_argument);
  EXPECT_FALSE(isClosed(IndexLists{}));
}

TEST(Validators, RefuseATurnedFace)
{
  std::vector<std::vector<Index>> faces = cubeFaces;
  std::reverse(faces[2].begin(), faces[2].end());
  EXPECT_FALSE(isOriented(lists(faces)));
  EXPECT_TRUE(isClosed(lists(faces)));
  EXPECT_THROW(bettiOfSolid(cubePoints, lists(faces)), std::invalid_argument);
}

TEST(Validators, RefuseAFaceGivenTwice)
{
  EXPECT_FALSE(isClosed(lists(both(cubeFaces, { cubeFaces[0] }))));
}

TEST(Validators, RefuseTwoCubesThatTouch)
{
  // At a corner: every edge is fine, the corner has two fans.
  std::vector<std::vector<Index>> other = renumbered(cubeFaces, 7);
  const IndexLists atCorner = lists(both(cubeFaces, other));
  EXPECT_TRUE(isClosed(atCorner));
  EXPECT_FALSE(isTwoManifold(atCorner));
  // At an edge: four faces there.
  for (std::vector<Index>& face : other)
  {
    std::replace(face.begin(), face.end(), 8, 3);
  }
  EXPECT_FALSE(isClosed(lists(both(cubeFaces, other))));
}

TEST(Validators, RefuseAKleinBottlesOrientation)
{
  const IndexLists bottle = lists(closedGrid(7, 5, true));
  EXPECT_TRUE(isTwoManifold(bottle));
  EXPECT_FALSE(isOriented(bottle));
}

TEST(Validators, BettiOfSolidTellsTunnelsVoidsAndPieces)
{
  const std::vector<Point> torusPoints = torusGridPoints(20, 10);
  IndexLists torus = lists(closedGrid(20, 10, false));
  if (enclosedVolume(torusPoints, torus) < 0)
  {
    torus = lists(renumbered(closedGrid(20, 10, false), 0, true));
  }
  EXPECT_EQ(bettiOfSolid(torusPoints, torus), (Betti{ 1, 1, 0 }));

  std::vector<Point> points = cubePoints;
  for (const Point& point : cubePoints)
  {
    points.push_back(0.5 * point);
  }
  EXPECT_EQ(bettiOfSolid(points, lists(both(cubeFaces, renumbered(cubeFaces, 8, true)))),
    (Betti{ 1, 0, 1 }));
  EXPECT_EQ(
    bettiOfSolid(points, lists(both(cubeFaces, renumbered(cubeFaces, 8)))), (Betti{ 2, 0, 0 }));
  EXPECT_EQ(bettiOfSolid(cubePoints, lists(renumbered(cubeFaces, 0, true))), (Betti{ 0, 0, 1 }));
}

TEST(Validators, VolumeIsNegativeInsideOutAndIndependentOfTheOrigin)
{
  const IndexLists inwards = lists(renumbered(cubeFaces, 0, true));
  EXPECT_DOUBLE_EQ(enclosedVolume(cubePoints, inwards), -8);
  const std::vector<Point> far = shapes::moved(cubePoints, Point(100, -50, 20));
  EXPECT_NEAR(enclosedVolume(far, lists(cubeFaces)), 8, 1e-9);
}

TEST(Validators, NearestPointAgreesWithASearchOfAll)
{
  const std::vector<Point> points = shapes::sphere().samples;
  const NearestPoint nearest(points);
  for (const Point& place : shapes::rotated(points, 5))
  {
    double best = INFINITY;
    for (const Point& point : points)
    {
      best = std::min(best, (point - place).norm());
    }
    EXPECT_EQ(nearest.distance(place), best);
  }
  EXPECT_EQ(nearest(points[17]), 17);
  EXPECT_NE(nearest(points[17], 17), 17);
  EXPECT_EQ(NearestPoint({})(Point(0, 0, 0)), None);
}

TEST(Validators, NearDuplicatesAreCountedWithinTheTolerance)
{
  const std::vector<Point> points{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1e-3, 0 }, { 3, 0, 0 } };
  EXPECT_EQ(nearDuplicates(points, 1e-4), 0);
  EXPECT_EQ(nearDuplicates(points, 2e-3), 2);
}

TEST(Validators, MeanSpacingIsThatOfAGrid)
{
  EXPECT_DOUBLE_EQ(meanSpacing(shapes::scaled(shapes::gridCube(4), 0.5)), 0.5);
}

TEST(Validators, HausdorffDistanceHasADirection)
{
  const std::vector<Point> one{ { 0, 0, 0 } }, two{ { 0, 0, 0 }, { 0, 3, 4 } };
  EXPECT_EQ(hausdorffDistance(one, two), 0);
  EXPECT_EQ(hausdorffDistance(two, one), 5);
}

TEST(Validators, NearestOnTriangleFindsInsideSidesAndCorners)
{
  const Point a(0, 0, 0), b(2, 0, 0), c(0, 2, 0);
  EXPECT_TRUE(nearestOnTriangle(Point(0.5, 0.5, 3), a, b, c).isApprox(Point(0.5, 0.5, 0)));
  EXPECT_TRUE(nearestOnTriangle(Point(1, -5, 0), a, b, c).isApprox(Point(1, 0, 0)));
  EXPECT_TRUE(nearestOnTriangle(Point(9, -1, 1), a, b, c).isApprox(b));
  EXPECT_TRUE(nearestOnTriangle(Point(2, 2, 0), a, b, c).isApprox(Point(1, 1, 0)));
  EXPECT_TRUE(nearestOnTriangle(Point(1, 1, 0), a, b, b).isApprox(Point(1, 0, 0))); // flat
}

TEST(Validators, PointsInsideABallAreThoseBeyondTheTolerance)
{
  const Ball ball{ Point(1, 0, 0), 2 };
  EXPECT_EQ(pointsInside(ball, { { 1, 0, 0 }, { 2.95, 0, 0 }, { 3, 0, 0 }, { 9, 0, 0 } }, 0.1), 1);
  EXPECT_EQ(pointsInside(ball, { { 1, 0, 0 }, { 2.95, 0, 0 }, { 3, 0, 0 }, { 9, 0, 0 } }, 0), 2);
}

TEST(Validators, ClearanceIsToTheUnionOfBalls)
{
  const std::vector<Ball> balls{ { Point(0, 0, 0), 1 }, { Point(5, 0, 0), 2 } };
  EXPECT_DOUBLE_EQ(clearance(Point(2, 0, 0), balls), 1);
  EXPECT_DOUBLE_EQ(clearance(Point(4, 0, 0), balls), -1);
}

TEST(Validators, SamePolygonsAllowsRenumberingAndNothingElse)
{
  const Polygons a{ cubePoints, cubeFaces };
  Polygons b;
  const std::vector<Index> order = shapes::shuffledOrder(8, 3);
  b.points = shapes::reordered(cubePoints, order);
  for (std::vector<Index> face : cubeFaces)
  {
    for (Index& corner : face)
    {
      corner = static_cast<Index>(std::find(order.begin(), order.end(), corner) - order.begin());
    }
    std::rotate(face.begin(), face.begin() + 1, face.end());
    b.polygons.insert(b.polygons.begin(), face);
  }
  EXPECT_TRUE(samePolygons(a, b, 1e-9));
  std::swap(b.polygons[0][0], b.polygons[1][1]);
  EXPECT_FALSE(samePolygons(a, b, 1e-9));
  EXPECT_FALSE(samePolygons(a, { shapes::moved(cubePoints, Point(0.1, 0, 0)), cubeFaces }, 0.01));
  EXPECT_FALSE(samePolygons(a, { cubePoints, {} }, 1e-9));
}
