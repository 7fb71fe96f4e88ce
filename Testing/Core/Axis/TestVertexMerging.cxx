// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/VertexMerging.h"
#include "Complexes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using complexes::bettiNumbers;
using complexes::polygonsOf;
using medial::FacePolygon;
using medial::Index;
using medial::None;
using medial::Point;

namespace
{
std::vector<std::vector<Index>> simplePolygons(const std::vector<Index>& walk)
{
  std::vector<FacePolygon> polygons;
  medial::appendSimplePolygons(walk, 7, polygons);
  std::vector<std::vector<Index>> result;
  for (const FacePolygon& polygon : polygons)
  {
    EXPECT_EQ(polygon.siteEdge, 7);
    result.push_back(polygon.corners);
  }
  return result;
}
}

TEST(FacePolygon, WalksFallApartWhereTheyVisitAVertexAgain)
{
  using Lists = std::vector<std::vector<Index>>;
  EXPECT_EQ(simplePolygons({ 1, 2, 3 }), (Lists{ { 1, 2, 3 } }));
  EXPECT_EQ(simplePolygons({ 1, 2, 3, 4, 2, 5 }), (Lists{ { 2, 3, 4 }, { 1, 2, 5 } }));
  EXPECT_EQ(simplePolygons({ 1, 2, 3, 2 }), (Lists{ { 2, 3 }, { 1, 2 } }));
  EXPECT_EQ(simplePolygons({ 1, 1, 2 }), (Lists{ { 1, 2 } }));
  EXPECT_EQ(simplePolygons({ 1, 1 }), Lists{});
}

TEST(VertexMerging, KeepsTheBettiNumbersOfRandomComplexes)
{
  int merges = 0, midpoints = 0;
  for (unsigned seed = 0; seed < 100; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const medial::MedialAxis axis = complexes::randomComplex(seed).axis();
    const medial::Betti before = bettiNumbers(polygonsOf(axis.cells));
    const Index pointCount = medial::count(axis.points);
    std::mt19937 random(seed);
    for (int trial = 0; trial < 30; ++trial)
    {
      const Index a = static_cast<Index>(random() % pointCount);
      const Index b = (a + 1 + static_cast<Index>(random() % (pointCount - 1))) % pointCount;
      std::vector<FacePolygon> polygons = polygonsOf(axis.cells);
      std::vector<Point> points = axis.points;
      std::vector<Index> ball(pointCount, None);
      if (trial % 2 == 0)
      {
        points[a] = points[b];
      }
      else
      {
        ball[a] = ball[b] = 3;
      }
      const medial::MergedVertices merging = medial::mergeVertices(points, ball, polygons);
      EXPECT_EQ(bettiNumbers(polygons), before);
      for (const FacePolygon& polygon : polygons)
      {
        EXPECT_GE(polygon.corners.size(), 2u);
        for (const Index v : polygon.corners)
        {
          EXPECT_LT(v, pointCount + medial::count(merging.midpoints));
          EXPECT_FALSE(v < pointCount && merging.merged[v]);
        }
      }
      merges += static_cast<int>(std::count(merging.merged.begin(), merging.merged.end(), 1));
      midpoints += !merging.midpoints.empty();
    }
  }
  EXPECT_GT(merges, 2000);
  EXPECT_GT(midpoints, 1000);
}

TEST(VertexMerging, FoldsTwoEdgesToACommonNeighbour)
{
  std::vector<FacePolygon> polygons{ { { 0, 1 }, None }, { { 1, 2 }, None } };
  const Point a(0, 0, 0), b(1, 0, 0);
  const medial::MergedVertices merging =
    medial::mergeVertices({ a, b, a }, { None, None, None }, polygons);
  EXPECT_EQ(merging.merged, (std::vector<char>{ 0, 0, 1 }));
  EXPECT_TRUE(merging.midpoints.empty());
  for (const FacePolygon& polygon : polygons)
  {
    EXPECT_EQ(std::count(polygon.corners.begin(), polygon.corners.end(), 2), 0);
  }
}

TEST(VertexMerging, FillsTheLoopBetweenVerticesThatAreFarApart)
{
  // A chain of four edges whose ends are at one place.
  std::vector<FacePolygon> polygons{ { { 0, 1 }, None }, { { 1, 2 }, None }, { { 2, 3 }, None },
    { { 3, 4 }, None } };
  const Point end(0, 0, 0);
  const std::vector<Point> points{ end, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, end };
  medial::mergeVertices(points, std::vector<Index>(5, None), polygons);
  EXPECT_EQ(bettiNumbers(polygons), (medial::Betti{ 1, 0, 0 }));
  EXPECT_TRUE(std::any_of(polygons.begin(), polygons.end(),
    [](const FacePolygon& polygon) { return polygon.corners.size() == 4; }));
}

TEST(VertexMerging, LeavesPiecesApart)
{
  std::vector<FacePolygon> polygons{ { { 0, 1 }, None }, { { 2, 3 }, None } };
  const Point a(0, 0, 0), b(1, 0, 0), c(2, 0, 0);
  const medial::MergedVertices merging =
    medial::mergeVertices({ a, b, b, c }, std::vector<Index>(4, None), polygons);
  EXPECT_EQ(merging.merged, std::vector<char>(4, 0));
  EXPECT_EQ(polygons.size(), 2u);
}
