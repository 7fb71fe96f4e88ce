// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Trimming.h"
#include "Complexes.h"
#include "Numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using complexes::bettiNumbers;
using complexes::Drawing;
using complexes::partCount;
using medial::Edge;
using medial::FaceGeometry;
using medial::FacePolygon;
using medial::Index;
using medial::None;
using medial::Point;
using medial::Triangle;

namespace
{
/// What is drawn as faces and edges, with the two sites of each face.
struct Drawn
{
  FaceGeometry geometry;
  std::vector<FacePolygon> polygons;
};

/// All vertices are poles. `sitesOf(triangle)` are two of the sites.
template <typename SitesOf>
Drawn drawn(const Drawing& drawing, std::vector<Point> sites, const SitesOf& sitesOf)
{
  const medial::MedialAxis axis = drawing.axis();
  Drawn result{ { axis.points, axis.ballOfPoint, std::move(sites), {} }, {} };
  for (const Triangle& t : axis.cells.triangles)
  {
    result.polygons.push_back({ { t[0], t[1], t[2] }, medial::count(result.polygons) });
    result.geometry.siteEdges.push_back(sitesOf(t));
  }
  for (const Edge& edge : axis.cells.edges)
  {
    result.polygons.push_back({ { edge[0], edge[1] }, None });
  }
  return result;
}

/// At one of three equal angles about the z axis.
Point around(double k)
{
  const double third = 2 * std::acos(-1.) / 3;
  return { std::cos(k * third), std::sin(k * third), 0 };
}

/// Sheets 0, 1 and 2 are at these angles; the sites lie between them, the two of a sheet beside it.
Drawn aroundZ(const Drawing& drawing)
{
  std::vector<Point> sites;
  for (int k = 0; k < 3; ++k)
  {
    sites.push_back(4 * around(k + 0.5) + Point(0, 0, 3.5));
  }
  const std::vector<Point> points = drawing.axis().points;
  return drawn(drawing, sites, [&](const Triangle& t) {
    const Point middle = points[t[0]] + points[t[1]] + points[t[2]];
    const auto nearer = [&](int a, int b) {
      return middle.dot(around(a)) > middle.dot(around(b)) ? a : b;
    };
    const int k = nearer(nearer(0, 1), 2);
    return Edge{ k, (k + 2) % 3 };
  });
}

/// Three sheets, 5 wide and 7 high; the third is lower.
Drawn threeSheets(int heightOfThird)
{
  Drawing drawing;
  for (int k = 0; k < 3; ++k)
  {
    drawing.sheet(Point::Zero(), Point(0, 0, 1), around(k), k == 2 ? heightOfThird : 7, 5);
  }
  return aroundZ(drawing);
}

/// Three sheets, 5 wide and 9 high; the third is 5 high, and above it a scrap, of area 12, touches it in a point.
/// @param scrap  is it there?
Drawn threeSheetsWithScrap(bool scrap)
{
  Drawing drawing;
  const Point up(0, 0, 1);
  for (int k = 0; k < 3; ++k)
  {
    drawing.sheet(Point::Zero(), up, around(k), k == 2 ? 5 : 9, 5);
  }
  if (scrap)
  {
    drawing.sheet(5 * up, up, around(2) + 0.2 * up, 4, 3);
  }
  return aroundZ(drawing);
}
}

TEST(Trimming, KeepsTheBettiNumbersOfRandomComplexes)
{
  int trimmed = 0;
  for (unsigned seed = 500; seed < 1100; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    shapes::Random random(seed);
    std::vector<Point> sites;
    for (int i = 0; i < 6; ++i)
    {
      sites.push_back(shapes::uniformInBox(random, Point::Ones()));
    }
    Drawn d = drawn(complexes::randomComplex(seed), sites, [&](const Triangle&) {
      return Edge{ static_cast<Index>(random() % 6), static_cast<Index>(random() % 6) };
    });
    for (Index& ball : d.geometry.ball)
    {
      ball = random() % 2 == 0 ? None : ball;
    }
    std::vector<FacePolygon> polygons = d.polygons;
    const auto trim = seed < 800 ? medial::trimSheets : medial::trimFlaps;
    const std::vector<char> gone = trim(d.geometry, polygons, {});
    EXPECT_EQ(bettiNumbers(polygons), bettiNumbers(d.polygons));
    for (const FacePolygon& polygon : polygons)
    {
      for (const Index v : polygon.corners)
      {
        EXPECT_FALSE(gone[v]);
      }
    }
    trimmed += polygons.size() != d.polygons.size();
  }
  EXPECT_GT(trimmed, 200);
}

