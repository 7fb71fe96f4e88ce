// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/VolumeOfInterest.h"

#include "Base/Errors.h"
#include "Meshes.h"
#include "Numbers.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using Box = Eigen::AlignedBox3d;
using medial::Point;

namespace
{
struct Surface
{
  std::vector<Point> points;
  std::vector<medial::Triangle> triangles;

  explicit Surface(const meshes::Mesh& mesh)
  {
    const meshes::Mesh triangulated = meshes::triangulated(mesh);
    this->points = triangulated.points;
    this->triangles = meshes::triangles(triangulated);
  }

  double volume(const Box& box) const
  {
    return medial::volumeWithin(box, this->points, this->triangles);
  }
  double area(const Box& box) const
  {
    return medial::areaOf(medial::areasWithin(box, this->points, this->triangles));
  }
  double euler(const Box& box) const
  {
    return medial::eulerWithin(box, this->points, this->triangles);
  }
};

const Box all(Point(-100, -100, -100), Point(100, 100, 100));
}

TEST(VolumeOfInterest, HoldsTheWholeSolid)
{
  const Surface plate(meshes::drilledPlate(0.5));
  EXPECT_NEAR(plate.volume(all), 7.5, 1e-9);
  EXPECT_NEAR(plate.area(all), 2 * 15 + 0.5 * 20, 1e-9);
  EXPECT_NEAR(plate.euler(all), 0, 1e-12);
  const Box tight(Point(0, 0, 0), Point(4, 4, 0.5)); // its sides lie on those of the solid
  EXPECT_NEAR(plate.volume(tight), 7.5, 1e-9);
  EXPECT_NEAR(plate.area(tight), 2 * 15 + 0.5 * 20, 1e-9);
}

TEST(VolumeOfInterest, CutsABox)
{
  const Surface box(meshes::box(Point(0, 0, 0), Point(4, 4, 4)));
  const Box inner(Point(1, 1, 1), Point(2, 3, 3.5));
  EXPECT_NEAR(box.volume(inner), 1 * 2 * 2.5, 1e-12);
  EXPECT_EQ(box.area(inner), 0);
  EXPECT_EQ(box.euler(inner), 0);
  const Box corner(Point(3, 3, 3), Point(5, 6, 7));
  EXPECT_NEAR(box.volume(corner), 1, 1e-12);
  EXPECT_NEAR(box.area(corner), 3, 1e-12);
  EXPECT_NEAR(box.euler(corner), 1.0 / 8, 1e-12); // one of eight corners
  EXPECT_EQ(box.volume(Box(Point(5, 0, 0), Point(6, 4, 4))), 0);
}

TEST(VolumeOfInterest, KnowsTheEulerCharacteristic)
{
  EXPECT_NEAR(Surface(meshes::sphere()).euler(all), 1, 1e-12);
  EXPECT_NEAR(Surface(meshes::torus()).euler(all), 0, 1e-12);
  const meshes::Mesh hollow =
    meshes::united(meshes::sphere(2), meshes::reversed(meshes::sphere(1)));
  EXPECT_NEAR(Surface(hollow).euler(all), 2, 1e-12);
}

TEST(VolumeOfInterest, OfASphereIsAKnownCap)
{
  const Surface sphere(meshes::sphere(1, 200));
  const Box above(Point(-2, -2, 0.5), Point(2, 2, 2));
  const double height = 0.5, pi = 3.14159265358979;
  EXPECT_NEAR(sphere.volume(above), pi * height * height * (3 - height) / 3, 2e-3);
  EXPECT_NEAR(sphere.area(above), 2 * pi * height, 2e-3);
  EXPECT_NEAR(sphere.euler(above), 0.25, 1e-2); // a quarter of the area
}

/// Boxes side by side have together what the box around them has.
TEST(VolumeOfInterest, AddsUp)
{
  constexpr unsigned seed = 11;
  shapes::Random random(seed);
  const Surface torus(meshes::torus());
  for (int turn = 0; turn < 50; ++turn)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", turn " << turn);
    const Point a = shapes::uniformInBox(random, Point(3, 3, 1));
    const Box box(a, a + Point(2, 3, 1));
    for (int axis = 0; axis < 3; ++axis)
    {
      Box first = box, second = box;
      first.max()[axis] = second.min()[axis] =
        shapes::uniform(random, box.min()[axis], box.max()[axis]);
      EXPECT_NEAR(torus.volume(first) + torus.volume(second), torus.volume(box), 1e-12);
      EXPECT_NEAR(torus.area(first) + torus.area(second), torus.area(box), 1e-12);
      EXPECT_NEAR(torus.euler(first) + torus.euler(second), torus.euler(box), 1e-12);
    }
  }
}

TEST(VolumeOfInterest, IsTheBoundingBoxWithoutItsMargin)
{
  const std::vector<Point> samples{ Point(0, 0, 0), Point(1, 2, 3) };
  EXPECT_NEAR(medial::volumeOfInterest(samples).volume(), 6, 1e-12);
  EXPECT_NEAR(medial::volumeOfInterest(samples, {}, 0.25).volume(), 0.5 * 1.5 * 2.5, 1e-12);
  EXPECT_NEAR(
    medial::volumeOfInterest({}, Box(Point(0, 0, 0), Point(2, 2, 2)), 0.5).volume(), 1, 1e-12);
}

TEST(VolumeOfInterest, RefusesWhatHoldsNothing)
{
  const std::vector<Point> samples{ Point(0, 0, 0), Point(1, 2, 3) };
  EXPECT_THROW(medial::volumeOfInterest({}), medial::InvalidInput);
  EXPECT_THROW(medial::volumeOfInterest(samples, {}, 0.5), medial::InvalidInput);
  EXPECT_THROW(medial::volumeOfInterest(samples, {}, std::nan("")), medial::InvalidInput);
  const Box reversed(Point(1, 0, 0), Point(0, 1, 1));
  EXPECT_THROW(medial::volumeOfInterest(samples, reversed), medial::InvalidInput);
}
