// SPDX-License-Identifier: BSD-3-Clause
// The crust keeps the topology of the pruned axis where the balls that are left alone would not.
#include "Pipelines.h"

#include "Base/Triangulations.h"
#include "Crust/ChangedRegions.h"
#include "Crust/PowerCrust.h"

#include <algorithm>
#include <iterator>
#include <set>

using medial::Betti;
using medial::ChangedRegion;
using medial::Crust;
using medial::CrustOptions;
using medial::CrustRule;
using medial::Index;
using medial::None;
using medial::Side;
using medial::Tetrahedron;

namespace
{
/// Samples that are no surface: a solid with many tunnels and walls as thin as the spacing.
struct PrunedCloud
{
  explicit PrunedCloud(unsigned seed, medial::Topology topology = medial::Topology::Collapse)
    : balls(medial::polarBalls(shapes::cloud(200, seed)))
  {
    medial::PruneOptions options = pipelines::standardSchedule();
    options.topology = topology;
    this->pruned = medial::prune(medial::medialAxis(this->balls), options);
    this->keep = medial::keptBalls(this->pruned.axis);
  }

  Crust crust(CrustRule rule, const Betti& topology) const
  {
    CrustOptions options;
    options.rule = rule;
    options.topology = topology;
    return medial::powerCrust(this->balls, this->keep, options);
  }

  medial::PolarBalls balls;
  medial::Pruned pruned;
  std::vector<char> keep;
};

constexpr unsigned seeds = 40;

/// Random balls, and their regular triangulation without some of them.
class Triangulated
{
public:
  explicit Triangulated(unsigned seed)
  {
    for (const medial::Point& center : shapes::cloud(300, seed))
    {
      this->balls.push_back({ center, 0.1 });
    }
  }

  /// Corners ascending.
  std::set<Tetrahedron> without(const std::vector<Index>& removed) const
  {
    std::vector<medial::Ball> left;
    std::vector<Index> ids;
    for (Index b = 0; b < medial::count(this->balls); ++b)
    {
      if (!std::binary_search(removed.begin(), removed.end(), b))
      {
        left.push_back(this->balls[b]);
        ids.push_back(b);
      }
    }
    medial::RegularTriangulation triangulation;
    triangulation.insert(left);
    std::set<Tetrahedron> result;
    for (Tetrahedron cell : triangulation.tetrahedra().cells)
    {
      std::transform(cell.begin(), cell.end(), cell.begin(), [&](Index b) { return ids[b]; });
      std::sort(cell.begin(), cell.end());
      result.insert(cell);
    }
    return result;
  }

private:
  std::vector<medial::Ball> balls;
};

std::vector<Tetrahedron> listOf(const std::set<Tetrahedron>& cells)
{
  return { cells.begin(), cells.end() };
}
}

TEST(PuttingBack, KeepsTheTopologyThatTheKeptBallsAloneLose)
{
  int contradicted = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const PrunedCloud cloud(seed);
    const Betti& wanted = cloud.pruned.axis.betti;
    const Crust crust = cloud.crust(CrustRule::Clearance, wanted);
    EXPECT_EQ(crust.betti, wanted);
    EXPECT_TRUE(crust.warnings.empty());
    EXPECT_TRUE(validators::isTwoManifold(pipelines::facesOf(crust)));
    const bool isContradicted = cloud.crust(CrustRule::InnerOnly, wanted).betti != wanted;
    EXPECT_EQ(crust.putBackBalls > 0, isContradicted);
    contradicted += isContradicted;
  }
  EXPECT_GT(contradicted, 0) << "no seed shows what is tested";
}

TEST(PuttingBack, TakesFewOfTheRemovedBalls)
{
  for (unsigned seed = 1; seed <= seeds; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const PrunedCloud cloud(seed);
    const Crust crust = cloud.crust(CrustRule::Clearance, cloud.pruned.axis.betti);
    std::set<Index> behind;
    for (const Index ball : crust.innerBall)
    {
      ASSERT_EQ(cloud.balls.sides[ball], Side::Inner);
      if (!cloud.keep[ball])
      {
        behind.insert(ball);
      }
    }
    EXPECT_LE(medial::count(behind), crust.putBackBalls);
    EXPECT_LE(crust.putBackBalls, 5);
  }
}

TEST(PuttingBack, ThePapersRulesPutNothingBackButSaySo)
{
  int told = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const PrunedCloud cloud(seed);
    const Betti& wanted = cloud.pruned.axis.betti;
    for (const CrustRule rule : { CrustRule::InnerOnly, CrustRule::InnerAndOuter })
    {
      const Crust crust = cloud.crust(rule, wanted);
      EXPECT_EQ(crust.putBackBalls, 0);
      ASSERT_EQ(crust.warnings.size(), crust.betti == wanted ? 0u : 1u);
      for (const medial::Warning& warning : crust.warnings)
      {
        EXPECT_EQ(warning.code, "crust_topology");
        EXPECT_EQ(warning.count, medial::bettiDistance(crust.betti, wanted));
        ++told;
      }
    }
  }
  EXPECT_GT(told, 0) << "no seed shows what is tested";
}

