// SPDX-License-Identifier: BSD-3-Clause
#include "Complexes.h"
#include "Meshes.h"
#include "Numbers.h"
#include "Shapes.h"
#include "Validators.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace validators;

namespace
{
/// FNV-1a, of the bits of all coordinates.
std::uint64_t checksum(const std::vector<Point>& points)
{
  std::uint64_t result = 0xcbf29ce484222325;
  for (const Point& point : points)
  {
    for (const double coordinate : point)
    {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &coordinate, sizeof(bits));
      for (int byte = 0; byte < 8; ++byte)
      {
        result = (result ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3;
      }
    }
  }
  return result;
}

std::vector<Point> noise()
{
  shapes::Random random(3);
  std::vector<Point> result;
  for (int i = 0; i < 1000; ++i)
  {
    result.push_back(shapes::normalPoint(random, 0.02));
  }
  return result;
}

/// All kinds of inputs that tests make.
std::map<std::string, std::vector<Point>> inputs()
{
  std::map<std::string, std::vector<Point>> result;
  for (const shapes::Shape& shape : shapes::all())
  {
    result[shape.name] = shape.samples;
  }
  const std::vector<Point>& sphere = result["sphere"];
  result["head"] = shapes::head().samples;
  result["bowl"] = shapes::openBowl();
  result["cloud"] = shapes::cloud(500, 2);
  result["noise"] = noise();
  result["grid"] = shapes::gridCube(9);
  result["moved"] = shapes::moved(sphere, Point(3e6, 5e5, 0.1));
  result["rotated"] = shapes::rotated(sphere, 4);
  result["rotated back"] = shapes::rotated(sphere, 5, true);
  result["scaled"] = shapes::scaled(sphere, 0.3);
  result["floats"] = shapes::roundedToFloats(sphere);
  result["shuffled"] = shapes::reordered(sphere, shapes::shuffledOrder(sphere.size(), 6));
  result["complex"] = complexes::randomComplex(7).points;
  result["mesh of a torus"] = meshes::torus().points;
  result["mesh of a sphere"] = meshes::sphere().points;
  result["mesh of a cylinder"] = meshes::cylinder(0.3, 2).points;
  result["mesh of a wedge"] = meshes::wedge(7).points;
  return result;
}
}

TEST(Shapes, SamplesLieOnTheBoundaryOneSpacingApart)
{
  for (const shapes::Shape& shape : shapes::all())
  {
    SCOPED_TRACE(testing::Message() << shape.name << ", seed " << shape.seed);
    EXPECT_GE(shape.samples.size(), 200u);
    EXPECT_EQ(nearDuplicates(shape.samples, 0.99 * shape.spacing), 0);
    for (const Point& sample : shape.samples)
    {
      ASSERT_NEAR(shape.outside(sample), 0, 1e-12);
    }
  }
}

TEST(Shapes, LeaveNoGap)
{
  const std::vector<std::pair<shapes::Shape, shapes::Shape>> draws{
    { shapes::box(0.1, 1), shapes::box(0.1, 9) }, { shapes::torus(0.2, 1), shapes::torus(0.2, 9) },
    { shapes::knot(0.17, 1), shapes::knot(0.17, 9) },
    { shapes::twoHolePlate(0.09, 1), shapes::twoHolePlate(0.09, 9) }
  };
  for (const auto& [shape, other] : draws)
  {
    SCOPED_TRACE(testing::Message() << shape.name << ", seeds 1 and 9");
    EXPECT_LT(hausdorffDistance(other.samples, shape.samples), 1.1 * shape.spacing);
  }
}

