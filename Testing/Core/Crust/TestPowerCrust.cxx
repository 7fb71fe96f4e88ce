// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Crust/PowerCrust.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

using medial::Betti;
using medial::Crust;
using medial::CrustOptions;
using medial::CrustRule;
using medial::Index;
using medial::None;
using medial::Point;
using medial::Side;
using pipelines::facesOf;
using pipelines::forEachShape;
using pipelines::keepBelow;
using pipelines::Pipeline;

namespace
{
/// For every shape: before pruning and after.
void forEachCrust(const std::function<void(Pipeline&, const Crust&)>& test)
{
  forEachShape([&](Pipeline& p) {
    {
      SCOPED_TRACE("before pruning");
      test(p, p.crust());
    }
    {
      SCOPED_TRACE("after pruning");
      test(p, p.crustAfterPruning());
    }
  });
}

std::vector<medial::Ball> balls(const medial::PolarBalls& all, const std::vector<char>& keep)
{
  std::vector<medial::Ball> result;
  for (std::size_t b = 0; b < all.balls.size(); ++b)
  {
    if (all.sides[b] == Side::Inner && (keep.empty() || keep[b]))
    {
      result.push_back(all.balls[b]);
    }
  }
  return result;
}

/// The largest distance of a point that is no sample to the union of the balls.
double largestClearance(const Crust& crust, const std::vector<medial::Ball>& kept)
{
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < crust.points.size(); ++i)
  {
    if (crust.sampleOfPoint[i] == None)
    {
      largest = std::max(largest, validators::clearance(crust.points[i], kept));
    }
  }
  return largest;
}

double power(const Point& place, const medial::Ball& ball)
{
  return (place - ball.center).squaredNorm() - ball.radius * ball.radius;
}

/// Distance to the plane in which two balls have the same power.
double distanceToFace(const Point& place, const medial::Ball& a, const medial::Ball& b)
{
  return std::abs(power(place, a) - power(place, b)) / (2 * (a.center - b.center).norm());
}
}

TEST(PowerCrust, IsClosed)
{
  forEachCrust([](Pipeline&, const Crust& crust) {
    EXPECT_TRUE(validators::isClosed(facesOf(crust)));
    EXPECT_TRUE(crust.closed);
  });
}

TEST(PowerCrust, IsOriented)
{
  forEachCrust(
    [](Pipeline&, const Crust& crust) { EXPECT_TRUE(validators::isOriented(facesOf(crust))); });
}

TEST(PowerCrust, IsATwoManifold)
{
  forEachCrust([](Pipeline&, const Crust& crust) {
    EXPECT_TRUE(validators::isTwoManifold(facesOf(crust)));
    EXPECT_TRUE(crust.manifold);
  });
}

TEST(PowerCrust, EnclosesTheTopologyOfTheSolid)
{
  forEachCrust([](Pipeline& p, const Crust& crust) {
    EXPECT_EQ(crust.betti, p.shape.betti);
    ASSERT_TRUE(
      validators::isTwoManifold(facesOf(crust)) && validators::isOriented(facesOf(crust)));
    EXPECT_EQ(validators::bettiOfSolid(crust.points, facesOf(crust)), p.shape.betti);
  });
}

TEST(PowerCrust, EnclosesTheVolumeItSays)
{
  forEachCrust([](Pipeline&, const Crust& crust) {
    EXPECT_NEAR(crust.volume / validators::enclosedVolume(crust.points, facesOf(crust)), 1, 1e-9);
  });
}

TEST(PowerCrust, EnclosesTheSolidsVolume)
{
  forEachShape([](Pipeline& p) {
    EXPECT_NEAR(p.crust().volume / p.shape.volume, 1, 0.05);
    EXPECT_LE(p.crustAfterPruning().volume, 1.001 * p.crust().volume);
    // Two ways to the same number: by the surface, and by the tetrahedra inside.
    const std::vector<double>& volumes = p.balls().volumes;
    const double tetrahedra = std::accumulate(volumes.begin(), volumes.end(), 0.0);
    EXPECT_NEAR(p.crust().volume / tetrahedra, 1, 0.05);
  });
}

TEST(PowerCrust, LosesTheVolumeThatWasPruned)
{
  forEachShape([](Pipeline& p) {
    double removed = 0;
    for (const medial::PruneRow& row : p.pruned().history)
    {
      removed += row.volumeRemoved;
    }
    const double lost = 1 - p.crustAfterPruning().volume / p.crust().volume;
    EXPECT_LE(lost, removed + 0.01);
    EXPECT_GE(lost, -0.001);
  });
}

