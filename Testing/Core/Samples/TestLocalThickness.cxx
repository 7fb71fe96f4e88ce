// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/LocalThickness.h"

#include "Executions.h"
#include "Meshes.h"
#include "Samples/BlueNoise.h"
#include "Samples/SharpEdges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
using medial::Index;
using medial::Point;
using medial::SurfacePoint;
using medial::Triangle;
using meshes::Mesh;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double thick = 1000; // more than any of the meshes is

/// Samples of a mesh, and how thick it is at each.
struct Measured
{
  std::vector<SurfacePoint> samples;
  std::vector<double> thickness;
};

enum class Edges
{
  Unknown,
  Known
};

Measured measured(const Mesh& mesh, double spacing, Edges edges = Edges::Unknown,
  const medial::Execution& execution = {}, double most = thick)
{
  const std::vector<Triangle> triangles = meshes::triangles(meshes::triangulated(mesh));
  const medial::TriangleSet set = medial::triangleSet(mesh.points, triangles);
  const medial::SurfaceTree tree(mesh.points, triangles);
  Measured result;
  result.samples = medial::blueNoise(set, medial::surfacePieces(set, medial::SpacingField(spacing)),
    {}, medial::SpacingField(spacing));
  std::vector<medial::WedgeEdge> known;
  if (edges == Edges::Known)
  {
    known = medial::wedgeEdges(set, medial::sharpLines(set, 30), spacing);
  }
  result.thickness =
    medial::localThickness(result.samples, tree, set.normals, most, known, execution);
  return result;
}

TEST(LocalThickness, OfAPlateIsItsOwn)
{
  const Measured plate = measured(meshes::box(Point::Zero(), Point(4, 4, 0.1)), 0.2);
  int faces = 0;
  for (std::size_t i = 0; i < plate.samples.size(); ++i)
  {
    const Point& p = plate.samples[i].position;
    if (std::abs(plate.samples[i].normal.z()) == 1 && std::min(p.x(), p.y()) > 0.2 &&
      std::max(p.x(), p.y()) < 3.8)
    {
      EXPECT_NEAR(plate.thickness[i], 0.1, 1e-9);
      ++faces;
    }
  }
  EXPECT_GT(faces, 200);
}

TEST(LocalThickness, IsTheSameWhereOnlyTheLastSamplesAreMeasured)
{
  const Mesh mesh = meshes::torus();
  const std::vector<Triangle> triangles = meshes::triangles(meshes::triangulated(mesh));
  const medial::TriangleSet set = medial::triangleSet(mesh.points, triangles);
  const medial::SurfaceTree tree(mesh.points, triangles);
  const Measured all = measured(mesh, 0.3);
  const Index first = medial::count(all.samples) / 3;
  EXPECT_EQ(medial::localThickness(all.samples, tree, set.normals, thick, {}, {}, first),
    std::vector<double>(all.thickness.begin() + first, all.thickness.end()));
}

TEST(LocalThickness, OfAGapIsItsWidth)
{
  const Mesh cube = meshes::box(Point::Zero(), Point::Ones());
  const Measured two = measured(meshes::united(cube, meshes::moved(cube, Point(1.02, 0, 0))), 0.05);
  int beside = 0;
  for (std::size_t i = 0; i < two.samples.size(); ++i)
  {
    const Point& p = two.samples[i].position;
    const bool inGap = std::abs(p.x() - 1.01) < 0.011 && std::abs(two.samples[i].normal.x()) == 1;
    const bool atRim = std::min(p.y(), p.z()) < 0.1 || std::max(p.y(), p.z()) > 0.9;
    if (inGap && !atRim)
    {
      EXPECT_NEAR(two.thickness[i], 0.02, 1e-9);
      ++beside;
    }
    else if (!inGap)
    {
      EXPECT_GT(two.thickness[i], 0.5);
    }
  }
  EXPECT_GT(beside, 100);
}

/// A wall of the box is no less thick where another one is near.
TEST(LocalThickness, IsNotSmallAtAnEdge)
{
  const Measured box = measured(meshes::box(Point::Zero(), Point::Ones()), 0.05);
  for (std::size_t i = 0; i < box.samples.size(); ++i)
  {
    const Point fromMiddle = (box.samples[i].position - Point::Constant(0.5)).cwiseAbs();
    std::array distances{ 0.5 - fromMiddle.x(), 0.5 - fromMiddle.y(), 0.5 - fromMiddle.z() };
    std::sort(distances.begin(), distances.end()); // 0, to the nearest edge, ...
    if (distances[1] < 0.3)
    {
      EXPECT_EQ(box.thickness[i], infinite);
    }
    EXPECT_GT(box.thickness[i], 0.9);
  }
}

