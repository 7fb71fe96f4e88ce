// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Axis/Erosion.h"

#include <algorithm>
#include <cmath>

using complexes::Drawing;
using medial::Erosion;
using medial::Index;
using medial::MedialAxis;
using medial::Point;
using pipelines::forEachShape;
using pipelines::Pipeline;

namespace
{
/// A straight line of edges, drawn from a point.
void line(Drawing& drawing, const Point& from, const Point& step, int edges)
{
  const auto at = [&](int i) {
    const Point place = from + i * step;
    return drawing.point(place.x(), place.y(), place.z());
  };
  for (int i = 0; i < edges; ++i)
  {
    const Index first = at(i);
    drawing.edge(first, at(i + 1));
  }
}

/// Three sheets of width 1, 2 and 5 and height 20 that meet along a line.
Drawing junction()
{
  Drawing drawing;
  const Point up(0, 0, 1);
  drawing.sheet(Point(0, 0, -10), up, Point(1, 0, 0), 20, 1);
  drawing.sheet(Point(0, 0, -10), up, Point(0, 1, 0), 20, 2);
  drawing.sheet(Point(0, 0, -10), up, Point(0, -1, 0), 20, 5);
  return drawing;
}

/// The diagonal of the bounding box of balls of radius 1 at the corners of a box.
double diagonalOf(const Point& size)
{
  return (size + Point(2, 2, 2)).norm();
}
}

TEST(Erosion, OfACapsuleIsHalfItsAxis)
{
  Drawing drawing;
  line(drawing, Point(0, 0, 0), Point(1, 0, 0), 10);
  const Erosion result = medial::erosion(drawing.axis());
  for (Index i = 0; i <= 10; ++i)
  {
    EXPECT_EQ(result.ofPoint[i], std::min(i, 10 - i));
  }
  EXPECT_EQ(result.ofCell[0], 1);
  EXPECT_EQ(result.ofCell[4], 5);
}

TEST(Erosion, StartsWithTheRadiusOfTheBorder)
{
  // A cone: radius 1 at one end, 3 at the other. The large end burns at 3, when the fire from the
  // small one has come to x = 2; they meet at 6.
  Drawing drawing;
  line(drawing, Point(0, 0, 0), Point(1, 0, 0), 10);
  MedialAxis axis = drawing.axis();
  for (Index i = 0; i <= 10; ++i)
  {
    axis.radii[i] = 1 + 0.2 * i;
  }
  const Erosion result = medial::erosion(axis);
  for (Index i = 0; i <= 10; ++i)
  {
    EXPECT_NEAR(result.ofPoint[i], std::min(1 + i, 3 + 10 - i) - axis.radii[i], 1e-12);
  }
}

TEST(Erosion, PassesAForkWhenAllBranchesButOneHaveBurnt)
{
  // Lines of 2, 4 and 10 meet. The fork burns at 4; then the long one burns from both ends, to 7.
  Drawing drawing;
  line(drawing, Point(0, 0, 0), Point(1, 0, 0), 2);
  line(drawing, Point(0, 0, 0), Point(0, 1, 0), 4);
  line(drawing, Point(0, 0, 0), Point(0, -1, 0), 10);
  const Erosion result = medial::erosion(drawing.axis());
  EXPECT_EQ(result.ofPoint[drawing.point(0, 0, 0)], 4);
  EXPECT_EQ(result.ofPoint[drawing.point(0, -3, 0)], 7);
  EXPECT_EQ(result.ofPoint[drawing.point(0, -1, 0)], 5);
  EXPECT_EQ(result.ofCell[0], 2); // at the fork, in the short branch
  EXPECT_EQ(result.ofCell[2], 4);
  EXPECT_EQ(result.ofCell[6], 5);
}

TEST(Erosion, OfASheetIsTheDistanceToItsBorder)
{
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 8, 6);
  const Erosion result = medial::erosion(drawing.axis());
  for (Index i = 0; i <= 8; ++i)
  {
    for (Index j = 0; j <= 6; ++j)
    {
      EXPECT_NEAR(result.ofPoint[drawing.point(i, j, 0)], std::min({ i, 8 - i, j, 6 - j }), 1e-12);
    }
  }
}

TEST(Erosion, RunsStraightThroughTriangles)
{
  // No edge is perpendicular to the long sides of this parallelogram. Along edges alone the fire
  // would come 15 % too late.
  Drawing drawing;
  const double row = std::sqrt(0.75);
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(-0.5, row, 0), 40, 8);
  const Erosion result = medial::erosion(drawing.axis());
  for (Index j = 0; j <= 8; ++j)
  {
    const Point place = Point(0, 0, 0) + 20 * Point(1, 0, 0) + j * Point(-0.5, row, 0);
    EXPECT_NEAR(result.ofPoint[drawing.point(place.x(), place.y(), place.z())],
      row * std::min(j, 8 - j), 1e-9);
  }
}

