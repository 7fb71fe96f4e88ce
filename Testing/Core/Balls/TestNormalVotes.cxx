// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/NormalVotes.h"

#include "Balls/PolarBalls.h"
#include "Base/Errors.h"
#include "Meshes.h"
#include "Samples/BoundarySamples.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace
{
using medial::Index;
using medial::Point;
using medial::PolarBallsAndSamples;
using medial::Side;
using medial::SurfaceTree;
using medial::Warning;
using meshes::Mesh;

/// Samples of a solid with normals, and which of their balls are inside.
struct Scan
{
  Scan(const Mesh& mesh, double spacing)
    : surface(medial::closedSurface(mesh.points, mesh.polygons))
    , tree(surface.points, surface.triangles)
  {
    medial::SamplingOptions options;
    options.spacing = spacing;
    options.adaptive = false;
    const medial::BoundarySampler sampler(this->surface, this->tree, options);
    for (const medial::SurfacePoint& sample : sampler.samples().points)
    {
      this->places.push_back(sample.position);
      this->normals.push_back(sample.normal);
    }
  }

  PolarBallsAndSamples balls(const std::vector<Point>& given) const
  {
    return medial::polarBallsAndSamples(this->places, {}, {}, nullptr, given);
  }

  /// How many balls are not on the side on which the surface has their centre.
  Index wrong(const PolarBallsAndSamples& made) const
  {
    const std::vector<Side> right =
      medial::polarBallsAndSamples(this->places, {}, {}, &this->tree).balls.sides;
    Index result = 0;
    for (std::size_t b = 0; b < right.size(); ++b)
    {
      result += made.balls.sides[b] != right[b] ? 1 : 0;
    }
    return result;
  }

  medial::ClosedSurface surface;
  SurfaceTree tree;
  std::vector<Point> places, normals;
};

Mesh twoSheets(double gap)
{
  const Mesh sheet = meshes::box(Point::Zero(), Point(4, 4, 1));
  return meshes::united(sheet, meshes::moved(sheet, Point(0, 0, 1 + gap)));
}

std::vector<std::string> codes(const PolarBallsAndSamples& made)
{
  std::vector<std::string> result;
  for (const Warning& warning : made.samples.warnings)
  {
    if (warning.code.find("normals") != std::string::npos)
    {
      result.push_back(warning.code);
    }
  }
  return result;
}

std::vector<Point> turned(std::vector<Point> normals, std::size_t begin, std::size_t end)
{
  std::transform(normals.begin() + begin, normals.begin() + end, normals.begin() + begin,
    [](const Point& normal) -> Point { return -normal; });
  return normals;
}

using Codes = std::vector<std::string>;

TEST(NormalVotes, AreRightWhereBallsAloneMislead)
{
  // Walls and gaps about as thick as the samples are apart.
  Index without = 0;
  for (const double spacing : { 0.12, 0.14, 0.16 })
  {
    for (const Mesh& mesh : { meshes::drilledPlate(0.12),
           meshes::box(Point::Zero(), Point(4, 4, 0.12)), twoSheets(0.16) })
    {
      const Scan scan(mesh, spacing);
      without += scan.wrong(scan.balls({}));
      EXPECT_EQ(scan.wrong(scan.balls(scan.normals)), 0) << spacing;
    }
  }
  EXPECT_GT(without, 0);
}

TEST(NormalVotes, ChangeNothingWhereTheBallsAreRight)
{
  const Scan torus(meshes::torus(), 0.2);
  const PolarBallsAndSamples made = torus.balls(torus.normals);
  EXPECT_EQ(made.balls.sides, torus.balls({}).balls.sides);
  EXPECT_EQ(codes(made), Codes());
  EXPECT_EQ(torus.wrong(made), 0);
}

TEST(NormalVotes, DependOnDirectionsOnly)
{
  const Scan plate(meshes::drilledPlate(0.12), 0.15);
  std::vector<Point> long_ = plate.normals;
  for (std::size_t i = 0; i < long_.size(); ++i)
  {
    long_[i] *= i % 3 == 0 ? 1e-310 : i % 3 == 1 ? 1e300 : 3;
  }
  EXPECT_EQ(plate.balls(long_).balls.sides, plate.balls(plate.normals).balls.sides);
}

TEST(NormalVotes, AreTurnedWherePointingInwardsEverywhere)
{
  const Scan torus(meshes::torus(), 0.2);
  EXPECT_EQ(codes(torus.balls(turned(torus.normals, 0, torus.normals.size()))),
    Codes({ "inverted_normals" }));
  const Scan plate(meshes::drilledPlate(0.12), 0.15);
  EXPECT_EQ(plate.balls(turned(plate.normals, 0, plate.normals.size())).balls.sides,
    plate.balls(plate.normals).balls.sides);
}

TEST(NormalVotes, AreNotUsedWithoutACommonOrientation)
{
  const Scan torus(meshes::torus(), 0.2);
  const PolarBallsAndSamples made = torus.balls(turned(torus.normals, 0, torus.normals.size() / 3));
  EXPECT_EQ(made.balls.sides, torus.balls({}).balls.sides);
  EXPECT_EQ(codes(made), Codes({ "unoriented_normals" }));
}

TEST(NormalVotes, AreDoubtedWhereSomeContradictOthers)
{
  const Scan torus(meshes::torus(), 0.2);
  std::vector<Point> normals = torus.normals;
  for (std::size_t i = 0; i < normals.size(); i += 16)
  {
    normals[i] *= -1;
  }
  const PolarBallsAndSamples made = torus.balls(normals);
  EXPECT_EQ(codes(made), Codes({ "contradicting_normals" }));
  const auto contradicting =
    std::find_if(made.samples.warnings.begin(), made.samples.warnings.end(),
      [](const Warning& warning) { return warning.code == "contradicting_normals"; });
  ASSERT_NE(contradicting, made.samples.warnings.end());
  EXPECT_GE(contradicting->count, static_cast<Index>(normals.size() / 16));
  ASSERT_TRUE(contradicting->place);
  EXPECT_NEAR(
    (torus.tree.nearest(*contradicting->place).point - *contradicting->place).norm(), 0, 1e-9);
}

/// Every other one is missing.
std::vector<Point> half(std::vector<Point> normals)
{
  for (std::size_t i = 0; i < normals.size(); i += 2)
  {
    normals[i] =
      i % 4 == 0 ? Point(Point::Zero()) : Point(std::numeric_limits<double>::quiet_NaN(), 0, 1);
  }
  return normals;
}

TEST(NormalVotes, AreLeftToOtherSamplesWhereThereIsNoNormal)
{
  const Scan torus(meshes::torus(), 0.2);
  EXPECT_EQ(codes(torus.balls(half(torus.normals))), Codes({ "unusable_normals" }));
  const Scan plate(meshes::drilledPlate(0.12), 0.15);
  const std::vector<Point> none(plate.normals.size(), Point::Zero());
  EXPECT_LT(plate.wrong(plate.balls(half(plate.normals))), plate.wrong(plate.balls(none)));
  EXPECT_EQ(plate.balls(none).balls.sides, plate.balls({}).balls.sides);
}

TEST(NormalVotes, AreSharedByRepeatedSamples)
{
  Scan plate(meshes::drilledPlate(0.12), 0.15);
  const std::vector<Side> once = plate.balls(plate.normals).balls.sides;
  for (std::size_t i = plate.places.size(); i-- > 0;)
  {
    plate.places.push_back(plate.places[i]);
    plate.normals.push_back(plate.normals[i]);
    plate.normals[i] = Point::Zero();
  }
  EXPECT_EQ(plate.balls(plate.normals).balls.sides, once);
}

TEST(NormalVotes, DoNotCountWhereTheSolidIsKnown)
{
  const Scan torus(meshes::torus(), 0.3);
  const PolarBallsAndSamples made = medial::polarBallsAndSamples(
    torus.places, {}, {}, &torus.tree, turned(torus.normals, 0, torus.normals.size() / 2));
  EXPECT_EQ(torus.wrong(made), 0);
  EXPECT_TRUE(made.samples.warnings.empty());
}

TEST(NormalVotes, NeedANormalForEachSample)
{
  const Scan torus(meshes::torus(), 0.5);
  EXPECT_THROW(torus.balls({ Point(0, 0, 1) }), medial::InvalidInput);
}
}
