// SPDX-License-Identifier: BSD-3-Clause
#include "Numbers.h"
#include "PruningTest.h"

#include "Parts/Thresholds.h"

#include <cmath>
#include <vector>

using medial::Measure;
using medial::Point;
using medial::Pruned;
using medial::PruneOptions;
using medial::PruneRow;
using pipelines::forEachShape;
using pipelines::Pipeline;
using pruningTest::expectConsistent;

TEST(Pruning, AutomaticallyIsByTheScheduleThatItsHistoryTells)
{
  PruneOptions automatic;
  automatic.automatic = true;
  forEachShape([&](Pipeline& p) {
    const Pruned pruned = medial::prune(p.axis(), automatic);
    PruneOptions told;
    for (const PruneRow& row : pruned.history)
    {
      told.schedule.push_back({ row.measure, row.threshold, 0 });
    }
    EXPECT_EQ(pipelines::bytesOf(medial::prune(p.axis(), told)), pipelines::bytesOf(pruned));
    EXPECT_EQ(pruned.axis.betti, p.axis().betti);
    expectConsistent(p.axis(), pruned);
  });
}

TEST(Pruning, AutomaticallyStopsWhereTheDropFlattens)
{
  PruneOptions automatic;
  automatic.automatic = true;
  const auto expectFlattening = [&](const std::vector<PruneRow>& history) {
    ASSERT_FALSE(history.empty());
    double volumeRemoved = 0;
    for (std::size_t i = 0; i < history.size(); ++i)
    {
      const PruneRow& row = history[i];
      const bool isLast = i + 1 == history.size();
      const bool dropped = 10 * (row.partsBefore - row.partsAfter) >= row.partsBefore;
      EXPECT_TRUE(row.measure == Measure::TriangleCount ? row.threshold == 5
                                                        : volumeRemoved < medial::removableVolume);
      EXPECT_TRUE(isLast || dropped == (history[i + 1].measure == row.measure));
      volumeRemoved += row.volumeRemoved;
    }
  };
  forEachShape([&](Pipeline& p) { expectFlattening(medial::prune(p.axis(), automatic).history); });

  RecordProperty("seed", 7);
  shapes::Random random(7);
  std::vector<Point> samples = shapes::ellipsoid(0.08).samples;
  for (Point& p : samples)
  {
    p += shapes::normalPoint(random, 0.02);
  }
  const Pruned pruned = medial::prune(medial::medialAxis(medial::polarBalls(samples)), automatic);
  expectFlattening(pruned.history);
  EXPECT_EQ(pruned.history.back().measure, Measure::RelativeVolume);
  EXPECT_LT(pruned.history.back().partsAfter, pruned.history[0].partsAfter / 4);
}

TEST(Pruning, AutomaticallyScalesWithTheAxis)
{
  PruneOptions automatic;
  automatic.automatic = true;
  Pipeline& p = pipelines::of("two-hole plate");
  EXPECT_EQ(medial::prune(pipelines::inUnits(p.axis(), std::ldexp(1, 21)), automatic).inputCell,
    medial::prune(p.axis(), automatic).inputCell);
}
