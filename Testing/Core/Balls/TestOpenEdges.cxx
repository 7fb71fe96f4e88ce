// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/OpenEdges.h"

#include <gtest/gtest.h>

#include <array>

namespace
{
using medial::Edge;
using medial::IndexLists;
using medial::None;

/// The sides of a cube over the points 0 ... 7, where the bits of a number are its coordinates.
const std::array<std::array<medial::Index, 4>, 6> sides = { { { 0, 2, 3, 1 }, { 4, 5, 7, 6 },
  { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } } };

IndexLists cube(std::size_t sideCount = 6)
{
  IndexLists result;
  for (std::size_t i = 0; i < sideCount; ++i)
  {
    result.append(sides[i]);
  }
  return result;
}

std::vector<medial::Index> noDuplicates(std::size_t count)
{
  return std::vector<medial::Index>(count, None);
}

TEST(OpenEdges, AreNotInAClosedSurface)
{
  EXPECT_TRUE(medial::openEdges(cube(), noDuplicates(8)).empty());
  EXPECT_TRUE(medial::openEdges({}, {}).empty());
}

TEST(OpenEdges, AreThoseOfAMissingSide)
{
  const std::vector<Edge> expected = { { 1, 3 }, { 1, 5 }, { 3, 7 }, { 5, 7 } };
  EXPECT_EQ(medial::openEdges(cube(5), noDuplicates(8)), expected);
}

/// As in a .stl file: each side has its own four points.
TEST(OpenEdges, AreNotBetweenPolygonsWithEqualPoints)
{
  IndexLists polygons;
  std::vector<medial::Index> duplicateOf, first(8, None);
  for (const auto& side : sides)
  {
    for (const medial::Index corner : side)
    {
      const medial::Index own = medial::count(duplicateOf);
      duplicateOf.push_back(first[corner]);
      first[corner] = first[corner] == None ? own : first[corner];
      polygons.items.push_back(own);
    }
    polygons.close();
  }
  EXPECT_TRUE(medial::openEdges(polygons, duplicateOf).empty());
  EXPECT_EQ(medial::openEdges(polygons, noDuplicates(24)).size(), 24);
}

TEST(OpenEdges, AreNotWhereThreePolygonsMeet)
{
  IndexLists polygons = cube();
  polygons.append(std::array{ 0, 1, 9 }); // a fin
  EXPECT_EQ(
    medial::openEdges(polygons, noDuplicates(10)), (std::vector<Edge>{ { 0, 9 }, { 1, 9 } }));
}

TEST(OpenEdges, AreWarnedOfWithNumberAndPlace)
{
  const std::vector<medial::Point> points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 },
    { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 } };
  EXPECT_TRUE(medial::openSurfaceWarnings(cube(), noDuplicates(8), points).empty());
  const medial::Warnings warnings = medial::openSurfaceWarnings(cube(5), noDuplicates(8), points);
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0].code, "open_surface");
  EXPECT_NE(warnings[0].text.find("4 edges"), std::string::npos);
  EXPECT_EQ(warnings[0].count, 4);
  EXPECT_EQ(warnings[0].place, points[1]);
  EXPECT_FALSE(warnings[0].doubtsSolid);
}
}
