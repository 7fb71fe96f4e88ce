// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/GapFilling.h"
#include "Pipelines.h"

#include "Axis/PieceRepair.h"
#include "Base/Frame.h"

#include <algorithm>
#include <cstdlib>

using medial::Betti;
using medial::FilledGaps;
using medial::Index;
using medial::None;
using medial::OpenSet;
using medial::Point;
using medial::SiteTriangulation;

namespace
{
/// What the axis of some samples begins with.
struct Start
{
  explicit Start(const std::vector<Point>& samples)
    : balls(medial::polarBalls(samples))
    , shape(medial::powerShape(balls))
    , sites(medial::siteTriangulation(
        balls, shape, medial::singularPoints(balls, shape), medial::frameOf(samples)))
    , pieces(medial::piecesOfBalls(balls))
  {
  }

  /// Fills gaps and checks what must hold in any case.
  Betti fill(double kappa, const Betti& target) const
  {
    const OpenSet before = medial::insideCells(this->sites, kappa);
    const Betti first = medial::bettiNumbers(this->sites, before);
    OpenSet set = before;
    const FilledGaps gaps = medial::fillGaps(this->sites, this->pieces, target, set);
    EXPECT_EQ(gaps.betti, medial::bettiNumbers(this->sites, set));
    EXPECT_EQ(gaps.places == 0, gaps.betti == first);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_EQ(std::abs(first[i] - gaps.betti[i]) + std::abs(gaps.betti[i] - target[i]),
        std::abs(first[i] - target[i]));
    }
    EXPECT_TRUE(std::equal(before.cells.begin(), before.cells.end(), set.cells.begin(),
      [](char was, char is) { return !was || is; }));
    return gaps.betti;
  }

  medial::PolarBalls balls;
  medial::PowerShape shape;
  SiteTriangulation sites;
  std::vector<Index> pieces;
};

std::vector<shapes::Shape> sparseShapes(unsigned seed)
{
  return { shapes::twoHolePlate(0.25, seed), shapes::twoHolePlate(0.3, seed),
    shapes::torus(0.55, seed), shapes::box(0.35, seed), shapes::hollowSphere(0.3, seed) };
}
}

TEST(GapFilling, GivesSparseSamplesTheTopologyOfTheirPowerShape)
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    for (const shapes::Shape& shape : sparseShapes(seed))
    {
      const Start start(shape.samples);
      SCOPED_TRACE(testing::Message() << shape.name << ", seed " << seed);
      EXPECT_EQ(start.fill(0.2, start.shape.betti), start.shape.betti);
    }
  }
}

TEST(GapFilling, KeepsCountInClouds)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Start start(shapes::cloud(150, seed));
    start.fill(0.2, start.shape.betti);
    start.fill(2, start.shape.betti);
    start.fill(0.2, { 1, 0, 0 });
    start.fill(0.2, { 1, 3, 2 });
  }
}

TEST(GapFilling, FillsATunnelOrAVoidIfTold)
{
  EXPECT_EQ(Start(shapes::torus(0.3).samples).fill(0.2, { 1, 0, 0 }), (Betti{ 1, 0, 0 }));
  EXPECT_EQ(Start(shapes::hollowSphere(0.25).samples).fill(0.2, { 1, 0, 0 }), (Betti{ 1, 0, 0 }));
}

TEST(GapFilling, MakesNoTunnel)
{
  EXPECT_EQ(Start(shapes::capsule(0.3).samples).fill(0.2, { 1, 1, 0 }), (Betti{ 1, 0, 0 }));
}

TEST(GapFilling, LeavesWhatIsRightAsItIs)
{
  const Start start(shapes::torus(0.3).samples);
  OpenSet set = medial::insideCells(start.sites, 0.2);
  const std::vector<char> before = set.cells;
  medial::fillGaps(start.sites, start.pieces, { 1, 1, 0 }, set);
  EXPECT_EQ(set.cells, before);
}

TEST(GapFilling, DoesNotJoinPiecesOfTheSolid)
{
  std::vector<Point> samples = shapes::sphere(0.3).samples;
  for (const Point& p : shapes::moved(samples, Point(2.2, 0, 0)))
  {
    samples.push_back(p);
  }
  Start start(samples);
  ASSERT_EQ(start.shape.betti, (Betti{ 2, 0, 0 }));
  EXPECT_EQ(start.fill(0.2, { 1, 0, 0 }), (Betti{ 2, 0, 0 }));
  for (Index& piece : start.pieces)
  {
    piece = piece == None ? None : 0;
  }
  EXPECT_EQ(start.fill(0.2, { 1, 0, 0 }), (Betti{ 1, 0, 0 }));
}

TEST(GapFilling, Stops)
{
  const Start start(shapes::twoHolePlate(0.15).samples);
  medial::Execution execution;
  execution.progress = [](double) { return false; };
  OpenSet set = medial::insideCells(start.sites, 0.2);
  EXPECT_THROW(
    medial::fillGaps(start.sites, start.pieces, { 1, 0, 0 }, set, execution), medial::Aborted);
}
