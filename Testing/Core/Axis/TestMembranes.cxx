// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Membranes.h"
#include "Axis/VertexMerging.h"
#include "Complexes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using complexes::bettiNumbers;
using complexes::Drawing;
using complexes::partCount;
using medial::Edge;
using medial::FacePolygon;
using medial::Index;
using medial::None;
using medial::Point;

namespace
{
const Point x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

/// A square with a hole in the middle, one cell wide around it.
void addFrame(const Point& corner, int hole, Drawing& drawing)
{
  drawing.sheet(corner, x, y, hole + 2, 1);
  drawing.sheet(corner + y, x, y, 1, hole);
  drawing.sheet(corner + (hole + 1) * x + y, x, y, 1, hole);
  drawing.sheet(corner + (hole + 1) * y, x, y, hole + 2, 1);
}

/// Walls around a square.
void addTube(const Point& corner, int width, int height, Drawing& drawing)
{
  drawing.sheet(corner, x, z, width, height);
  drawing.sheet(corner, y, z, width, height);
  drawing.sheet(corner + width * x, y, z, width, height);
  drawing.sheet(corner + width * y, x, z, width, height);
}

/// Two floors, joined by a wall at one side, a tube from one to the other, and a membrane across the tube.
Drawing floorsWithTunnel(int width)
{
  Drawing drawing;
  addFrame(Point::Zero(), width, drawing);
  addFrame(2 * z, width, drawing);
  drawing.sheet(Point::Zero(), x, z, width + 2, 2);
  addTube(x + y, width, 2, drawing);
  drawing.sheet(x + y + z, x, y, width, width);
  return drawing;
}

struct Closed
{
  explicit Closed(const Drawing& drawing)
    : before(complexes::polygonsOf(drawing.cells))
    , after(before)
    , gone(medial::closeMembranes(
        { drawing.points, std::vector<Index>(drawing.points.size(), None), {}, {} }, after))
  {
  }

  std::vector<FacePolygon> before, after;
  std::vector<char> gone;
};
}

TEST(Membranes, BecomeEdgesOfTheSheetAround)
{
  for (const int width : { 1, 2 })
  {
    SCOPED_TRACE(testing::Message() << width << " cells wide");
    const Closed closed(floorsWithTunnel(width));
    ASSERT_EQ(partCount(closed.before), 2);
    EXPECT_EQ(partCount(closed.after), 1);
    EXPECT_EQ(bettiNumbers(closed.after), bettiNumbers(closed.before));
    const Index vertices = (width + 1) * (width + 1);
    EXPECT_EQ(std::count(closed.gone.begin(), closed.gone.end(), 1), vertices - 2);
    for (const FacePolygon& polygon : closed.after)
    {
      EXPECT_TRUE(std::none_of(
        polygon.corners.begin(), polygon.corners.end(), [&](Index v) { return closed.gone[v]; }));
    }
  }
}

TEST(Membranes, AreSmall)
{
  const Closed closed(floorsWithTunnel(3)); // with four points inside
  ASSERT_EQ(partCount(closed.before), 2);
  EXPECT_EQ(partCount(closed.after), 2);
  EXPECT_EQ(closed.after.size(), closed.before.size());
}

TEST(Membranes, AreNotWhereThreeSheetsMeet)
{
  Drawing drawing; // a tube stands on a floor; a lid closes it below
  addFrame(Point::Zero(), 1, drawing);
  addTube(x + y, 1, 1, drawing);
  drawing.sheet(x + y, x, y, 1, 1);
  const Closed closed(drawing);
  ASSERT_EQ(partCount(closed.before), 3);
  EXPECT_EQ(partCount(closed.after), 3);
}

TEST(Membranes, KeepPolesRatherThanOtherVertices)
{
  const Drawing drawing = floorsWithTunnel(1);
  for (Index pole = 0; pole < medial::count(drawing.points); ++pole)
  {
    std::vector<Index> ball(drawing.points.size(), None);
    ball[pole] = 0;
    std::vector<FacePolygon> polygons = complexes::polygonsOf(drawing.cells);
    EXPECT_FALSE(medial::closeMembranes({ drawing.points, ball, {}, {} }, polygons)[pole]);
  }
}

TEST(VertexMerging, ContractsPatchesOfRandomComplexesWithoutAChangeOfBettiNumbers)
{
  int contracted = 0;
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Drawing drawing = complexes::randomComplex(seed);
    std::vector<FacePolygon> polygons = complexes::polygonsOf(drawing.cells);
    const medial::Betti before = bettiNumbers(polygons);
    std::mt19937 random(seed);
    std::vector<std::vector<Edge>> patches;
    for (const FacePolygon& polygon : polygons)
    {
      const std::vector<Index>& c = polygon.corners;
      if (c.size() == 3 && random() % 2 == 0)
      {
        patches.push_back({ { c[0], c[1] }, { c[1], c[2] }, { c[0], c[2] } });
      }
    }
    std::vector<Index> ball(drawing.points.size(), None);
    const std::vector<char> gone = medial::contractToEdges(patches, ball, polygons);
    EXPECT_EQ(bettiNumbers(polygons), before);
    contracted += static_cast<int>(std::count(gone.begin(), gone.end(), 1));
  }
  EXPECT_GT(contracted, 300);
}
