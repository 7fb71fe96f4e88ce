// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeComplexes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using medial::Index;
using medial::None;
using medial::ShapeComplex;
using shapecomplexes::MarkedMesh;
using shapecomplexes::randomMesh;

namespace
{
template <typename Corners>
Corners sorted(Corners corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// All simplices with marked corners, from the cells one by one.
struct Simplices
{
  std::set<medial::Tetrahedron> tetrahedra;
  std::set<medial::Triangle> triangles;
  std::set<medial::Edge> edges;

  explicit Simplices(const MarkedMesh& m)
  {
    const auto add = [&m](auto& set, auto corners) {
      if (std::all_of(corners.begin(), corners.end(), [&m](Index p) { return m.marked[p] != 0; }))
      {
        set.insert(sorted(corners));
      }
    };
    for (const medial::Tetrahedron& cell : m.mesh.cells)
    {
      add(this->tetrahedra, cell);
      for (int i = 0; i < 4; ++i)
      {
        add(this->triangles, medial::facet(cell, i));
        for (int j = 0; j < i; ++j)
        {
          add(this->edges, medial::Edge{ cell[i], cell[j] });
        }
      }
    }
  }
};
}

TEST(ShapeComplex, HasAllSimplicesOfMarkedPointsOnce)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MarkedMesh m = randomMesh(seed);
    const ShapeComplex shape = m.complex();
    const Simplices expected(m);
    const std::set<medial::Tetrahedron> tetrahedra(
      shape.tetrahedra.begin(), shape.tetrahedra.end());
    const std::set<medial::Triangle> triangles(shape.triangles.begin(), shape.triangles.end());
    const std::set<medial::Edge> edges(shape.edges.begin(), shape.edges.end());
    EXPECT_EQ(tetrahedra, expected.tetrahedra);
    EXPECT_EQ(triangles, expected.triangles);
    EXPECT_EQ(edges, expected.edges);
    EXPECT_EQ(tetrahedra.size(), shape.tetrahedra.size());
    EXPECT_EQ(triangles.size(), shape.triangles.size());
    EXPECT_EQ(edges.size(), shape.edges.size());
  }
}

TEST(ShapeComplex, FacesLieOppositeToTheirCorners)
{
  const ShapeComplex shape = randomMesh(8).complex();
  ASSERT_FALSE(shape.tetrahedra.empty());
  for (std::size_t c = 0; c < shape.tetrahedra.size(); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      const medial::Triangle& facet = shape.triangles[shape.facets[c][i]];
      EXPECT_EQ(std::count(facet.begin(), facet.end(), shape.tetrahedra[c][i]), 0);
      EXPECT_GE(shape.tetrahedronCount(shape.facets[c][i]), 1);
    }
  }
  for (std::size_t t = 0; t < shape.triangles.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const medial::Edge& side = shape.edges[shape.sides[t][i]];
      EXPECT_EQ(std::count(side.begin(), side.end(), shape.triangles[t][i]), 0);
      const std::vector<Index> at = shape.trianglesAt(shape.sides[t][i]);
      EXPECT_EQ(std::count(at.begin(), at.end(), static_cast<Index>(t)), 1);
      EXPECT_EQ(medial::count(at), shape.triangleCount(shape.sides[t][i]));
    }
  }
}

TEST(ShapeComplex, CollapsesWhatIsFreeAndNothingElse)
{
  // Two tetrahedra with a common triangle.
  medial::Tetrahedra mesh = medial::withNeighbors({ { 0, 1, 2, 3 }, { 4, 1, 3, 2 } });
  ShapeComplex shape(mesh, { 1, 1, 1, 1, 1 });
  const Index inner = shape.facets[0][0], outer = shape.facets[0][3]; // 1 2 3 and 0 1 2
  EXPECT_EQ(shape.tetrahedronCount(inner), 2);
  EXPECT_EQ(shape.onlyTetrahedron(inner), None);
  EXPECT_EQ(shape.onlyTetrahedron(outer), 0);
  const Index side = shape.sides[outer][2]; // 0 1
  EXPECT_FALSE(shape.collapseTetrahedron(0, inner));
  EXPECT_FALSE(shape.collapseTetrahedron(1, outer));
  EXPECT_FALSE(shape.collapseTriangle(outer, side));
  EXPECT_TRUE(shape.collapseTetrahedron(0, outer));
  EXPECT_FALSE(shape.collapseTetrahedron(0, outer));
  EXPECT_FALSE(shape.hasTetrahedron(0));
  EXPECT_FALSE(shape.hasTriangle(outer));
  const Index second = shape.facets[0][2]; // 0 1 3, with 0 1 free now
  EXPECT_EQ(shape.triangleCount(side), 1);
  EXPECT_FALSE(shape.collapseTriangle(shape.facets[0][1], side)); // not its edge
  EXPECT_TRUE(shape.collapseTriangle(second, side));
  EXPECT_FALSE(shape.hasEdge(side));
  EXPECT_FALSE(shape.hasTriangle(second));
  EXPECT_FALSE(shape.collapseTriangle(second, side));
  EXPECT_TRUE(shape.collapseTetrahedron(1, inner));
}

TEST(ShapeComplex, AnyCollapsesKeepTheBettiNumbers)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MarkedMesh m = randomMesh(seed);
    ShapeComplex shape = m.complex();
    const medial::Betti before = shapecomplexes::bettiOf(shape, m.marked);
    std::minstd_rand random(seed + 1);
    int done = 0;
    for (int turn = 0; turn < 2000 && !shape.triangles.empty(); ++turn)
    {
      const Index t = static_cast<Index>(random() % shape.triangles.size());
      const Index c = shape.onlyTetrahedron(t);
      done += c != None ? shape.collapseTetrahedron(c, t)
                        : shape.collapseTriangle(t, shape.sides[t][random() % 3]);
    }
    EXPECT_EQ(shapecomplexes::bettiOf(shape, m.marked), before);
    EXPECT_TRUE(done > 0 || shape.triangles.empty());
  }
}
