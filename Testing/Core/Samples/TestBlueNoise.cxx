// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/BlueNoise.h"

#include "Executions.h"
#include "Meshes.h"
#include "Numbers.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace
{
using medial::Index;
using medial::Point;
using medial::SpacingField;
using medial::SurfacePoint;
using medial::Triangle;
using medial::TriangleSet;

/// A mesh cut into triangles, and what the samples need of it.
struct Surface
{
  explicit Surface(const meshes::Mesh& mesh)
    : points(mesh.points)
    , triangles(meshes::triangles(meshes::triangulated(mesh)))
    , set(medial::triangleSet(points, triangles))
  {
  }

  std::vector<Point> points;
  std::vector<Triangle> triangles;
  TriangleSet set;
};

std::vector<SurfacePoint> blueNoise(const Surface& surface, const SpacingField& spacing,
  const std::vector<SurfacePoint>& taken = {}, const medial::Execution& execution = {})
{
  return medial::blueNoise(
    surface.set, medial::surfacePieces(surface.set, spacing, execution), taken, spacing, execution);
}

/// Many places on the surface, by area.
std::vector<Point> places(const Surface& surface, int howMany)
{
  shapes::Random random(11);
  std::vector<double> sums(surface.set.areas.size());
  std::partial_sum(surface.set.areas.begin(), surface.set.areas.end(), sums.begin());
  std::vector<Point> result;
  for (int i = 0; i < howMany; ++i)
  {
    const double area = shapes::uniform(random, 0, sums.back());
    const auto found = std::upper_bound(sums.begin(), sums.end(), area);
    const Triangle& t = surface.triangles[found - sums.begin()];
    double u = shapes::uniform(random, 0, 1), v = shapes::uniform(random, 0, 1);
    u = u + v > 1 ? 1 - u : u;
    v = std::min(v, 1 - u);
    const Point& a = surface.points[t[0]];
    result.push_back(a + u * (surface.points[t[1]] - a) + v * (surface.points[t[2]] - a));
  }
  return result;
}

double distanceTo(const std::vector<SurfacePoint>& samples, const Point& place)
{
  double result = std::numeric_limits<double>::infinity();
  for (const SurfacePoint& sample : samples)
  {
    result = std::min(result, (sample.position - place).norm());
  }
  return result;
}

/// Eight candidates for each sample leave no wider gap, in spacings; measured 1.36.
constexpr double widest = 1.6;

TEST(BlueNoise, KeepsTheSpacingAndLeavesNoGap)
{
  const Surface surface(meshes::torus());
  const double spacing = 0.25;
  const std::vector<SurfacePoint> samples = blueNoise(surface, SpacingField(spacing));
  ASSERT_GT(samples.size(), 300);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      EXPECT_GE((samples[i].position - samples[j].position).norm(), spacing);
    }
  }
  for (const Point& place : places(surface, 3000))
  {
    EXPECT_LE(distanceTo(samples, place), widest * spacing);
  }
}

TEST(BlueNoise, FollowsASpacingThatChanges)
{
  const Surface surface(meshes::box(Point::Zero(), Point(2, 2, 2)));
  const SpacingField spacing(0.3, { Point::Zero() }, { 0.03 });
  const std::vector<SurfacePoint> samples = blueNoise(surface, spacing);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      // In pieces of triangles the spacing is that of their middle.
      const Point &a = samples[i].position, &b = samples[j].position;
      EXPECT_GE((a - b).norm(), 0.5 * std::min(spacing.at(a), spacing.at(b)));
    }
  }
  for (const Point& place : places(surface, 3000))
  {
    EXPECT_LE(distanceTo(samples, place), 1.5 * widest * spacing.at(place));
  }
}

TEST(BlueNoise, LiesOnItsTriangles)
{
  const Surface surface(meshes::torus());
  for (const SurfacePoint& sample : blueNoise(surface, SpacingField(0.25)))
  {
    const Triangle& t = surface.triangles[sample.triangle];
    EXPECT_EQ(sample.normal, surface.set.normals[sample.triangle]);
    EXPECT_NEAR(sample.normal.norm(), 1, 1e-12);
    EXPECT_NEAR(sample.normal.dot(sample.position - surface.points[t[0]]), 0, 1e-12);
  }
}

