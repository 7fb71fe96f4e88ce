// SPDX-License-Identifier: BSD-3-Clause
#include "Base/SurfaceTree.h"

#include "Meshes.h"
#include "Numbers.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using medial::Index;
using medial::None;
using medial::Point;
using medial::SurfaceTree;
using meshes::Mesh;

constexpr unsigned seed = 3;

/// Numbers without pattern, the same in every run.
class Source
{
public:
  Point point(double size) { return shapes::uniformInBox(this->engine, Point::Constant(size)); }

private:
  shapes::Random engine{ seed };
};

SurfaceTree treeOf(const Mesh& mesh)
{
  const Mesh triangulated = meshes::triangulated(mesh);
  return SurfaceTree(triangulated.points, meshes::triangles(triangulated));
}

/// From -1 to 1.
Mesh cube()
{
  return meshes::box(-Point::Ones(), Point::Ones());
}

/// Distance to the surface of the cube.
double cubeDistance(const Point& p)
{
  const Point beyond = p.cwiseAbs() - Point::Ones();
  return beyond.maxCoeff() <= 0 ? -beyond.maxCoeff() : beyond.cwiseMax(0).norm();
}

TEST(SurfaceTree, FindsTheNearestPoint)
{
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  const Mesh mesh = meshes::triangulated(cube());
  const SurfaceTree tree = treeOf(mesh);
  Source source;
  for (int i = 0; i < 1000; ++i)
  {
    const Point place = source.point(2);
    const SurfaceTree::Place found = tree.nearest(place);
    EXPECT_NEAR((found.point - place).norm(), cubeDistance(place), 1e-12);
    EXPECT_NEAR(cubeDistance(found.point), 0, 1e-12);
    ASSERT_TRUE(found.triangle >= 0 && found.triangle < mesh.polygons.size());
    const auto corners = mesh.polygons[found.triangle];
    const Point a = mesh.points[corners[0]];
    const Point normal =
      (mesh.points[corners[1]] - a).cross(mesh.points[corners[2]] - a).normalized();
    EXPECT_NEAR(normal.dot(found.point - a), 0, 1e-12);
  }
}

TEST(SurfaceTree, EnclosesWhatIsInABox)
{
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  const SurfaceTree tree = treeOf(cube());
  Source source;
  for (int i = 0; i < 2000; ++i)
  {
    const Point place = source.point(1.5);
    EXPECT_EQ(tree.encloses(place), place.cwiseAbs().maxCoeff() < 1);
  }
}

TEST(SurfaceTree, DoesNotEncloseItsSurface)
{
  const SurfaceTree tree = treeOf(cube());
  const double step = std::numeric_limits<double>::epsilon();
  for (const Point& on : { Point(1, 0.3, 0.2), Point(1, 1, 0.3), Point(-1, 1, 1), Point(0, 0, 1) })
  {
    EXPECT_FALSE(tree.encloses(on));
    EXPECT_TRUE(tree.encloses((1 - step) * on));
    EXPECT_FALSE(tree.encloses((1 + step) * on));
  }
}

TEST(SurfaceTree, EnclosesNothingInAVoid)
{
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  const SurfaceTree tree =
    treeOf(meshes::united(meshes::sphere(), meshes::reversed(meshes::sphere(0.5))));
  Source source;
  int checked = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const Point place = source.point(1.2);
    const double r = place.norm();
    constexpr double sagitta = 0.02; // of the squares of both spheres
    if (std::abs(r - 1) > sagitta && std::abs(r - 0.5) > sagitta)
    {
      EXPECT_EQ(tree.encloses(place), r < 1 && r > 0.5);
      ++checked;
    }
  }
  EXPECT_GT(checked, 1800);
}

TEST(SurfaceTree, FindsWhatAWayMeetsFirst)
{
  const SurfaceTree tree = treeOf(cube());
  const auto out = tree.firstMet(Point(0.125, 0.25, 0.375), Point(0.125, 0.25, 5), None);
  ASSERT_TRUE(out);
  EXPECT_EQ(out->point, Point(0.125, 0.25, 1));
  const auto through = tree.firstMet(Point(-3, 0.25, 0.375), Point(3, 0.25, 0.375), None);
  ASSERT_TRUE(through);
  EXPECT_EQ(through->point, Point(-1, 0.25, 0.375));
  EXPECT_FALSE(tree.firstMet(Point(-3, 0.25, 0.375), Point(-1.1, 0.25, 0.375), None));
  EXPECT_FALSE(tree.firstMet(Point(-3, 0.25, 1.25), Point(3, 0.25, 1.25), None));
}

TEST(SurfaceTree, MeetsAWallOnTheWayAlongItFirstWhereThatBegins)
{
  const SurfaceTree tree = treeOf(cube());
  const auto along = tree.firstMet(Point(-3, 0.25, 1), Point(3, 0.25, 1), None);
  ASSERT_TRUE(along);
  EXPECT_EQ(along->point, Point(-1, 0.25, 1));
}

TEST(SurfaceTree, SkipsTheTriangleThatAWayBeginsOn)
{
  const SurfaceTree tree = treeOf(cube());
  const Point start(0.1, 0.2, 1);
  const auto here = tree.firstMet(start, Point(0.1, 0.2, -4), None);
  ASSERT_TRUE(here);
  EXPECT_EQ(here->point, start);
  const auto across = tree.firstMet(start, Point(0.1, 0.2, -4), here->triangle);
  ASSERT_TRUE(across);
  EXPECT_EQ(across->point, Point(0.1, 0.2, -1));
  EXPECT_FALSE(tree.firstMet(start, Point(0.1, 0.2, 4), here->triangle));
  EXPECT_FALSE(tree.firstMet(start, start, None)); // CGAL would throw an exception
}

TEST(SurfaceTree, LeavesOutTrianglesWithoutArea)
{
  const Mesh mesh = meshes::tetrahedronWithFlatTriangle();
  const SurfaceTree tree = treeOf(mesh);
  EXPECT_TRUE(tree.encloses(Point(0.1, 0.1, 0.1)));
  EXPECT_FALSE(tree.encloses(Point(0.4, 0.4, 0.4)));
  const SurfaceTree::Place found = tree.nearest(Point(0.5, -1, -1));
  EXPECT_EQ(found.point, Point(0.5, 0, 0));
  EXPECT_NE(found.triangle, 5);
}

TEST(SurfaceTree, AnswersFromAfarAndAnyUnit)
{
  const SurfaceTree tree = treeOf(meshes::scaled(meshes::moved(cube(), Point(1000, 0, 0)), 1e-6));
  EXPECT_TRUE(tree.encloses(Point(1000e-6, 0, 0)));
  EXPECT_FALSE(tree.encloses(Point::Zero()));
  EXPECT_NEAR(tree.nearest(Point(1, 0, 0)).point.x(), 1001e-6, 1e-15);
}
}
