// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/BoundarySamples.h"

#include "Executions.h"
#include "Meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
using medial::BoundarySampler;
using medial::BoundarySamples;
using medial::ClosedSurface;
using medial::Index;
using medial::Point;
using medial::SamplingOptions;
using medial::SurfaceTree;

/// A closed surface with its tree.
struct Solid
{
  explicit Solid(const meshes::Mesh& mesh)
    : surface(medial::closedSurface(mesh.points, mesh.polygons))
    , tree(surface.points, surface.triangles)
  {
  }

  BoundarySamples samples(
    const SamplingOptions& options, const medial::Execution& execution = {}) const
  {
    return BoundarySampler(this->surface, this->tree, options, execution.between(0, 0.5))
      .samples(execution.between(0.5, 1));
  }

  ClosedSurface surface;
  SurfaceTree tree;
};

/// A hundredth of the diagonal thick.
const Solid& thinPlate()
{
  static const Solid plate(meshes::box(Point::Zero(), Point(4, 1, 0.04)));
  return plate;
}

SamplingOptions coarse()
{
  SamplingOptions options;
  options.fineness = 0.5;
  options.spacing = 0.2;
  return options;
}

std::vector<Point> positions(const BoundarySamples& samples)
{
  std::vector<Point> result;
  for (const medial::SurfacePoint& sample : samples.points)
  {
    result.push_back(sample.position);
  }
  return result;
}

Index near(const BoundarySamples& samples, const Point& place, double radius)
{
  const std::vector<Point> all = positions(samples);
  return static_cast<Index>(std::count_if(
    all.begin(), all.end(), [&](const Point& p) { return (p - place).norm() <= radius; }));
}

TEST(BoundarySamples, AreUniformIfTheyNeedNotAdapt)
{
  SamplingOptions options = coarse();
  options.adaptive = false;
  const BoundarySamples samples = thinPlate().samples(options);
  EXPECT_EQ(samples.spacings, std::vector<double>(samples.points.size(), 0.2));
}

TEST(BoundarySamples, LieOnTheSurfaceWithItsNormals)
{
  const Solid beam(meshes::iBeam(5));
  const BoundarySamples samples = beam.samples(coarse());
  EXPECT_GT(samples.mirrored, 100);
  EXPECT_LT(samples.mirrored, medial::count(samples.points));
  for (const medial::SurfacePoint& sample : samples.points)
  {
    EXPECT_NEAR((beam.tree.nearest(sample.position).point - sample.position).norm(), 0, 1e-9);
    EXPECT_TRUE(beam.tree.encloses(sample.position - 1e-3 * sample.normal));
    EXPECT_FALSE(beam.tree.encloses(sample.position + 1e-3 * sample.normal));
  }
}

TEST(BoundarySamples, AreNotMoreThanAllowed)
{
  SamplingOptions options = coarse();
  options.maximumSamples = 2000;
  const BoundarySamples samples = thinPlate().samples(options);
  EXPECT_LE(samples.points.size(), 2000);
  EXPECT_GT(samples.points.size(), 1000);
  ASSERT_EQ(samples.warnings.size(), 1);
  EXPECT_EQ(samples.warnings[0].code, "too_many_samples");
  EXPECT_NE(samples.warnings[0].text.find("2000"), std::string::npos);
  EXPECT_TRUE(samples.warnings[0].doubtsSolid);
  ASSERT_TRUE(samples.warnings[0].place);
  const Point place = *samples.warnings[0].place;
  EXPECT_NEAR((thinPlate().tree.nearest(place).point - place).norm(), 0, 1e-9);
}

/// This many samples would not fit into any memory.
TEST(BoundarySamples, AreNotMoreThanAllowedAtATinySpacing)
{
  SamplingOptions options;
  options.maximumSamples = 2000;
  for (const bool adaptive : { false, true })
  {
    options.adaptive = adaptive;
    options.spacing = 1e-7;
    const BoundarySamples samples = thinPlate().samples(options);
    EXPECT_LE(samples.points.size(), 2000);
    EXPECT_GT(samples.points.size(), 1000);
    ASSERT_EQ(samples.warnings.size(), 1);
    EXPECT_EQ(samples.warnings[0].code, "too_many_samples");
  }
}

TEST(BoundarySamples, RefuseASurfaceThatIsTooNarrow)
{
  for (const double tip : { -1e9, -1e11 })
  {
    meshes::Mesh mesh = meshes::box(Point::Zero(), Point(1, 1, 1));
    mesh.points[0].x() = tip;
    const Solid needle(mesh);
    try
    {
      needle.samples({});
      FAIL() << tip;
    }
    catch (const medial::InvalidInput& refused)
    {
      EXPECT_NE(std::string(refused.what()).find("too narrow"), std::string::npos)
        << refused.what();
    }
  }
}

TEST(BoundarySamples, AreEnoughOfASurfaceWithFewPoints)
{
  const Solid box(meshes::box(Point::Zero(), Point(1, 2, 3)));
  const BoundarySamples samples = box.samples({});
  EXPECT_GT(samples.points.size(), 15000);
  EXPECT_LT(samples.points.size(), 21000);
}

/// A wedge is as thin as one likes at its edge, but needs no more samples than a box, where these are enough.
TEST(BoundarySamples, AreNotDenserAtTheEdgeOfAWedge)
{
  const Solid wedge(meshes::wedge(30));
  BoundarySampler sampler(wedge.surface, wedge.tree, {});
  const BoundarySamples pairs = sampler.samples();
  EXPECT_GT(pairs.points.size(), 15000);
  EXPECT_LT(pairs.points.size(), 25000);
  const Point atEdge(0.01, 0, 0.5);
  const Point elsewhere = wedge.tree.nearest(Point(1, 0.2, 0.5)).point;
  sampler.refine({ elsewhere });
  EXPECT_EQ(near(sampler.samples(), atEdge, 0.03), near(pairs, atEdge, 0.03));
  sampler.refine(std::vector<Point>(200, elsewhere)); // so many places: pairs are not enough
  EXPECT_GT(near(sampler.samples(), atEdge, 0.03), 2 * near(pairs, atEdge, 0.03)); // as in a wall
}

