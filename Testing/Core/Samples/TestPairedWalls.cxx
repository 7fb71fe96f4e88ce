// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/PairedWalls.h"

#include "Base/SurfaceTree.h"
#include "Executions.h"
#include "Meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using medial::Index;
using medial::PairedSamples;
using medial::Point;
using medial::SpacingField;
using medial::SurfacePoint;
using medial::SurfaceTree;
using medial::Triangle;

/// A mesh with random samples.
struct Sampled
{
  Sampled(const meshes::Mesh& mesh, double theSpacing)
    : points(mesh.points)
    , triangles(meshes::triangles(meshes::triangulated(mesh)))
    , set(medial::triangleSet(this->points, this->triangles))
    , tree(this->points, this->triangles)
    , spacing(theSpacing)
    , samples(medial::blueNoise(
        this->set, medial::surfacePieces(this->set, this->spacing), {}, this->spacing))
  {
  }

  PairedSamples paired(double width, Index fixed = 0, const medial::Execution& execution = {}) const
  {
    return medial::pairAcrossWalls(
      this->set, this->tree, this->spacing, width, this->samples, fixed, execution);
  }

  std::vector<Point> points;
  std::vector<Triangle> triangles;
  medial::TriangleSet set;
  SurfaceTree tree;
  SpacingField spacing;
  std::vector<SurfacePoint> samples;
};

double least(const std::vector<SurfacePoint>& all, const Point& from, const SurfacePoint& but)
{
  double result = 1e9;
  for (const SurfacePoint& other : all)
  {
    result = &other == &but ? result : std::min(result, (other.position - from).norm());
  }
  return result;
}

TEST(PairedWalls, AreMirrorImages)
{
  const double thickness = 0.01, spacing = 0.2;
  const Sampled plate(meshes::box(Point::Zero(), Point(4, 4, thickness)), spacing);
  const PairedSamples paired = plate.paired(2 * thickness);
  EXPECT_GT(paired.places.size(), 200);
  // Random samples keep away from each other across the plate, too, so that they are on one wall or on the other.
  EXPECT_NEAR(double(paired.points.size()), 2 * double(plate.samples.size()),
    0.1 * double(plate.samples.size()));
  for (const SurfacePoint& sample : paired.points)
  {
    EXPECT_EQ(plate.tree.distance(sample.position, sample.triangle), 0);
    const double x = std::min(sample.position.x(), sample.position.y());
    if (x > spacing && std::abs(sample.normal.z()) == 1)
    {
      const Point opposite(
        sample.position.x(), sample.position.y(), thickness - sample.position.z());
      EXPECT_LT(least(paired.points, opposite, sample), 1e-12);
    }
  }
}

/// Also where the gap between two solids is narrow, and in any position.
TEST(PairedWalls, AreThoseOfAGap)
{
  const meshes::Mesh cube = meshes::box(Point::Zero(), Point::Ones());
  const Sampled cubes(meshes::united(cube, meshes::moved(cube, Point(1.01, 0, 0))), 0.2);
  const PairedSamples paired = cubes.paired(0.02);
  EXPECT_GT(paired.places.size(), 10);
  for (const Point& place : paired.places)
  {
    EXPECT_TRUE(std::abs(place.x() - 1) < 1e-12 || std::abs(place.x() - 1.01) < 1e-12);
  }
}

TEST(PairedWalls, AreNeitherWideNorWedgesNorNearlyAtOnePlace)
{
  for (const double thickness : { 0.021, 0.003 }) // above 0.02; below a fiftieth of 0.2
  {
    const Sampled plate(meshes::box(Point::Zero(), Point(4, 4, thickness)), 0.2);
    EXPECT_TRUE(plate.paired(0.02).places.empty());
  }
  const Sampled wedge(meshes::wedge(5), 0.1);
  EXPECT_TRUE(wedge.paired(0.05).places.empty());
}

TEST(PairedWalls, LeaveFixedSamplesWhereTheyAre)
{
  const Sampled plate(meshes::box(Point::Zero(), Point(4, 4, 0.01)), 0.2);
  const Index fixed = medial::count(plate.samples) / 2;
  const PairedSamples paired = plate.paired(0.02, fixed);
  for (Index i = 0; i < fixed; ++i)
  {
    EXPECT_EQ(paired.points[i].position, plate.samples[i].position);
  }
  EXPECT_EQ(plate.paired(0.02, medial::count(plate.samples)).points.size(), plate.samples.size());
}

TEST(PairedWalls, AreTheSameForAnyThreadsAndCanBeStopped)
{
  const Sampled plate(meshes::box(Point::Zero(), Point(4, 4, 0.01)), 0.2);
  EXPECT_EQ(medial::positions(plate.paired(0.02, 0, pipelines::threaded()).points),
    medial::positions(plate.paired(0.02).points));
  pipelines::expectProgressAndAbort(
    [&plate](const medial::Execution& execution) { plate.paired(0.02, 0, execution); });
}
}
