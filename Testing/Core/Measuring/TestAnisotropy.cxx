// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/Anisotropy.h"

#include "Meshes.h"
#include "Numbers.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using medial::degreeOfAnisotropy;
using medial::Index;
using medial::Point;
using medial::Triangle;

namespace
{
std::vector<Point> areasOf(const meshes::Mesh& mesh)
{
  const meshes::Mesh triangulated = meshes::triangulated(mesh);
  std::vector<Point> result;
  for (const Triangle& t : meshes::triangles(triangulated))
  {
    const Point &a = triangulated.points[t[0]], &b = triangulated.points[t[1]],
                &c = triangulated.points[t[2]];
    result.emplace_back((b - a).cross(c - a) / 2);
  }
  return result;
}

meshes::Mesh changed(meshes::Mesh mesh, const Eigen::Matrix3d& matrix)
{
  for (Point& point : mesh.points)
  {
    point = matrix * point;
  }
  return mesh;
}

Eigen::Matrix3d rotation(shapes::Random& random)
{
  const double angle = shapes::uniform(random, 0, 3);
  return Eigen::AngleAxisd(angle, shapes::direction(random)).toRotationMatrix();
}
}

TEST(Anisotropy, OfASphereIsNone)
{
  EXPECT_NEAR(degreeOfAnisotropy(areasOf(meshes::sphere(1, 64))), 0, 2e-3);
  EXPECT_NEAR(degreeOfAnisotropy(areasOf(meshes::sphere(1, 128))), 0, 5e-4);
}

/// The area of an ellipsoid's shadow is known in all directions.
TEST(Anisotropy, OfEllipsoidsIsThatOfTheirAxes)
{
  for (const Point& axes : { Point(1, 1, 2), Point(1, 2, 3), Point(2, 2, 1), Point(1, 1, 1.2) })
  {
    SCOPED_TRACE(testing::Message() << "axes " << axes.transpose());
    const auto areas = areasOf(changed(meshes::sphere(1, 128), axes.asDiagonal()));
    const double ratio = axes.minCoeff() / axes.maxCoeff();
    EXPECT_NEAR(degreeOfAnisotropy(areas), 1 - ratio * ratio, 1e-3);
  }
}

TEST(Anisotropy, OfAPlaneAndOfARodIsAll)
{
  EXPECT_NEAR(degreeOfAnisotropy({ Point(0, 0, 2), Point(0, 0, -1) }), 1, 1e-12);
  std::vector<Point> sides;
  for (int i = 0; i < 360; ++i)
  {
    const double angle = i * 3.14159265358979 / 180;
    sides.emplace_back(std::cos(angle), 0, std::sin(angle));
  }
  EXPECT_NEAR(degreeOfAnisotropy(sides), 1, 1e-4);
}

TEST(Anisotropy, DoesNotDependOnUnitOrderOrientationOrMirroring)
{
  constexpr unsigned seed = 5;
  shapes::Random random(seed);
  const Eigen::Matrix3d stretched = Point(1, 1.3, 1.8).asDiagonal();
  const meshes::Mesh mesh = changed(meshes::iBeam(4), rotation(random) * stretched);
  const double expected = degreeOfAnisotropy(areasOf(mesh));
  EXPECT_GT(expected, 0.1);
  EXPECT_NEAR(degreeOfAnisotropy(areasOf(meshes::scaled(mesh, 1e6))), expected, 1e-9);
  EXPECT_NEAR(degreeOfAnisotropy(areasOf(meshes::reversed(mesh))), expected, 1e-9);
  std::vector<Point> areas = areasOf(mesh);
  std::reverse(areas.begin(), areas.end());
  EXPECT_NEAR(degreeOfAnisotropy(areas), expected, 1e-9);
  for (int turn = 0; turn < 20; ++turn)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", turn " << turn);
    Eigen::Matrix3d motion = rotation(random);
    motion.row(0) *= turn % 2 == 0 ? 1 : -1;
    EXPECT_NEAR(degreeOfAnisotropy(areasOf(changed(mesh, motion))), expected, 1e-9);
  }
}

/// Their principal directions are up to rounding.
TEST(Anisotropy, OfACubeDoesNotDependOnOrientation)
{
  shapes::Random random(6);
  const meshes::Mesh cube = meshes::box(Point(0, 0, 0), Point(1, 1, 1));
  for (int turn = 0; turn < 20; ++turn)
  {
    EXPECT_NEAR(degreeOfAnisotropy(areasOf(changed(cube, rotation(random)))), 0, 2e-3);
  }
}

TEST(Anisotropy, OfNothingIsUnknown)
{
  EXPECT_TRUE(std::isnan(degreeOfAnisotropy({})));
  EXPECT_TRUE(std::isnan(degreeOfAnisotropy({ Point(0, 0, 0) })));
}
