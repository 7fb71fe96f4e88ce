// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/GuidedCollapse.h"
#include "Executions.h"
#include "ShapeComplexes.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>

using medial::Index;
using medial::Point;
using medial::ShapeComplex;
using shapecomplexes::MarkedMesh;
using shapecomplexes::randomMesh;

namespace
{
double area(const validators::Complex& complex, const std::vector<Point>& points)
{
  double sum = 0;
  for (const medial::Triangle& t : complex.triangles)
  {
    const Point& a = points[t[0]];
    sum += 0.5 * (points[t[1]] - a).cross(points[t[2]] - a).norm();
  }
  return sum;
}

/// The poles of a sheet: points of a square, near a plane.
std::vector<Point> thinSlab(unsigned seed, double thickness)
{
  std::vector<Point> points = shapes::cloud(400, seed);
  for (Point& point : points)
  {
    point.z() *= thickness;
  }
  return points;
}

validators::Complex collapsed(const MarkedMesh& m, const medial::Execution& execution = {})
{
  ShapeComplex shape = m.complex();
  medial::collapseToSheets(shape, m.points, execution);
  return shapecomplexes::remaining(shape, m.marked);
}
}

TEST(GuidedCollapse, KeepsTheBettiNumbersAndLeavesNoTetrahedron)
{
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MarkedMesh m = randomMesh(seed);
    const validators::Complex left = collapsed(m);
    EXPECT_TRUE(left.tetrahedra.empty());
    EXPECT_EQ(validators::bettiNumbers(left), shapecomplexes::bettiOf(m.complex(), m.marked));
  }
}

TEST(GuidedCollapse, LosesNoPoint)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MarkedMesh m = randomMesh(seed);
    validators::Complex before = shapecomplexes::remaining(m.complex(), m.marked);
    validators::Complex after = collapsed(m);
    before.vertices.clear();
    after.vertices.clear();
    const Index pointCount = medial::count(m.points);
    EXPECT_EQ(
      validators::unusedPoints(pointCount, after), validators::unusedPoints(pointCount, before));
  }
}

TEST(GuidedCollapse, MakesOneSheetOfAThinSlab)
{
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MarkedMesh m = shapecomplexes::markedMesh(thinSlab(seed, 0.005), seed, 1000);
    EXPECT_NEAR(
      area(collapsed(m), m.points), 0.97, 0.05); // the square without a little at its border
  }
}

TEST(GuidedCollapse, OfMirroredPointsIsMirrored)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    MarkedMesh m = randomMesh(seed);
    const validators::Complex left = collapsed(m);
    for (Point& point : m.points)
    {
      point = Point(point.x(), -point.y(), point.z());
    }
    const validators::Complex mirrored = collapsed(m);
    EXPECT_EQ(left.triangles, mirrored.triangles);
    EXPECT_EQ(left.edges, mirrored.edges);
  }
}

TEST(GuidedCollapse, CanBeStopped)
{
  const MarkedMesh m = randomMesh(8);
  pipelines::Watch watch;
  watch.stopAt = 0;
  EXPECT_THROW(collapsed(m, watch.execution()), medial::Aborted);
}