TEST(Trimming, CutsSheetsApartThatAreOneAroundTheEndOfAThird)
{
  const Drawn d = threeSheets(6);
  ASSERT_EQ(partCount(d.polygons), 2);
  std::vector<FacePolygon> polygons = d.polygons;
  medial::trimSheets(d.geometry, polygons);
  EXPECT_EQ(partCount(polygons), 3);
  EXPECT_EQ(bettiNumbers(polygons), bettiNumbers(d.polygons));
  EXPECT_GE(polygons.size() + 4, d.polygons.size());
}

TEST(Trimming, CutsSheetsApartThatOnlyAScrapKeepsApart)
{
  const Index withoutScrap = medial::count(threeSheetsWithScrap(false).polygons);
  for (const double spacing : { 0.0, 2.5 }) // square spacings are 0 and 6.25
  {
    SCOPED_TRACE(testing::Message() << "spacing " << spacing);
    Drawn d = threeSheetsWithScrap(true);
    ASSERT_EQ(partCount(d.polygons), 4);
    d.geometry.spacing = spacing;
    std::vector<FacePolygon> polygons = d.polygons;
    medial::trimSheets(d.geometry, polygons);
    EXPECT_EQ(bettiNumbers(polygons), bettiNumbers(d.polygons));
    // What is left once pruning has taken the scrap? Its faces were drawn last.
    polygons.erase(std::remove_if(polygons.begin(), polygons.end(),
                     [&](const FacePolygon& polygon) { return polygon.siteEdge >= withoutScrap; }),
      polygons.end());
    EXPECT_EQ(partCount(polygons), spacing > 0 ? 3 : 2);
  }
}

TEST(Trimming, LeavesSheetsThatEndTogether)
{
  const Drawn d = threeSheets(7);
  ASSERT_EQ(partCount(d.polygons), 3);
  std::vector<FacePolygon> polygons = d.polygons;
  medial::trimSheets(d.geometry, polygons);
  EXPECT_EQ(polygons.size(), d.polygons.size());
}

TEST(Trimming, LeavesSheetsThatAreOneFarFromTheBorder)
{
  const Drawn d = threeSheets(2); // the border is farther than the sites
  ASSERT_EQ(partCount(d.polygons), 2);
  std::vector<FacePolygon> polygons = d.polygons;
  medial::trimSheets(d.geometry, polygons);
  EXPECT_EQ(polygons.size(), d.polygons.size());
}

TEST(Trimming, LeavesOutPiecesWithoutAPoleOfTheirOwn)
{
  for (const bool isPole : { false, true })
  {
    // A fin on a plate.
    Drawing drawing;
    drawing.sheet(Point(-3, -3, 0), Point(1, 0, 0), Point(0, 1, 0), 6, 6);
    const Index tip = drawing.point(0.5, 0, 1);
    drawing.triangle(drawing.point(0, 0, 0), drawing.point(1, 0, 0), tip);
    const std::vector<Point> sites{ { 0, 0, 2 }, { 0, 0, -2 }, { 0, 2, 0 }, { 0, -2, 0 } };
    Drawn d = drawn(drawing, sites, [tip](const Triangle& t) {
      return t[0] == tip || t[1] == tip || t[2] == tip ? Edge{ 2, 3 } : Edge{ 0, 1 };
    });
    d.geometry.ball[tip] = isPole ? d.geometry.ball[tip] : None;
    std::vector<FacePolygon> polygons = d.polygons;
    const std::vector<char> gone = medial::trimSheets(d.geometry, polygons);
    EXPECT_EQ(polygons.size() + (isPole ? 0 : 1), d.polygons.size());
    EXPECT_EQ(gone[tip] == 0, isPole);
  }
}

TEST(Trimming, LeavesOutFlapsThatLieOnASheet)
{
  for (const bool hasPole : { false, true })
  {
    SCOPED_TRACE(testing::Message() << "with a pole of its own: " << hasPole);
    Drawing drawing;
    drawing.sheet(Point::Zero(), Point(1, 0, 0), Point(0, 1, 0), 4, 4);
    const Index tip = hasPole ? drawing.point(2.9, 2.1, 0.1) : drawing.point(3, 2, 0);
    drawing.triangle(drawing.point(1, 1, 0), drawing.point(2, 2, 0), tip);
    const Drawn d = drawn(drawing, { Point(2, 2, 3), Point(2, 2, -3) }, [](const Triangle&) {
      return Edge{ 0, 1 };
    });
    std::vector<FacePolygon> polygons = d.polygons;
    medial::trimSheets(d.geometry, polygons);
    EXPECT_EQ(polygons.size(), 33u); // equally far from the same sites: one sheet
    medial::trimFlaps(d.geometry, polygons);
    EXPECT_EQ(polygons.size(), hasPole ? 33u : 32u);
  }
}
