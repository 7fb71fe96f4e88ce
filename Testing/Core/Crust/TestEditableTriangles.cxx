// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/EditableTriangles.h"

#include "Validators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

using medial::EditableTriangles;
using medial::Index;
using medial::None;
using medial::Triangle;
using Triangles = std::vector<Triangle>;

namespace
{
/// The triangles that are there, as the validators take faces.
medial::IndexLists facesOf(const Triangles& triangles)
{
  medial::IndexLists faces;
  for (const Triangle& t : triangles)
  {
    if (t[0] != None)
    {
      faces.append(t);
    }
  }
  return faces;
}

void expectManifold(const Triangles& triangles, Index euler)
{
  const medial::IndexLists faces = facesOf(triangles);
  EXPECT_TRUE(validators::isTwoManifold(faces));
  EXPECT_TRUE(validators::isOriented(faces));
  EXPECT_EQ(validators::eulerCharacteristic(faces), euler);
}

/// Rings of `around` points, each joined to the next one. Closed to a torus, or by a point at each end.
Triangles tube(Index rings, Index around, bool torus)
{
  Triangles triangles;
  const auto at = [&](Index ring, Index k) { return ring % rings * around + k % around; };
  for (Index ring = 0; ring + (torus ? 0 : 1) < rings; ++ring)
  {
    for (Index k = 0; k < around; ++k)
    {
      triangles.push_back({ at(ring, k), at(ring, k + 1), at(ring + 1, k) });
      triangles.push_back({ at(ring, k + 1), at(ring + 1, k + 1), at(ring + 1, k) });
    }
  }
  for (Index k = 0; k < around && !torus; ++k)
  {
    triangles.push_back({ at(0, k + 1), at(0, k), rings * around });
    triangles.push_back({ at(rings - 1, k), at(rings - 1, k + 1), rings * around + 1 });
  }
  return triangles;
}

Index pointsOf(Index rings, Index around, bool torus)
{
  return rings * around + (torus ? 0 : 2);
}
}

TEST(EditableTriangles, AreWhereTheyWere)
{
  Triangles triangles = tube(3, 4, false);
  EditableTriangles edits(triangles, pointsOf(3, 4, false));
  expectManifold(triangles, 2);
  EXPECT_EQ(edits.neighbors(12), (std::vector<Index>{ 0, 1, 2, 3 }));
  EXPECT_TRUE(edits.hasEdge(0, 12));
  EXPECT_FALSE(edits.hasEdge(0, 13));
  for (Index t = 0; t < medial::count(triangles); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const Index other = edits.across(t, corner);
      ASSERT_NE(other, None);
      const Triangle& back = triangles[other];
      const auto own = std::find_if(back.begin(), back.end(), [&](Index point) {
        return std::find(triangles[t].begin(), triangles[t].end(), point) == triangles[t].end();
      });
      EXPECT_EQ(edits.across(other, static_cast<int>(own - back.begin())), t);
    }
  }
}

TEST(EditableTriangles, ContractAnEdge)
{
  Triangles triangles = tube(3, 4, false);
  const std::size_t before = triangles.size();
  EditableTriangles edits(triangles, pointsOf(3, 4, false));
  EXPECT_EQ(edits.fewerFirst({ 12, 0 }), (medial::Edge{ 12, 0 }));
  EXPECT_EQ(edits.fewerFirst({ 0, 12 }), (medial::Edge{ 12, 0 }));
  ASSERT_TRUE(edits.contract(12, 0));
  expectManifold(triangles, 2);
  EXPECT_EQ(facesOf(triangles).size(), static_cast<Index>(before) - 2);
  EXPECT_TRUE(edits.neighbors(12).empty());
  EXPECT_TRUE(edits.hasEdge(0, 2));
}

TEST(EditableTriangles, DoNotPinchAHandle)
{
  // Three edges around a tube. Contracting one would glue the two others to each other.
  Triangles triangles = tube(4, 3, true);
  EditableTriangles edits(triangles, pointsOf(4, 3, true));
  const Triangles before = triangles;
  EXPECT_FALSE(edits.contract(0, 1));
  EXPECT_EQ(triangles, before);
  EXPECT_TRUE(edits.contract(3, 0)); // along the tube
  expectManifold(triangles, 0);
}

TEST(EditableTriangles, LeaveATetrahedron)
{
  Triangles triangles{ { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  EditableTriangles edits(triangles, 4);
  for (Index a = 0; a < 4; ++a)
  {
    for (Index b = 0; b < 4; ++b)
    {
      EXPECT_TRUE(a == b || !edits.contract(a, b));
    }
  }
  for (Index t = 0; t < 4; ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      EXPECT_FALSE(edits.flip(t, corner)); // every diagonal is an edge
    }
  }
  expectManifold(triangles, 2);
}

TEST(EditableTriangles, FlipAnEdge)
{
  Triangles triangles{ { 0, 1, 2 }, { 0, 2, 3 }, { 1, 0, 4 }, { 2, 1, 4 }, { 3, 2, 4 },
    { 0, 3, 4 } };
  expectManifold(triangles, 2);
  EditableTriangles edits(triangles, 5);
  ASSERT_TRUE(edits.flip(0, 1));
  EXPECT_EQ(triangles[0], (Triangle{ 0, 1, 3 }));
  EXPECT_EQ(triangles[1], (Triangle{ 1, 2, 3 }));
  EXPECT_FALSE(edits.hasEdge(0, 2));
  EXPECT_TRUE(edits.hasEdge(1, 3));
  expectManifold(triangles, 2);
}

TEST(EditableTriangles, KeepTheTopologyWhateverIsTried)
{
  for (const bool torus : { false, true })
  {
    for (unsigned seed = 0; seed < 20; ++seed)
    {
      SCOPED_TRACE(testing::Message() << (torus ? "torus, seed " : "sphere, seed ") << seed);
      Triangles triangles = tube(6, 5, torus);
      const Index points = pointsOf(6, 5, torus);
      EditableTriangles edits(triangles, points);
      std::mt19937 random(seed);
      int contracted = 0;
      for (int k = 0; k < 400; ++k)
      {
        const auto t = static_cast<Index>(random() % triangles.size());
        const int corner = static_cast<int>(random() % 3);
        if (!edits.isThere(t))
        {
          continue;
        }
        if (k % 2 == 0)
        {
          edits.flip(t, corner);
        }
        else
        {
          contracted += edits.contract(triangles[t][corner], triangles[t][(corner + 1) % 3]);
        }
      }
      expectManifold(triangles, torus ? 0 : 2);
      EXPECT_GT(contracted, 15);
    }
  }
}