TEST(LocalThickness, OfASphereIsItsDiameter)
{
  const Measured ball = measured(meshes::sphere(1, 64), 0.1);
  std::size_t found = 0;
  for (const double thickness : ball.thickness)
  {
    EXPECT_GT(thickness, 1.85); // of flat pieces
    found += thickness < 2.15;
  }
  EXPECT_GT(found, 0.85 * double(ball.thickness.size())); // the others are at edges of pieces
}

TEST(LocalThickness, OfABowlIsThatOfItsWall)
{
  const Measured bowl = measured(
    meshes::united(meshes::sphere(1, 64), meshes::reversed(meshes::sphere(0.75, 64))), 0.05);
  std::size_t found = 0;
  for (const double thickness : bowl.thickness)
  {
    EXPECT_GT(thickness, 0.22);
    found += thickness < 0.28;
  }
  EXPECT_GT(found, 0.95 * double(bowl.thickness.size()));
}

/// The least thickness of samples on the two walls that meet along z, farther than a distance from it.
double leastOnWalls(const Measured& wedge, double from)
{
  double result = infinite;
  for (std::size_t i = 0; i < wedge.samples.size(); ++i)
  {
    const SurfacePoint& sample = wedge.samples[i];
    const bool isOnWall = std::abs(sample.normal.z()) < 0.5 && sample.normal.x() < 0.5;
    const double height = std::min(sample.position.z(), 1 - sample.position.z());
    if (isOnWall && height > 0.2 && sample.position.x() > from)
    {
      result = std::min(result, wedge.thickness[i]);
    }
  }
  return result;
}

TEST(LocalThickness, OfAWedgeIsNotMeasuredAcrossItsWalls)
{
  const Mesh wedge = meshes::wedge(30);
  EXPECT_LT(leastOnWalls(measured(wedge, 0.05), 0), 0.1); // as little as one likes
  EXPECT_EQ(leastOnWalls(measured(wedge, 0.05, Edges::Known), 0), infinite);
}

/// What is thin far behind its edge is thin.
TEST(LocalThickness, OfAVeryNarrowWedgeIs)
{
  const Mesh wedge = meshes::wedge(2);
  const double least = leastOnWalls(measured(wedge, 0.05, Edges::Known), 0.5);
  const double expected = 2 * 0.5 * std::tan(3.14159265358979323846 / 180);
  EXPECT_GT(least, 0.9 * expected);
  EXPECT_LT(least, 1.4 * expected);
}

/// The walls of a blunt wedge would meet behind its end: the end is thin.
TEST(LocalThickness, OfABluntWedgeIsThatOfItsEnd)
{
  Mesh blunt = meshes::box(Point::Zero(), Point(1, 0.02, 1));
  for (Point& point : blunt.points)
  {
    point.y() += point.y() > 0 ? std::tan(0.5) * point.x() : 0;
  }
  EXPECT_LT(leastOnWalls(measured(blunt, 0.02, Edges::Known), 0), 0.05);
}

/// Whether a search begins with a ball that is just large enough or with the largest one.
TEST(LocalThickness, UpToALimitIsTheSame)
{
  const std::vector<Mesh> meshes{ meshes::torus(), meshes::iBeam(3), meshes::drilledPlate(0.4),
    meshes::united(meshes::sphere(1, 64), meshes::reversed(meshes::sphere(0.75, 64))) };
  for (const Mesh& mesh : meshes)
  {
    constexpr double most = 0.9;
    constexpr double exact = 0.95; // where a search ends
    const std::vector<double> all = measured(mesh, 0.1).thickness;
    const std::vector<double> limited = measured(mesh, 0.1, Edges::Unknown, {}, most).thickness;
    std::size_t alike = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      EXPECT_TRUE(limited[i] < most || limited[i] == infinite);
      EXPECT_GT(limited[i], exact * std::min(all[i], most));
      alike += all[i] < most ? std::abs(limited[i] / all[i] - 1) < 0.1 : limited[i] == infinite;
    }
    EXPECT_GT(alike, 0.98 * double(all.size()));
  }
}

TEST(LocalThickness, DoesNotDependOnThreads)
{
  const Mesh mesh = meshes::torus();
  EXPECT_EQ(measured(mesh, 0.2, Edges::Known, pipelines::threaded()).thickness,
    measured(mesh, 0.2, Edges::Known).thickness);
}
}
