// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/FaceComplex.h"

#include <gtest/gtest.h>

#include <algorithm>

using medial::FaceComplex;
using medial::FacePolygon;
using medial::Index;
using medial::None;

namespace
{
/// Two triangles with a common side, and a chain of two edges from a corner of the second.
std::vector<FacePolygon> bladeWithHandle()
{
  return { { { 0, 1, 2 }, 10 }, { { 1, 3, 2 }, 11 }, { { 3, 4 }, None }, { { 4, 5 }, None } };
}

Index sideBetween(const FaceComplex& faces, Index a, Index b)
{
  for (Index s = 0; s < faces.sideCount(); ++s)
  {
    if (faces.ends(s) == medial::Edge{ a, b })
    {
      return s;
    }
  }
  return None;
}
}

TEST(FaceComplex, KnowsTheFacesAtEachSide)
{
  const std::vector<FacePolygon> polygons = bladeWithHandle();
  const FaceComplex faces(polygons, 6);
  EXPECT_EQ(faces.sideCount(), 7);
  EXPECT_EQ(faces.facesAt(sideBetween(faces, 1, 2)), (std::vector<Index>{ 0, 1 }));
  EXPECT_EQ(faces.facesAt(sideBetween(faces, 0, 1)), (std::vector<Index>{ 0 }));
  EXPECT_EQ(faces.faceCount(sideBetween(faces, 3, 4)), 0);
  EXPECT_EQ(faces.sidesOf(0).size(), 3);
  EXPECT_EQ(faces.sidesOf(2).size(), 1);
  EXPECT_EQ(faces.danglingSides(), (std::vector<Index>{ 0, 0, 0, 1, 2, 1 }));
}

TEST(FaceComplex, CollapsesAFaceWithItsFreeSideAndTheChainsThatThisLeaves)
{
  const std::vector<FacePolygon> polygons = bladeWithHandle();
  FaceComplex faces(polygons, 6);
  EXPECT_TRUE(faces.collapse(0));
  EXPECT_FALSE(faces.isFace(0));
  EXPECT_FALSE(faces.collapse(0));
  // The side 0, 1 went with the face, then the edge 0, 2 with its free end.
  EXPECT_EQ(faces.goneVertices(), (std::vector<char>{ 1, 0, 0, 0, 0, 0 }));
  EXPECT_EQ(faces.faceCount(sideBetween(faces, 1, 2)), 1);
  const std::vector<FacePolygon> remaining = faces.remaining();
  ASSERT_EQ(remaining.size(), 3u);
  EXPECT_EQ(remaining[0].siteEdge, 11);
}

TEST(FaceComplex, LeavesClosedSurfaces)
{
  const std::vector<FacePolygon> polygons{ { { 0, 1, 2 }, None }, { { 0, 1, 3 }, None },
    { { 0, 2, 3 }, None }, { { 1, 2, 3 }, None } };
  FaceComplex faces(polygons, 4);
  EXPECT_EQ(faces.freeSide(0), None);
  EXPECT_FALSE(faces.collapseAll({ 0, 1, 2, 3 }));
  EXPECT_EQ(faces.remaining().size(), 4u);
}

TEST(FaceComplex, CollapsesADiscToAPoint)
{
  const std::vector<FacePolygon> polygons = bladeWithHandle();
  FaceComplex faces(polygons, 6);
  EXPECT_TRUE(faces.collapseAll({ 0, 1 }));
  const std::vector<char>& gone = faces.goneVertices();
  // Edges of the last face have two ends that others use or went: something always stays.
  EXPECT_LT(std::count(gone.begin(), gone.end(), 1), 6);
  for (const FacePolygon& polygon : faces.remaining())
  {
    EXPECT_EQ(polygon.corners.size(), 2u);
  }
}