void expectRefusal(const SamplingOptions& options, const std::string& says)
{
  try
  {
    thinPlate().samples(options);
    ADD_FAILURE() << "not refused: " << says;
  }
  catch (const medial::InvalidInput& error)
  {
    EXPECT_NE(std::string(error.what()).find(says), std::string::npos) << error.what();
  }
}

TEST(BoundarySamples, RefuseOptionsOutOfRange)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double fineness : { 0.0, -1.0, 1.1, nan })
  {
    SamplingOptions options;
    options.fineness = fineness;
    expectRefusal(options, "the fineness must be above 0 and at most 1");
  }
  for (const double spacing : { -1.0, std::numeric_limits<double>::infinity(), nan })
  {
    SamplingOptions options;
    options.spacing = spacing;
    expectRefusal(options, "the spacing must be 0 or more");
  }
  for (const double sharp : { 0.0, -30.0, 181.0, nan })
  {
    SamplingOptions options;
    options.sharpAngle = sharp;
    expectRefusal(options, "the sharp angle must be above 0 and at most 180 degrees");
  }
  SamplingOptions options;
  options.maximumSamples = 3;
  expectRefusal(options, "room for 4 samples, not 3");
}

TEST(BoundarySamples, AreTwiceAsCloseWhereRefined)
{
  const Solid torus(meshes::torus());
  BoundarySampler sampler(torus.surface, torus.tree, coarse());
  const Point place = torus.tree.nearest(Point(2.7, 0, 0)).point;
  const auto spacing = [&] {
    const BoundarySamples samples = sampler.samples();
    double least = 1;
    for (const double s : samples.spacings)
    {
      least = std::min(least, s);
    }
    return std::make_pair(least, near(samples, place, 0.3));
  };
  const auto [before, fewer] = spacing();
  sampler.refine({ place });
  const auto [after, more] = spacing();
  EXPECT_LT(after, 0.75 * before); // at the sample that is nearest to the place
  EXPECT_GE(after, 0.5 * before);
  EXPECT_GT(more, fewer);
  EXPECT_EQ(near(sampler.samples(), Point(-2.7, 0, 0), 0.3),
    near(torus.samples(coarse()), Point(-2.7, 0, 0), 0.3));
}

TEST(BoundarySamples, AreAddedOnBothWallsNextToAPlace)
{
  const Solid& plate = thinPlate();
  SamplingOptions options = coarse();
  options.adaptive = false; // far more than a wall is thick
  const BoundarySampler sampler(plate.surface, plate.tree, options);
  BoundarySamples samples = sampler.samples();
  const Index before = medial::count(samples.points);
  std::vector<Point> places;
  for (int i = 1; i < 39; ++i)
  {
    places.emplace_back(0.1 * i, 0.5, 0.03); // within, nearer to the upper wall
  }
  const auto addedAt = [&sampler, &samples](const std::vector<Point>& at) {
    const std::vector<Point> present = medial::positions(samples.points);
    const medial::Neighbors known(present);
    return sampler.add(at, samples, 0.2, medial::MoreNeighbors(known, present));
  };
  const Index added = addedAt(places);
  EXPECT_GT(added, 10);
  EXPECT_EQ(medial::count(samples.points), before + added);
  EXPECT_EQ(samples.spacings.size(), samples.points.size());
  for (const Point& place : places)
  {
    for (const double z : { 0.0, 0.04 })
    {
      const Point foot(place.x(), place.y(), z);
      EXPECT_GE(near(samples, foot, 0.3 * options.spacing), 1) << foot.transpose();
    }
  }
  for (Index i = before; i < medial::count(samples.points); ++i)
  {
    EXPECT_EQ(plate.tree.distance(samples.points[i].position, samples.points[i].triangle), 0);
    EXPECT_LE(near(samples, samples.points[i].position, 0.999 * 0.2 * options.spacing), 1);
  }
  EXPECT_EQ(addedAt(places), 0);
}

TEST(BoundarySamples, KnowWhatIsAtASharpEdge)
{
  const Solid cube(meshes::box(Point::Zero(), Point::Ones()));
  const BoundarySampler sampler(cube.surface, cube.tree, coarse());
  EXPECT_TRUE(sampler.isAtSharpEdge({ 0.5, 0.02, 0.02 }, 0.03));
  EXPECT_FALSE(sampler.isAtSharpEdge({ 0.5, 0.5, 0 }, 0.49));
  const Solid torus(meshes::torus());
  EXPECT_FALSE(
    BoundarySampler(torus.surface, torus.tree, coarse()).isAtSharpEdge({ 2.7, 0, 0 }, 1));
}

TEST(BoundarySamples, AreTheSameInEachRunAndForAnyThreads)
{
  const Solid plate(meshes::drilledPlate(0.2));
  const std::vector<Point> samples = positions(plate.samples(coarse()));
  EXPECT_EQ(positions(plate.samples(coarse())), samples);
  EXPECT_EQ(positions(plate.samples(coarse(), pipelines::threaded())), samples);
}

TEST(BoundarySamples, CanBeStopped)
{
  const Solid plate(meshes::drilledPlate(0.2));
  pipelines::expectProgressAndAbort(
    [&plate](const medial::Execution& execution) { plate.samples(coarse(), execution); });
}
}