// Sheets that were torn out of the axis leave balls that touch each other all the same.
TEST(PuttingBack, SaysWhereItCannotHelp)
{
  int places = 0;
  for (unsigned seed = 1; seed <= seeds; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const PrunedCloud cloud(seed, medial::Topology::None);
    const Betti& wanted = cloud.pruned.axis.betti;
    const Crust crust = cloud.crust(CrustRule::Clearance, wanted);
    EXPECT_TRUE(crust.closed && crust.manifold);
    ASSERT_EQ(crust.warnings.size(), crust.betti == wanted ? 0u : 1u);
    for (const medial::Warning& warning : crust.warnings)
    {
      EXPECT_EQ(warning.code, "crust_topology");
      EXPECT_EQ(warning.count, medial::bettiDistance(crust.betti, wanted));
      EXPECT_FALSE(warning.doubtsSolid);
      const auto isPlace = [&](const medial::Ball& ball) { return ball.center == warning.place; };
      EXPECT_TRUE(
        !warning.place || std::any_of(cloud.balls.balls.begin(), cloud.balls.balls.end(), isPlace));
      places += warning.place.has_value();
    }
  }
  EXPECT_GT(places, 0) << "no seed shows what is tested";
}

TEST(PuttingBack, SaysThatTheUnprunedCrustIsContradicted)
{
  const medial::PolarBalls balls = medial::polarBalls(shapes::cloud(200, 1));
  CrustOptions options;
  options.topology = Betti{ 1, 0, 7 };
  const Crust crust = medial::powerCrust(balls, {}, options);
  ASSERT_EQ(crust.warnings.size(), 1u);
  EXPECT_EQ(crust.warnings[0].count, medial::bettiDistance(crust.betti, *options.topology));
}

TEST(PuttingBack, PutsNothingBackWhereNoTopologyIsAskedFor)
{
  const PrunedCloud cloud(1);
  const Crust crust = medial::powerCrust(cloud.balls, cloud.keep);
  EXPECT_EQ(crust.putBackBalls, 0);
  EXPECT_TRUE(crust.warnings.empty());
}

TEST(ChangedRegions, OfTheSameTriangulationAreNone)
{
  const std::vector<Tetrahedron> cells = listOf(Triangulated(1).without({}));
  EXPECT_TRUE(medial::changedRegions(cells, cells, { 3, 7 }).empty());
}

TEST(ChangedRegions, ChangeEachAlone)
{
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Triangulated triangulated(seed);
    const std::vector<Index> removed = { 5, 50, 100, 150, 200, 250 };
    const std::set<Tetrahedron> with = triangulated.without({});
    const std::set<Tetrahedron> without = triangulated.without(removed);
    std::vector<Index> seen;
    std::size_t changed = 0;
    for (const ChangedRegion& region :
      medial::changedRegions(listOf(with), listOf(without), removed))
    {
      seen.insert(seen.end(), region.removed.begin(), region.removed.end());
      // With the region's balls put back, it is as with all, and all else as without.
      // The cells that fill it are as they should be: those of `with` are gone, those of `without` new.
      for (const Tetrahedron& cell : region.with)
      {
        EXPECT_TRUE(with.count(cell) == 1 && without.count(cell) == 0);
      }
      for (const Tetrahedron& cell : region.without)
      {
        EXPECT_TRUE(with.count(cell) == 0 && without.count(cell) == 1);
      }
      changed += region.with.size() + region.without.size();
      std::vector<Index> others;
      std::set_difference(removed.begin(), removed.end(), region.removed.begin(),
        region.removed.end(), std::back_inserter(others));
      const auto isInside = [&](const Tetrahedron& cell) {
        return std::includes(region.balls.begin(), region.balls.end(), cell.begin(), cell.end());
      };
      for (const Tetrahedron& cell : triangulated.without(others))
      {
        EXPECT_TRUE(
          isInside(cell) ? with.count(cell) || without.count(cell) : without.count(cell) == 1);
      }
    }
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(seen, removed) << "each removed ball is in one region";
    std::vector<Tetrahedron> difference;
    std::set_symmetric_difference(
      with.begin(), with.end(), without.begin(), without.end(), std::back_inserter(difference));
    EXPECT_EQ(changed, difference.size()) << "each changed cell is in one region";
  }
}