TEST(Erosion, OfACurvedFrontIsOffByAnEdgeAtMost)
{
  // One point of the border burns first, since its radius is 0; from there the fire runs in circles
  // before anything else can burn.
  for (const int size : { 10, 20, 40 })
  {
    SCOPED_TRACE(testing::Message() << size << " rows");
    Drawing drawing;
    const double step = 10.0 / size, longestEdge = std::sqrt(2) * step;
    drawing.sheet(Point(0, 0, 0), Point(step, 0, 0), Point(0, step, 0), size, size);
    MedialAxis axis = drawing.axis();
    const Index source = drawing.point(0, 5, 0);
    std::vector<char> atBorder(axis.points.size());
    for (Index p = 0; p < medial::count(axis.points); ++p)
    {
      const auto place = axis.points[p].head<2>();
      atBorder[p] = place.minCoeff() == 0 || place.maxCoeff() == 10;
      axis.radii[p] = atBorder[p] && p != source ? 20 : 0;
    }
    const Erosion result = medial::erosion(axis);
    for (Index p = 0; p < medial::count(axis.points); ++p)
    {
      if (!atBorder[p])
      {
        const double distance = (axis.points[p] - axis.points[source]).norm();
        EXPECT_NEAR(result.ofPoint[p], distance, longestEdge);
      }
    }
  }
}

TEST(Erosion, PassesASeamWhenAllSheetsButOneHaveBurnt)
{
  // At the middle height the borders above and below are far: the seam has burnt from the sheets of
  // width 1 and 2 at the times 1 and 2, then the fire enters the third and meets the one from its
  // border at 3.5, between two rows of points that burn at 3.
  const Drawing drawn = junction();
  Drawing drawing = drawn;
  const MedialAxis axis = drawing.axis();
  const Erosion result = medial::erosion(axis);
  EXPECT_NEAR(result.ofPoint[drawing.point(0, 0, 0)], 2, 1e-12);
  EXPECT_NEAR(result.ofPoint[drawing.point(0, 1, 0)], 1, 1e-12);
  EXPECT_NEAR(result.ofPoint[drawing.point(0, -1, 0)], 3, 1e-12);
  EXPECT_NEAR(result.ofPoint[drawing.point(0, -2, 0)], 3, 1e-12);
  EXPECT_NEAR(result.ofPoint[drawing.point(0, -4, 0)], 1, 1e-12);
  const medial::MedialParts parts = medial::decompose(axis);
  ASSERT_EQ(parts.parts.size(), 3u);
  std::vector<double> largest(3, 0);
  for (Index cell = 0; cell < axis.cells.size(); ++cell)
  {
    double& value = largest[parts.partOfCell[cell]];
    value = std::max(value, result.ofCell[cell]);
  }
  EXPECT_NEAR(largest[0], 1, 1e-12);
  EXPECT_NEAR(largest[1], 2, 1e-12);
  EXPECT_NEAR(largest[2], 3, 1e-12);
}

TEST(Erosion, DoesNotPassFromALineIntoASheet)
{
  // Hair on the middle of a sheet: its fire ends there. The sheet burns as without it.
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 8, 8);
  line(drawing, Point(4, 4, 0), Point(0, 0, 1), 2);
  const Erosion result = medial::erosion(drawing.axis());
  EXPECT_NEAR(result.ofPoint[drawing.point(4, 4, 0)], 4, 1e-12);
  EXPECT_NEAR(result.ofPoint[drawing.point(3, 4, 0)], 3, 1e-12);
  EXPECT_EQ(result.ofPoint[drawing.point(4, 4, 1)], 1);
  EXPECT_EQ(result.ofCell[0], 2);
}

TEST(Erosion, PassesFromASheetIntoALine)
{
  // A bridge between two sheets of width 2 and 4, at their middle: it burns last, from both ends.
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 2, 2);
  drawing.sheet(Point(-1, -1, 10), Point(1, 0, 0), Point(0, 1, 0), 4, 4);
  line(drawing, Point(1, 1, 0), Point(0, 0, 1), 10);
  const Erosion result = medial::erosion(drawing.axis());
  EXPECT_NEAR(result.ofPoint[drawing.point(1, 1, 0)], 1, 1e-12);
  EXPECT_NEAR(result.ofPoint[drawing.point(1, 1, 10)], 2, 1e-12);
  EXPECT_NEAR(result.ofPoint[drawing.point(1, 1, 5)], 6, 1e-12);
}