TEST(PowerCrust, HasMostSamplesAsVertices)
{
  forEachShape([](Pipeline& p) {
    std::set<Index> samples(p.crust().sampleOfPoint.begin(), p.crust().sampleOfPoint.end());
    samples.erase(None);
    // At this density; of a sphere, one inner ball, only those with three outer balls.
    const double least = p.shape.name == "sphere" ? 0.4 : 0.7;
    EXPECT_GT(static_cast<double>(samples.size()) / p.shape.samples.size(), least);
  });
}

TEST(PowerCrust, PointsThatAreSamplesAreThere)
{
  forEachCrust([](Pipeline& p, const Crust& crust) {
    ASSERT_EQ(crust.sampleOfPoint.size(), crust.points.size());
    std::set<Index> seen;
    for (std::size_t i = 0; i < crust.points.size(); ++i)
    {
      const Index sample = crust.sampleOfPoint[i];
      if (sample != None)
      {
        ASSERT_EQ(crust.points[i], p.shape.samples[sample]);
        ASSERT_TRUE(seen.insert(sample).second) << "sample " << sample << " twice";
      }
    }
  });
}

TEST(PowerCrust, UsesEveryPointAndNoneTwiceInAFace)
{
  forEachCrust([](Pipeline&, const Crust& crust) {
    std::set<Index> used;
    for (Index f = 0; f < medial::count(crust.triangles); ++f)
    {
      const std::set<Index> corners(crust.triangles[f].begin(), crust.triangles[f].end());
      EXPECT_EQ(corners.size(), 3u);
      used.insert(corners.begin(), corners.end());
    }
    EXPECT_EQ(used.size(), crust.points.size());
  });
}

TEST(PowerCrust, LiesOnTheSolidsBoundary)
{
  forEachShape([](Pipeline& p) {
    double largest = 0;
    for (const Point& point : p.crust().points)
    {
      largest = std::max(largest, std::abs(p.shape.outside(point)));
    }
    EXPECT_LT(largest, (p.shape.smooth ? 0.7 : 1.5) * p.shape.spacing);
  });
}

TEST(PowerCrust, FacesLieBetweenAnInnerAndAnOuterBall)
{
  forEachCrust([](Pipeline& p, const Crust& crust) {
    const medial::PolarBalls& all = p.balls();
    ASSERT_EQ(crust.innerBall.size(), crust.triangles.size());
    ASSERT_EQ(crust.outerBall.size(), crust.triangles.size());
    for (Index f = 0; f < medial::count(crust.triangles); ++f)
    {
      const Index inner = crust.innerBall[f], outer = crust.outerBall[f];
      ASSERT_TRUE(inner != None && all.sides[inner] == Side::Inner);
      ASSERT_TRUE(outer == None ? crust.insertedBalls > 0 : all.sides[outer] == Side::Outer);
      for (const Index corner : crust.triangles[f])
      {
        if (outer != None)
        {
          const medial::Ball &i = all.balls[inner], &o = all.balls[outer];
          ASSERT_LT(distanceToFace(crust.points[corner], i, o), 1e-6 * p.diagonal);
        }
      }
    }
  });
}

TEST(PowerCrust, AfterPruningIsBehindKeptBallsOnly)
{
  forEachShape([](Pipeline& p) {
    const std::vector<char> keep = p.keptAfterPruning();
    for (const Index inner : p.crustAfterPruning().innerBall)
    {
      ASSERT_TRUE(keep[inner]);
    }
  });
}

TEST(PowerCrust, StatesItsLargestClearance)
{
  forEachCrust([](Pipeline& p, const Crust& crust) {
    const bool before = &crust == &p.crust();
    const std::vector<medial::Ball> kept =
      balls(p.balls(), before ? std::vector<char>{} : p.keptAfterPruning());
    const double largest = largestClearance(crust, kept) / p.balls().spacing;
    EXPECT_NEAR(crust.maximumClearance, std::max(largest, 0.0), 1e-6);
  });
}

// Vertices that pruning has not touched may be farther, as the corners of a sharp box are before it.
TEST(PowerCrust, StaysWithinOneSpacingOfTheKeptBallsOrWhereItWas)
{
  forEachShape([](Pipeline& p) {
    const std::vector<medial::Ball> kept = balls(p.balls(), p.keptAfterPruning());
    const double bound = std::max(1.0, p.crust().maximumClearance);
    EXPECT_LE(largestClearance(p.crustAfterPruning(), kept), (bound + 1e-6) * p.balls().spacing);
  });
}

