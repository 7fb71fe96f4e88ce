// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/PieceRepair.h"
#include "Pipelines.h"

#include "Axis/AxisBetti.h"

#include <algorithm>
#include <set>

using complexes::Drawing;
using medial::AxisComplex;
using medial::Betti;
using medial::Index;
using medial::MedialAxis;
using medial::None;
using medial::Point;
using pipelines::Pipeline;

namespace
{
/// A square at x = 0 and one at x = 10, each of 4 x 4 points; the second may have a tunnel.
Drawing twoSquares(bool hasTunnel)
{
  Drawing drawing;
  for (const double x : { 0.0, 10.0 })
  {
    drawing.sheet(Point(x, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 3, 3);
  }
  if (hasTunnel)
  {
    // The two triangles in the middle of the second square.
    const Index a = drawing.point(11, 1, 0), b = drawing.point(12, 2, 0);
    std::vector<medial::Triangle>& triangles = drawing.cells.triangles;
    triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                      [&](const medial::Triangle& t) {
                        return std::count(t.begin(), t.end(), a) &&
                          std::count(t.begin(), t.end(), b);
                      }),
      triangles.end());
  }
  return drawing;
}

/// The lowest point of the square that each point is in.
std::vector<Index> squares(const AxisComplex& axis)
{
  std::vector<Index> result;
  for (const Point& point : axis.points)
  {
    result.push_back(point.x() < 5 ? 0 : 16);
  }
  return result;
}

Index trianglesBelow(const AxisComplex& axis, double x)
{
  return static_cast<Index>(std::count_if(axis.cells.triangles.begin(), axis.cells.triangles.end(),
    [&](const medial::Triangle& t) { return axis.points[t[0]].x() < x; }));
}
}

TEST(PieceRepair, TakesPiecesWithTheRightTopologyFromTheAxis)
{
  const MedialAxis wrong = twoSquares(true).axis(), exact = twoSquares(false).axis();
  MedialAxis marked = wrong;
  for (medial::Edge& samples : marked.samplesOfCell)
  {
    samples = { 7, 8 };
  }
  const AxisComplex repaired = medial::repairedPieces(marked, exact, squares(exact));
  EXPECT_EQ(medial::bettiNumbers(repaired.cells), (Betti{ 2, 0, 0 }));
  ASSERT_EQ(repaired.cells.triangles.size(), 36u);
  EXPECT_EQ(trianglesBelow(repaired, 5), 18);
  for (std::size_t t = 0; t < repaired.cells.triangles.size(); ++t)
  {
    const bool isFirst = repaired.points[repaired.cells.triangles[t][0]].x() < 5;
    EXPECT_EQ(repaired.samplesOfCell[t][0], isFirst ? 7 : None);
  }
  std::set<Index> polygons(repaired.polygonOfCell.begin(), repaired.polygonOfCell.end());
  EXPECT_EQ(polygons.size(), 36u);
}

TEST(PieceRepair, TakesPiecesThatWereJoinedFromTheExactAxis)
{
  Drawing joined = twoSquares(false);
  joined.edge(joined.point(3, 3, 0), joined.point(10, 3, 0));
  const MedialAxis exact = twoSquares(false).axis();
  const AxisComplex repaired = medial::repairedPieces(joined.axis(), exact, squares(exact));
  EXPECT_EQ(medial::bettiNumbers(repaired.cells), (Betti{ 2, 0, 0 }));
  EXPECT_TRUE(repaired.cells.edges.empty());
}

TEST(PieceRepair, FindsAPieceThatIsMissing)
{
  Drawing one;
  one.sheet(Point::Zero(), Point(1, 0, 0), Point(0, 1, 0), 3, 3);
  const MedialAxis exact = twoSquares(false).axis();
  const AxisComplex repaired = medial::repairedPieces(one.axis(), exact, squares(exact));
  EXPECT_EQ(medial::bettiNumbers(repaired.cells), (Betti{ 2, 0, 0 }));
  EXPECT_EQ(repaired.points.size(), 32u);
}

TEST(PieceRepair, KeepsVerticesEdgesAndTrianglesInTheirOrder)
{
  Drawing drawing = twoSquares(false);
  drawing.edge(drawing.point(3, 3, 0), drawing.point(4, 4, 0));
  drawing.edge(drawing.point(13, 3, 0), drawing.point(14, 4, 0));
  drawing.vertex(drawing.point(20, 0, 0));
  const MedialAxis axis = drawing.axis();
  std::vector<Index> pieces = squares(axis);
  pieces.back() = medial::count(pieces) - 1;
  const AxisComplex repaired = medial::repairedPieces(axis, axis, pieces);
  EXPECT_EQ(repaired.cells.vertices.size(), 1u);
  EXPECT_EQ(repaired.cells.edges.size(), 2u);
  EXPECT_EQ(repaired.cells.triangles.size(), 36u);
  EXPECT_EQ(medial::count(repaired.polygonOfCell), repaired.cells.size());
  EXPECT_EQ(medial::count(repaired.siteViews), repaired.cells.size());
  EXPECT_EQ(medial::bettiNumbers(repaired.cells), axis.betti);
  for (std::size_t i = 0; i < repaired.points.size(); ++i)
  {
    EXPECT_EQ(repaired.points[i], axis.points[repaired.ballOfPoint[i]]);
  }
}

TEST(PieceRepair, PiecesOfBallsAreThoseOfTheSolid)
{
  pipelines::forEachShape([](Pipeline& p) {
    const std::vector<Index> pieces = medial::piecesOfBalls(p.balls());
    std::set<Index> lowest;
    for (std::size_t ball = 0; ball < pieces.size(); ++ball)
    {
      ASSERT_EQ(pieces[ball] == None, p.balls().sides[ball] != medial::Side::Inner);
      ASSERT_LE(pieces[ball], static_cast<Index>(ball));
      lowest.insert(pieces[ball]);
    }
    lowest.erase(None);
    EXPECT_EQ(medial::count(lowest), p.shape.betti[0]);
  });
}

TEST(PieceRepair, OneBadPieceLeavesTheOthersAsTheyAre)
{
  // Random points spoil the axis: no filling of gaps makes their void. An ellipsoid beside them is sampled well.
  std::vector<Point> samples = shapes::cloud(250, 27);
  const medial::MedialAxis bad = medial::medialAxis(medial::polarBalls(samples));
  ASSERT_TRUE(bad.fallback);
  const std::vector<Point> good = shapes::ellipsoid().samples;
  const medial::MedialAxis alone = medial::medialAxis(medial::polarBalls(good));
  const std::vector<Point> beside = shapes::moved(good, Point(20, 0, 0));
  samples.insert(samples.end(), beside.begin(), beside.end());
  const MedialAxis axis = medial::medialAxis(medial::polarBalls(samples));
  EXPECT_TRUE(axis.certificate);
  EXPECT_TRUE(axis.fallback);
  Index ofEllipsoid = 0, ofCloud = 0;
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    // Only the axis from the singular points has points without a ball.
    if (axis.ballOfPoint[i] == None)
    {
      ++(axis.points[i].x() > 10 ? ofEllipsoid : ofCloud);
    }
  }
  const auto withoutBall = std::count(alone.ballOfPoint.begin(), alone.ballOfPoint.end(), None);
  EXPECT_EQ(ofCloud, 0);
  EXPECT_NEAR(ofEllipsoid, withoutBall, 0.05 * withoutBall);
}