TEST(Erosion, OfAClosedSheetIsTheDiagonal)
{
  Drawing drawing = complexes::closedSheet(1);
  for (const double value : medial::erosion(drawing.axis()).ofPoint)
  {
    EXPECT_EQ(value, diagonalOf(Point(1, 1, 1)));
  }
  // With a fin, which burns and changes nothing.
  drawing.sheet(Point(0, 0, 0), Point(0, 0, 1), Point(-1, -1, 0), 1, 1);
  const MedialAxis axis = drawing.axis();
  const Erosion result = medial::erosion(axis);
  EXPECT_EQ(result.ofPoint[drawing.point(1, 1, 1)], diagonalOf(Point(2, 2, 1)));
  EXPECT_EQ(result.ofCell[axis.cells.size() - 1], 0); // all its corners are on its border
}

TEST(Erosion, OfALoopOfLinesIsTheDiagonal)
{
  Drawing drawing;
  line(drawing, Point(0, 0, 0), Point(1, 0, 0), 1);
  line(drawing, Point(1, 0, 0), Point(-1, 1, 0), 1);
  line(drawing, Point(0, 1, 0), Point(0, -1, 0), 1);
  for (const double value : medial::erosion(drawing.axis()).ofPoint)
  {
    EXPECT_EQ(value, diagonalOf(Point(1, 1, 0)));
  }
}

TEST(Erosion, OfAPointIsNothing)
{
  Drawing drawing;
  drawing.vertex(drawing.point(1, 2, 3));
  const Erosion result = medial::erosion(drawing.axis());
  EXPECT_EQ(result.ofPoint, std::vector<double>{ 0 });
  EXPECT_EQ(result.ofCell, std::vector<double>{ 0 });
}

TEST(Erosion, OfABoxIsThatOfItsMiddle)
{
  // 6 x 4 x 2. Fire from the box's edges, where the radius is 0, runs down two sheets at 45 degrees to
  // the middle one, and there from its border to its centre.
  Drawing drawing = complexes::boxAxis();
  MedialAxis axis = drawing.axis();
  for (Index p = 0; p < medial::count(axis.points); ++p)
  {
    axis.radii[p] = (Point(3, 2, 1) - axis.points[p].cwiseAbs()).minCoeff();
  }
  const Erosion result = medial::erosion(axis);
  EXPECT_NEAR(result.ofPoint[drawing.point(0, -2, 1)], 0, 1e-12);
  EXPECT_NEAR(result.ofPoint[drawing.point(0, -1, 0)], std::sqrt(2) - 1, 1e-12);
  EXPECT_NEAR(result.ofPoint[drawing.point(0, 0, 0)], std::sqrt(2), 1e-12);
}

TEST(Erosion, OfASampledBoxIsThatOfItsMiddleButForTheLastSpacings)
{
  // 3 x 2 x 1. The sheets end up to two spacings before the edges: the fire starts there, with the
  // radius instead of the way. The fronts meet between points, which are a spacing apart.
  Pipeline& p = pipelines::of("box");
  const double exact = std::sqrt(0.5);
  const double largest = *std::max_element(p.axis().erosion.begin(), p.axis().erosion.end());
  EXPECT_GT(largest, exact - ((std::sqrt(2) - 1) * 2 + 0.5) * p.shape.spacing);
  EXPECT_LT(largest, exact + p.shape.spacing);
}

TEST(Erosion, IsThatOfTheAxisAndScalesWithItToTheLastBit)
{
  forEachShape([](Pipeline& p) {
    const Erosion result = medial::erosion(p.axis());
    EXPECT_EQ(result.ofPoint, p.axis().erosion);
    EXPECT_EQ(result.ofCell, p.axis().cellErosion);
    const double factor = std::ldexp(1, 20);
    const Erosion scaled = medial::erosion(pipelines::inUnits(p.axis(), factor));
    EXPECT_EQ(scaled.ofPoint, pipelines::times(result.ofPoint, factor));
    EXPECT_EQ(scaled.ofCell, pipelines::times(result.ofCell, factor));
  });
}

TEST(Erosion, OfThePlateIsLargestFarFromItsRim)
{
  // Between a hole and the outside, or between the holes, no point is farther from the border.
  Pipeline& p = pipelines::of("two-hole plate");
  const double largest = *std::max_element(p.axis().erosion.begin(), p.axis().erosion.end());
  EXPECT_LT(largest, 1);
  EXPECT_GT(largest, 0.1);
}
