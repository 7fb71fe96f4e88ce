// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/ProvenSamples.h"

#include "Balls/Crossings.h"
#include "Balls/FarFaces.h"
#include "Balls/PolarBalls.h"
#include "Executions.h"
#include "Meshes.h"
#include "Pipelines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace
{
using medial::Betti;
using medial::ClosedSurface;
using medial::Index;
using medial::Point;
using medial::PolarBallsAndSamples;
using medial::ProvenSamples;
using medial::SamplingOptions;
using medial::Side;
using medial::SurfaceTree;
using meshes::Mesh;

/// A closed surface with its tree.
struct Solid
{
  explicit Solid(const Mesh& mesh)
    : surface(medial::closedSurface(mesh.points, mesh.polygons))
    , tree(surface.points, surface.triangles)
  {
  }

  ProvenSamples samples(
    const SamplingOptions& options, Index rounds, const medial::Execution& execution = {}) const
  {
    return medial::provenSamples(this->surface, this->tree, options, rounds, execution);
  }

  PolarBallsAndSamples balls(const ProvenSamples& made) const
  {
    std::vector<Point> positions;
    for (const medial::SurfacePoint& sample : made.samples.points)
    {
      positions.push_back(sample.position);
    }
    return medial::polarBallsAndSamples(positions, {}, {}, &this->tree);
  }

  ClosedSurface surface;
  SurfaceTree tree;
};

SamplingOptions withSpacing(double spacing, bool adaptive = true)
{
  SamplingOptions options;
  options.spacing = spacing;
  options.adaptive = adaptive;
  return options;
}

Mesh twoBoxes(double gap)
{
  const Mesh cube = meshes::box(Point::Zero(), Point::Ones());
  return meshes::united(cube, meshes::moved(cube, Point(1 + gap, 0, 0)));
}

void expectProven(const Mesh& mesh, double spacing, const Betti& betti)
{
  const Solid solid(mesh);
  const ProvenSamples made = solid.samples(withSpacing(spacing), 4);
  EXPECT_TRUE(made.warnings.empty()) << made.warnings.front().text;
  EXPECT_EQ(solid.surface.measures.betti, betti);
  EXPECT_EQ(solid.balls(made).powerShape, betti);
}

TEST(ProvenSamples, GiveTheSolidsTopology)
{
  expectProven(meshes::box(Point::Zero(), Point(3, 2, 1)), 0.1, { 1, 0, 0 });
  expectProven(meshes::torus(), 0.2, { 1, 1, 0 });
  expectProven(meshes::iBeam(4), 0.2, { 1, 0, 0 });
  expectProven(
    meshes::united(meshes::sphere(), meshes::reversed(meshes::sphere(0.5))), 0.15, { 1, 0, 1 });
}

TEST(ProvenSamples, GiveTheTopologyOfThinWallsAndGaps)
{
  expectProven(meshes::drilledPlate(0.12), 0.2, { 1, 1, 0 });
  expectProven(twoBoxes(0.02), 0.1, { 2, 0, 0 }); // a hundredth of the diagonal
}

/// Of most of them, and with few samples; where it isn't right, that is said.
TEST(ProvenSamples, GiveTheTopologyOfNarrowWedges)
{
  int right = 0, all = 0;
  for (double degrees = 3.5; degrees < 60; degrees += 3.7)
  {
    const Solid wedge(meshes::wedge(degrees));
    const ProvenSamples made = wedge.samples(withSpacing(0.04), 1);
    EXPECT_LT(made.samples.points.size(), 4000) << degrees;
    EXPECT_EQ(wedge.balls(made).powerShape == wedge.surface.measures.betti, made.warnings.empty())
      << degrees;
    right += made.warnings.empty();
    ++all;
  }
  EXPECT_GE(right, 0.85 * all); // measured: more than 19 of 20
}

/// A crack so narrow that only samples much closer than all others would tell its walls apart. They would not get along
/// with the others, and the crack makes no difference to the topology.
TEST(ProvenSamples, DontFollowACrackThatTheyCantResolve)
{
  const double spacing = 0.1;
  const Solid whole(meshes::box(Point::Zero(), Point(2, 2, 2)));
  const std::size_t usual = whole.samples(withSpacing(spacing), 0).samples.points.size();
  for (const double width : { 0.01, 0.003, 0.001 })
  {
    SCOPED_TRACE(testing::Message() << "width " << width);
    const Solid cracked(meshes::blocks({ 0, 1, 1 + width, 2 }, { 0, 1.7, 2 }, { 0, 1.7, 2 },
      [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; }));
    const ProvenSamples made = cracked.samples(withSpacing(spacing), 4);
    // Nothing but that some samples may come in pairs across it; the widest one is followed up to its corners.
    EXPECT_LE(made.warnings.size(), 1);
    EXPECT_TRUE(made.warnings.empty() ||
      made.warnings[0].code == (width > 0.005 ? "far_surface" : "paired_walls"));
    EXPECT_EQ(made.balls.powerShape, (Betti{ 1, 0, 0 }));
    EXPECT_EQ(made.samples.points.size() > 2 * usual, width > 0.005);
    EXPECT_TRUE(width > 0.005 || made.samples.points.size() < 1.1 * usual);
  }
}

/// Samples that are spread by area alone would miss them, or come too few on them.
TEST(ProvenSamples, ShowGrainsAndPoresHoweverSmall)
{
  for (const double radius : { 1e-2, 1e-3, 1e-4, 1e-5 })
  {
    SCOPED_TRACE(testing::Message() << "radius " << radius);
    const Mesh grain = meshes::moved(meshes::sphere(radius, 8), Point(1.5, 0, 0));
    const Mesh pore = meshes::moved(meshes::reversed(meshes::sphere(radius, 8)), Point(0.3, 0, 0));
    const Solid solid(meshes::united(meshes::united(meshes::sphere(), grain), pore));
    const ProvenSamples made = solid.samples(withSpacing(0.2), 0);
    EXPECT_EQ(made.balls.powerShape, (Betti{ 2, 0, 1 }));
    EXPECT_EQ(solid.balls(made).powerShape, (Betti{ 2, 0, 1 })); // as vtkPolarBalls makes them
    EXPECT_LT(made.samples.points.size(), 700); // 0.7 for each square: 220 without the two
  }
}

TEST(ProvenSamples, SayWhichPiecesHaveTooFew)
{
  const Point place(1.5, 0, 0);
  const Mesh grain = meshes::moved(meshes::sphere(1e-3, 8), place);
  const Solid solid(meshes::united(meshes::sphere(), grain));
  const ProvenSamples made = solid.samples(withSpacing(0.2, false), 2);
  ASSERT_EQ(made.warnings.size(), 2);
  EXPECT_EQ(made.warnings[0].code, "missed_details");
  EXPECT_FALSE(made.warnings[0].doubtsSolid);
  EXPECT_EQ(made.warnings[1].code, "too_few_samples");
  for (const medial::Warning& warning : made.warnings)
  {
    ASSERT_TRUE(warning.place);
    EXPECT_LT((*warning.place - place).norm(), 2e-3) << warning.text;
  }
}

/// A spike of 2, on a sphere of 1, with a hundredth of its area.
TEST(ProvenSamples, ReachTheTipsOfSpikes)
{
  Mesh spiky = meshes::sphere(1, 200);
  const auto pole = std::max_element(spiky.points.begin(), spiky.points.end(),
    [](const Point& p, const Point& q) { return p.z() < q.z(); });
  const Point tip(0, 0, 3);
  *pole = tip;
  const Solid solid(spiky);
  const ProvenSamples made = solid.samples(withSpacing(0.4), 4);
  EXPECT_EQ(made.balls.powerShape, (Betti{ 1, 0, 0 }));
  double nearest = 3;
  for (const medial::SurfacePoint& sample : made.samples.points)
  {
    nearest = std::min(nearest, (sample.position - tip).norm());
  }
  EXPECT_LT(nearest, 0.2);
}

/// The handle is much smaller than the spacing around it.
TEST(ProvenSamples, GiveTheTopologyOfASmallHandle)
{
  const Solid handle(meshes::blocks({ 0, 0.5, 0.51, 0.52, 0.53, 1 }, { 0, 0.5, 0.51, 1 },
    { 0, 1, 1.01, 1.02 }, [](int i, int j, int k) {
      const bool isFoot = k == 1 && (i == 1 || i == 3);
      const bool isArch = k == 2 && 1 <= i && i <= 3;
      return k == 0 || (j == 1 && (isFoot || isArch));
    }));
  ASSERT_EQ(handle.surface.measures.betti, (Betti{ 1, 1, 0 }));
  const ProvenSamples made = handle.samples(withSpacing(0.2), 4);
  EXPECT_EQ(made.balls.powerShape, (Betti{ 1, 1, 0 }));
}

/// Sheet metal: a thousandth as thick as it is wide. In pairs across it few samples are enough, and the surface is exact.
TEST(ProvenSamples, AreFewOnAWideThinPlate)
{
  for (const double thickness : { 0.004, 0.0025 })
  {
    SCOPED_TRACE(testing::Message() << "thickness " << thickness);
    const Solid plate(meshes::drilledPlate(thickness));
    const ProvenSamples made = plate.samples(withSpacing(0.1), 4);
    ASSERT_EQ(made.warnings.size(), 1);
    EXPECT_EQ(made.warnings[0].code, "paired_walls");
    EXPECT_FALSE(made.warnings[0].doubtsSolid);
    EXPECT_EQ(made.rounds, 0);
    EXPECT_EQ(made.balls.powerShape, (Betti{ 1, 1, 0 }));
    EXPECT_LT(made.samples.points.size(), 3500); // 0.7 for each square of the spacing: 2100
  }
  const Solid foil(meshes::drilledPlate(1e-5));
  const ProvenSamples made = foil.samples(withSpacing(0.1), 1);
  EXPECT_TRUE(std::any_of(made.warnings.begin(), made.warnings.end(),
    [](const medial::Warning& warning) { return warning.code == "too_few_samples"; }));
}

TEST(ProvenSamples, BecomeDenserUntilTheyAreEnough)
{
  const Solid plate(meshes::drilledPlate(0.3));
  const ProvenSamples made = plate.samples(withSpacing(0.5, false), 6);
  EXPECT_GT(made.rounds, 0);
  EXPECT_LE(made.rounds, 6);
  EXPECT_TRUE(made.warnings.empty()) << made.warnings.front().text;
  EXPECT_EQ(plate.balls(made).powerShape, plate.surface.measures.betti);
}

/// The next round would make much the same samples, for minutes where a million are allowed.
TEST(ProvenSamples, AreNotMadeAgainWhereThereIsNoRoomForMore)
{
  const Solid plate(meshes::drilledPlate(0.02));
  SamplingOptions options = withSpacing(0.1);
  options.maximumSamples = 2000;
  const ProvenSamples made = plate.samples(options, 4);
  EXPECT_EQ(made.rounds, 0);
  ASSERT_EQ(made.warnings.size(), 2);
  EXPECT_EQ(made.warnings[0].code, "too_many_samples");
  EXPECT_EQ(made.warnings[1].code, "too_few_samples");
}

TEST(ProvenSamples, SayWhereTheyAreNotEnough)
{
  const Solid plate(meshes::drilledPlate(0.02));
  const ProvenSamples made = plate.samples(withSpacing(0.5, false), 1);
  EXPECT_EQ(made.rounds, 1);
  ASSERT_EQ(made.warnings.size(), 1);
  EXPECT_EQ(made.warnings[0].code, "too_few_samples");
  EXPECT_TRUE(made.warnings[0].doubtsSolid);
  EXPECT_NE(
    made.warnings[0].text.find("but the surface has 1 piece, 1 tunnel, 0 voids"), std::string::npos)
    << made.warnings[0].text;
  ASSERT_TRUE(made.warnings[0].place);
  const Point place = *made.warnings[0].place;
  EXPECT_NEAR((plate.tree.nearest(place).point - place).norm(), 0, 1e-9);
}

/// So that nobody has to make them again.
TEST(ProvenSamples, ComeWithTheirBalls)
{
  const Solid boxes(twoBoxes(0.3));
  SamplingOptions options = withSpacing(0.15, false);
  options.sharpAngle = 180;
  for (const Index rounds : { 0, 4 }) // 4: some samples are added, see below
  {
    const ProvenSamples made = boxes.samples(options, rounds);
    EXPECT_EQ(pipelines::bytesOf(made.balls), pipelines::bytesOf(boxes.balls(made)));
  }
}

TEST(ProvenSamples, AreNotCheckedInNoRounds)
{
  const Solid plate(meshes::drilledPlate(0.02));
  const ProvenSamples made = plate.samples(withSpacing(0.5, false), 0);
  EXPECT_EQ(made.rounds, 0);
  EXPECT_TRUE(made.warnings.empty());
}

TEST(ProvenSamples, CanBeStopped)
{
  const Solid torus(meshes::torus());
  pipelines::expectProgressAndAbort([&torus](const medial::Execution& execution) {
    torus.samples(withSpacing(0.3), 2, execution);
  });
}

/// Where the surface tells the sides.
TEST(PolarBallsInASolid, AreInnerWhereTheirCentreIs)
{
  const Solid plate(meshes::drilledPlate(0.3));
  const PolarBallsAndSamples made = plate.balls(plate.samples(withSpacing(0.1), 0));
  for (std::size_t b = 0; b < made.balls.balls.size(); ++b)
  {
    const bool inside = plate.tree.encloses(made.balls.balls[b].center);
    if (made.balls.sides[b] != Side::Hidden)
    {
      EXPECT_EQ(made.balls.sides[b] == Side::Inner, inside);
    }
  }
  EXPECT_TRUE(made.samples.warnings.empty());
}

/// Without pairs along the edges of two boxes, one face spans from wall to wall, though the topology is right.
TEST(ProvenSamples, HaveTheirCrustNearTheSurface)
{
  const Solid boxes(twoBoxes(0.3));
  SamplingOptions options = withSpacing(0.15, false);
  options.sharpAngle = 180;
  const auto farOf = [&](const ProvenSamples& made) {
    return medial::farFaces(boxes.balls(made).balls, made.samples.points, boxes.tree, 0.5);
  };
  const ProvenSamples made = boxes.samples(options, 4);
  EXPECT_EQ(made.rounds, 0);
  EXPECT_GT(made.added, 0);
  EXPECT_EQ(made.samples.spacings.size(), made.samples.points.size());
  EXPECT_FALSE(farOf(boxes.samples(options, 0)).empty());
  EXPECT_TRUE(farOf(made).empty());
}

/// Of wedges without pairs along their edges and with few samples, which show nothing of the edges.
TEST(ProvenSamples, TellWhereTheirCrustStaysFarFromTheSurface)
{
  int told = 0;
  for (double degrees = 12; degrees < 60; degrees += 2)
  {
    SCOPED_TRACE(testing::Message() << degrees << " degrees");
    const Solid wedge(meshes::wedge(degrees));
    SamplingOptions options = withSpacing(0.3, false);
    options.sharpAngle = 180;
    const ProvenSamples made = wedge.samples(options, 4);
    const PolarBallsAndSamples balls = wedge.balls(made);
    ASSERT_EQ(balls.powerShape, wedge.surface.measures.betti);
    const auto far = medial::farFaces(balls.balls, made.samples.points, wedge.tree, 0.5);
    ASSERT_EQ(made.warnings.size(), far.empty() ? 0 : 1);
    if (!far.empty())
    {
      ++told;
      EXPECT_EQ(made.warnings[0].code, "far_surface");
      EXPECT_FALSE(made.warnings[0].doubtsSolid);
      EXPECT_EQ(made.warnings[0].count, medial::count(far));
      EXPECT_TRUE(std::any_of(far.begin(), far.end(),
        [&](const medial::FarFace& face) { return face.place == made.warnings[0].place; }));
    }
  }
  EXPECT_GT(told, 0);
}

TEST(FarFaces, AreWhereSamplesAreTooFarApart)
{
  const Solid fine(meshes::torus());
  const ProvenSamples enough = fine.samples(withSpacing(0.15), 0);
  EXPECT_TRUE(
    medial::farFaces(fine.balls(enough).balls, enough.samples.points, fine.tree, 0.5).empty());
  const Solid boxes(twoBoxes(0.1));
  const ProvenSamples tooFew = boxes.samples(withSpacing(0.4, false), 0);
  const PolarBallsAndSamples made = boxes.balls(tooFew);
  const auto found = medial::farFaces(made.balls, tooFew.samples.points, boxes.tree, 0.2);
  const auto again =
    medial::farFaces(made.balls, tooFew.samples.points, boxes.tree, 0.2, {}, pipelines::threaded());
  ASSERT_FALSE(found.empty());
  ASSERT_EQ(again.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    EXPECT_GT(found[i].distance, 0.2);
    EXPECT_EQ(again[i].place, found[i].place);
  }
}

TEST(Crossings, AreOnTheSurfaceWhereSamplesAreTooFarApart)
{
  const Solid fine(meshes::torus());
  const PolarBallsAndSamples enough = fine.balls(fine.samples(withSpacing(0.15), 0));
  EXPECT_TRUE(medial::crossings(enough.balls, fine.tree).empty());
  const Solid plate(meshes::drilledPlate(0.02));
  const PolarBallsAndSamples tooFew = plate.balls(plate.samples(withSpacing(0.4, false), 0));
  const std::vector<medial::Crossing> found = medial::crossings(tooFew.balls, plate.tree);
  const std::vector<medial::Crossing> again =
    medial::crossings(tooFew.balls, plate.tree, pipelines::threaded());
  ASSERT_FALSE(found.empty());
  ASSERT_EQ(again.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const Point& place = found[i].place;
    EXPECT_NEAR((plate.tree.nearest(place).point - place).norm(), 0, 1e-9);
    EXPECT_EQ(again[i].place, place);
    EXPECT_EQ(again[i].smaller, found[i].smaller);
  }
}
}