TEST(Shapes, DistanceToTheAxisIsTheRadiusOfTheBallsAtTheSamples)
{
  EXPECT_NEAR(shapes::sphere().axisDistance(Point(0, 0, 1)), 1, 1e-12);
  EXPECT_NEAR(shapes::box().axisDistance(Point(0, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(shapes::box().axisDistance(Point(1.5, 1, 0)), 0, 1e-12);
  EXPECT_NEAR(shapes::box().axisDistance(Point(0, 0, 0.5)), 0.5, 1e-12);
  EXPECT_NEAR(shapes::ellipsoid().axisDistance(Point(0.3, 0.2, 0.1)), 0.1, 1e-12);
  EXPECT_NEAR(shapes::ellipsoid().axisDistance(Point(1.5, 0, 0)), 1.0 / 6, 1e-9);
  EXPECT_NEAR(shapes::hollowSphere().axisDistance(Point(0, 0, 1)), 0.25, 1e-12);
}

TEST(Shapes, MotionsAreUndone)
{
  const std::vector<Point> points = shapes::capsule().samples;
  EXPECT_LT(hausdorffDistance(points, shapes::rotated(shapes::rotated(points, 4), 4, true)), 1e-12);
  EXPECT_GT(hausdorffDistance(points, shapes::rotated(points, 4)), 0.1);
  EXPECT_EQ(shapes::scaled(shapes::scaled(points, 1024), 1.0 / 1024), points);
  const std::vector<Index> order = shapes::shuffledOrder(points.size(), 7);
  EXPECT_EQ(hausdorffDistance(points, shapes::reordered(points, order)), 0);
  EXPECT_NE(shapes::reordered(points, order), points);
}

TEST(Shapes, FloatsAreRoundedToTheLastOne)
{
  for (const Point& point :
    shapes::roundedToFloats(shapes::moved(shapes::sphere().samples, Point(3e6, 5e5, 2e6))))
  {
    for (const double coordinate : point)
    {
      ASSERT_EQ(std::fmod(coordinate, 1.0 / 32), 0);
    }
  }
}

/// What a test finds on a machine, it finds on every other. If a shape is changed on purpose, take the
/// checksums from the message.
TEST(Shapes, AreTheSameUnderEveryCompiler)
{
  const std::map<std::string, std::uint64_t> expected{ { "bowl", 0x0dfe5f5da5c579cf },
    { "box", 0x64a80847daba99d1 }, { "capsule", 0x96466d393922e4d6 },
    { "cloud", 0x3c4198d56efa0b4b }, { "complex", 0x3e683729ec3fe29d },
    { "ellipsoid", 0x6dac5309ad5bfafc }, { "floats", 0x13c975bd54df571c },
    { "grid", 0x1eb75615ca7d3735 }, { "head", 0x8a845ccb68c6927d },
    { "hollow sphere", 0xa5d5190d36e7b6e2 }, { "knot", 0x3a9a01441b1fb3f7 },
    { "mesh of a cylinder", 0x2d056e133a2efcf1 }, { "mesh of a sphere", 0xb7d0ececffb64bc1 },
    { "mesh of a torus", 0x5fb32fe372b86c9d }, { "mesh of a wedge", 0x8bed69dc3ede1b0c },
    { "moved", 0x42204fd2eec370ed }, { "noise", 0x9167f65d649ac88c },
    { "rotated", 0x6354381d4c19346a }, { "rotated back", 0xb2c52ada7678970b },
    { "scaled", 0x889bc3a9a697af8e }, { "shuffled", 0x3a3c55d1537e46b8 },
    { "sphere", 0x631b93cc8017bda8 }, { "torus", 0x9a64f8ed85e3cda2 },
    { "two objects", 0x40154bc4186af155 }, { "two-hole plate", 0x6fd86f51489e7622 } };
  std::map<std::string, std::uint64_t> found;
  for (const auto& [name, points] : inputs())
  {
    found[name] = checksum(points);
  }
  EXPECT_EQ(found, expected);
}

TEST(Numbers, SinesAreRight)
{
  for (int i = -2000; i <= 2000; ++i)
  {
    const double angle = 0.01 * i;
    EXPECT_NEAR(shapes::sine(angle), std::sin(angle), 4e-15) << angle;
    EXPECT_NEAR(shapes::cosine(angle), std::cos(angle), 4e-15) << angle;
  }
}

TEST(Numbers, NormalOnesHaveTheirDeviation)
{
  double squares = 0;
  for (const Point& point : noise())
  {
    squares += point.squaredNorm();
  }
  EXPECT_NEAR(std::sqrt(squares / 3000), 0.02, 0.001);
}

TEST(Shapes, AreTheSameInEveryRun)
{
  EXPECT_EQ(shapes::sphere(0.3, 5).samples, shapes::sphere(0.3, 5).samples);
  EXPECT_NE(shapes::sphere(0.3, 5).samples, shapes::sphere(0.3, 6).samples);
}