TEST(PowerCrust, IsAsBeforeAwayFromRemovedBalls)
{
  Pipeline& p = pipelines::of("capsule");
  const Crust crust = medial::powerCrust(p.balls(), keepBelow(p.balls(), 0.3));
  const validators::NearestPoint nearest(crust.points);
  std::size_t away = 0;
  for (const Point& point : p.crust().points)
  {
    const bool isAway = point.x() < 0.3 - 0.5 - 3 * p.balls().spacing; // the radius is 0.5
    away += isAway;
    EXPECT_TRUE(!isAway || nearest.distance(point) < 1e-9);
  }
  EXPECT_GT(away, p.crust().points.size() / 4);
}

TEST(PowerCrust, StaysWithinTheClearanceAskedFor)
{
  Pipeline& p = pipelines::of("box");
  for (const double clearance : { 0.5, 2.0 })
  {
    SCOPED_TRACE(testing::Message() << "clearance " << clearance);
    CrustOptions options;
    options.clearance = clearance;
    const std::vector<char> keep = p.keptAfterPruning();
    const Crust crust = medial::powerCrust(p.balls(), keep, options);
    EXPECT_TRUE(validators::isTwoManifold(facesOf(crust)));
    EXPECT_LE(largestClearance(crust, balls(p.balls(), keep)) / p.balls().spacing,
      std::max(clearance, p.crust().maximumClearance) + 1e-6);
  }
}

TEST(PowerCrust, WithoutRefinementInsertsNothing)
{
  Pipeline& p = pipelines::of("box");
  for (const CrustRule rule : { CrustRule::InnerOnly, CrustRule::InnerAndOuter })
  {
    CrustOptions options;
    options.rule = rule;
    const Crust crust = medial::powerCrust(p.balls(), p.keptAfterPruning(), options);
    EXPECT_EQ(crust.insertedBalls, 0);
    EXPECT_EQ(crust.rounds, 0);
    EXPECT_TRUE(validators::isClosed(facesOf(crust)));
    EXPECT_TRUE(validators::isOriented(facesOf(crust)));
    EXPECT_EQ(std::count(crust.outerBall.begin(), crust.outerBall.end(), None), 0);
  }
}

TEST(PowerCrust, WithAllBallsKeptIsAsIfNothingHadBeenAsked)
{
  forEachShape([](Pipeline& p) {
    const std::vector<char> keep = pipelines::keptBalls(p.axis(), p.parts());
    EXPECT_EQ(
      pipelines::bytesOf(medial::powerCrust(p.balls(), keep)), pipelines::bytesOf(p.crust()));
  });
}

TEST(PowerCrust, CutsOffWhatIsRemoved)
{
  Pipeline& p = pipelines::of("capsule");
  const std::vector<char> keep = keepBelow(p.balls(), 0.3);
  const Crust crust = medial::powerCrust(p.balls(), keep);
  EXPECT_TRUE(validators::isTwoManifold(facesOf(crust)));
  EXPECT_EQ(crust.betti, (Betti{ 1, 0, 0 }));
  const std::vector<medial::Ball> kept = balls(p.balls(), keep);
  for (const Point& point : crust.points)
  {
    EXPECT_LT(point.x(), 0.3 + 0.5 + 3 * p.balls().spacing);
  }
  EXPECT_LE(largestClearance(crust, kept), (1 + 1e-6) * p.balls().spacing);
  // Untouched where all balls are kept.
  const validators::NearestPoint nearest(crust.points);
  for (const Point& sample : p.shape.samples)
  {
    if (sample.x() < -0.5)
    {
      EXPECT_LT(nearest.distance(sample), p.balls().spacing);
    }
  }
}

TEST(PowerCrust, OfATorusCutOpenHasNoTunnel)
{
  Pipeline& p = pipelines::of("torus");
  const Crust crust = medial::powerCrust(p.balls(), keepBelow(p.balls(), 1.2));
  EXPECT_TRUE(validators::isTwoManifold(facesOf(crust)));
  EXPECT_EQ(crust.betti, (Betti{ 1, 0, 0 }));
}

TEST(PowerCrust, HasTheTopologyOfThePrunedAxis)
{
  forEachShape([](Pipeline& p) {
    CrustOptions options;
    options.topology = p.pruned().axis.betti;
    const Crust crust = medial::powerCrust(p.balls(), p.keptAfterPruning(), options);
    EXPECT_EQ(crust.betti, p.pruned().axis.betti);
    EXPECT_EQ(crust.refusedBalls, 0);
    EXPECT_TRUE(validators::isTwoManifold(facesOf(crust)));
  });
}