TEST(BlueNoise, KeepsAwayFromSamplesThatThereAre)
{
  const Surface surface(meshes::box(Point::Zero(), Point::Ones()));
  const std::vector<SurfacePoint> taken = { { Point(0.5, 0.5, 1), Point::UnitZ(), 0 },
    { Point(0.4, 0.3, 1), Point::UnitZ(), 0 } };
  const std::vector<SurfacePoint> samples = blueNoise(surface, SpacingField(0.1), taken);
  EXPECT_EQ(samples[0].position, taken[0].position);
  EXPECT_EQ(samples[1].position, taken[1].position);
  for (std::size_t i = 2; i < samples.size(); ++i)
  {
    EXPECT_GT((samples[i].position - taken[0].position).norm(), 0.075);
    EXPECT_GT((samples[i].position - taken[1].position).norm(), 0.075);
  }
}

/// So that a number of samples can be kept to before they are made.
TEST(BlueNoise, HasNoMoreThanTheExpectedNumberButNearlyAsMany)
{
  const Surface surface(meshes::torus());
  for (const double spacing : { 0.1, 0.2 })
  {
    const SpacingField field(spacing);
    const double found = double(blueNoise(surface, field).size());
    const double expected = medial::expectedSamples(medial::surfacePieces(surface.set, field));
    EXPECT_LE(found, expected);
    EXPECT_GE(found, 0.75 * expected);
  }
}

TEST(BlueNoise, IsTheSameInEachRunAndForAnyThreads)
{
  const Surface surface(meshes::torus());
  const SpacingField spacing(0.25, { Point(2.7, 0, 0) }, { 0.05 });
  const auto samples = positions(blueNoise(surface, spacing));
  EXPECT_EQ(positions(blueNoise(surface, spacing)), samples);
  EXPECT_EQ(positions(blueNoise(surface, spacing, {}, pipelines::threaded())), samples);
}

TEST(BlueNoise, CanBeStopped)
{
  const Surface surface(meshes::torus());
  pipelines::expectProgressAndAbort([&surface](const medial::Execution& execution) {
    blueNoise(surface, SpacingField(0.25), {}, execution);
  });
}

/// Only some of the pieces: samples on those, and nowhere else.
TEST(BlueNoise, CoversThePiecesAlone)
{
  const Surface surface(meshes::torus());
  const SpacingField spacing(0.25);
  std::vector<medial::SurfacePiece> pieces = medial::surfacePieces(surface.set, spacing);
  const auto all = medial::blueNoise(surface.set, pieces, {}, spacing);
  const Index half = medial::count(surface.triangles) / 2;
  const auto isInSecondHalf = [half](const auto& x) { return x.triangle >= half; };
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), isInSecondHalf), pieces.end());
  const auto some = medial::blueNoise(surface.set, pieces, {}, spacing);
  EXPECT_TRUE(std::none_of(some.begin(), some.end(), isInSecondHalf));
  EXPECT_NEAR(double(some.size()), double(all.size()) / 2, 0.1 * double(all.size()));
}

TEST(SurfacePieces, CoverTheTriangles)
{
  const Surface surface(meshes::box(Point::Zero(), Point(2, 2, 2)));
  const SpacingField spacing(0.3, { Point::Zero() }, { 0.03 });
  std::vector<double> areas(surface.triangles.size(), 0);
  for (const medial::SurfacePiece& piece : medial::surfacePieces(surface.set, spacing))
  {
    const auto& [a, b, c] = piece.corners;
    areas[piece.triangle] += (b - a).cross(c - a).norm() / 2;
    EXPECT_EQ(piece.spacing, spacing.at(piece.middle()));
    EXPECT_LE((b - a).norm(), 3 * piece.spacing);
  }
  for (std::size_t t = 0; t < areas.size(); ++t)
  {
    EXPECT_NEAR(areas[t], surface.set.areas[t], 1e-12);
  }
}

TEST(TriangleSet, HasNormalsAndAreas)
{
  const Surface flat(meshes::tetrahedronWithFlatTriangle());
  EXPECT_EQ(flat.set.areas.back(), 0);
  EXPECT_EQ(flat.set.normals.back(), Point(Point::Zero()));
  EXPECT_EQ(flat.set.areas[1], 0.5);
  EXPECT_EQ(flat.set.normals[1], Point(-Point::UnitX()));
  EXPECT_GT(blueNoise(flat, SpacingField(0.1)).size(), 100);
}
}
