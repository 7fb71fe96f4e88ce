// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Fins.h"
#include "ShapeComplexes.h"

#include <gtest/gtest.h>

using medial::Index;
using medial::None;
using medial::Point;
using medial::ShapeComplex;
using medial::TriangleCollapse;

namespace
{
/// Cells with a triangle of marked points each; the other point of each is unmarked.
struct Triangles
{
  std::vector<Point> centers;
  ShapeComplex shape;

  static ShapeComplex make(const std::vector<medial::Triangle>& triangles, Index pointCount)
  {
    std::vector<medial::Tetrahedron> cells;
    std::vector<char> marked(pointCount, 1);
    for (const medial::Triangle& t : triangles)
    {
      cells.push_back({ t[0], t[1], t[2], medial::count(marked) });
      marked.push_back(0);
    }
    return { medial::withNeighbors(cells), marked };
  }

  Triangles(std::vector<Point> points, const std::vector<medial::Triangle>& triangles)
    : centers(std::move(points))
    , shape(make(triangles, medial::count(this->centers)))
  {
  }

  Index edge(Index a, Index b) const
  {
    for (Index e = 0; e < medial::count(this->shape.edges); ++e)
    {
      if (this->shape.edges[e] == medial::Edge{ a, b })
      {
        return e;
      }
    }
    return None;
  }
};

/// Two triangles at the edge 0 1 lie flat; others stand on it.
Triangles sheetWith(const std::vector<medial::Triangle>& standing)
{
  std::vector<medial::Triangle> triangles = { { 0, 1, 2 }, { 0, 1, 3 } };
  triangles.insert(triangles.end(), standing.begin(), standing.end());
  return { { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, -1, 0), Point(0, 0, 1),
             Point(1, 0, 1), Point(0, 0, 2), Point(1, 0, 2), Point(2, 0, 1) },
    triangles };
}
}

TEST(Fins, OneTriangleGoesThroughItsLongestFreeEdge)
{
  const Triangles t = sheetWith({ { 0, 1, 4 } });
  const std::vector<TriangleCollapse> steps =
    medial::finCollapses(t.shape, t.centers, 2, t.edge(0, 1));
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].triangle, 2);
  EXPECT_EQ(steps[0].edge, t.edge(1, 4));
}

TEST(Fins, TwoTrianglesGoOneAfterTheOther)
{
  // 0 1 4 has no free edge but lies next to 1 4 5, which has.
  Triangles t = sheetWith({ { 0, 1, 4 }, { 1, 4, 5 }, { 0, 4, 6 }, { 0, 2, 4 } });
  const std::vector<TriangleCollapse> steps =
    medial::finCollapses(t.shape, t.centers, 2, t.edge(0, 1));
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].triangle, 3);
  EXPECT_EQ(steps[1].triangle, 2);
  EXPECT_EQ(steps[1].edge, t.edge(1, 4));
  for (const TriangleCollapse& step : steps)
  {
    EXPECT_TRUE(t.shape.collapseTriangle(step.triangle, step.edge));
  }
  EXPECT_EQ(t.shape.triangleCount(t.edge(0, 1)), 2);
}

TEST(Fins, WhatReachesFartherIsASheet)
{
  // A wall of three rows at least, without a free edge within two triangles.
  const Triangles t = sheetWith({ { 0, 1, 4 }, { 1, 4, 5 }, { 4, 5, 6 }, { 5, 6, 7 }, { 1, 5, 8 },
    { 5, 7, 8 }, { 0, 4, 6 }, { 0, 2, 4 } });
  EXPECT_TRUE(medial::finCollapses(t.shape, t.centers, 2, t.edge(0, 1)).empty());
}

TEST(Fins, WhatIsASideOfATetrahedronStays)
{
  const medial::Tetrahedra mesh = medial::withNeighbors({ { 0, 1, 2, 3 } });
  const ShapeComplex shape(mesh, { 1, 1, 1, 1 });
  const std::vector<Point> centers = { Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0),
    Point(0, 0, 1) };
  EXPECT_TRUE(medial::finCollapses(shape, centers, 0, shape.sides[0][0]).empty());
}
