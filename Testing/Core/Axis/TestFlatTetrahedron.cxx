// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/FlatTetrahedron.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using medial::FacetSet;
using medial::FlatTetrahedron;
using medial::Point;

namespace
{
/// A side and the other one are the same view.
FacetSet lowerSide(const FlatTetrahedron& view)
{
  return std::min(view.side, medial::others(view.side));
}

std::array<Point, 4> cornersOf(const std::vector<Point>& points)
{
  return { points[0], points[1], points[2], points[3] };
}
}

TEST(FlatTetrahedron, OfTwoCrossingEdgesShowsTwoTrianglesOnEachSide)
{
  // 0 and 1 are the ends of the upper diagonal of a square: the triangles opposite to 2 and 3.
  const FlatTetrahedron view =
    medial::flatTetrahedron({ Point(0, 0, 0.1), Point(1, 1, 0.1), Point(1, 0, 0), Point(0, 1, 0) });
  EXPECT_EQ(lowerSide(view), 3);
}

TEST(FlatTetrahedron, OfAPointAboveATriangleShowsThreeTrianglesAbove)
{
  const FlatTetrahedron view = medial::flatTetrahedron(
    { Point(0, 0, 0), Point(1, 0, 0), Point(0.3, 0.3, 0.1), Point(0, 1, 0) });
  EXPECT_EQ(lowerSide(view), 4);
}

TEST(FlatTetrahedron, TellsHowFlatItIs)
{
  const auto flatness = [](double height) {
    return medial::flatTetrahedron(
      { Point(0, 0, height), Point(1, 1, height), Point(1, 0, 0), Point(0, 1, 0) })
      .flatness;
  };
  EXPECT_EQ(flatness(0), 0);
  EXPECT_LT(flatness(0.01), flatness(0.02));
  EXPECT_LT(flatness(0.1), flatness(0.5));
}

TEST(FlatTetrahedron, LooksTheSameFromAllSidesAndInAllUnits)
{
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::vector<Point> points = shapes::cloud(4, seed);
    const FlatTetrahedron view = medial::flatTetrahedron(cornersOf(points));
    const FlatTetrahedron turned =
      medial::flatTetrahedron(cornersOf(shapes::rotated(shapes::scaled(points, 1024), seed)));
    EXPECT_EQ(lowerSide(turned), lowerSide(view));
    EXPECT_NEAR(turned.flatness, view.flatness, 1e-9);
    for (Point& point : points)
    {
      point.x() = -point.x();
    }
    const FlatTetrahedron mirrored = medial::flatTetrahedron(cornersOf(points));
    EXPECT_EQ(mirrored.side, view.side);
    EXPECT_EQ(mirrored.flatness, view.flatness);
  }
}

TEST(FlatTetrahedron, OfOnePointHasASide)
{
  const Point same(1, 2, 3);
  const FlatTetrahedron view = medial::flatTetrahedron({ same, same, same, same });
  EXPECT_EQ(view.side, 1);
  EXPECT_EQ(view.flatness, 0);
}
