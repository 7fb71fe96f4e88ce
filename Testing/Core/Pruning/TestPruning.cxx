// SPDX-License-Identifier: BSD-3-Clause
#include "PruningTest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

using complexes::Drawing;
using medial::Index;
using medial::KeepReason;
using medial::Measure;
using medial::MedialAxis;
using medial::None;
using medial::Point;
using medial::Pruned;
using medial::PruneIteration;
using medial::PruneOptions;
using medial::PruneRow;
using medial::Topology;
using pipelines::forEachShape;
using pipelines::Pipeline;
using pruningTest::byHand;
using pruningTest::corners;
using pruningTest::expectBetti;
using pruningTest::expectConsistent;
using pruningTest::once;
using pruningTest::removedTriangles;

TEST(Pruning, SaysWhatWentAndWhatStayed)
{
  forEachShape([](Pipeline& p) { expectConsistent(p.axis(), p.pruned()); });
}

TEST(Pruning, LeavesThePartsOfWhatLives)
{
  forEachShape([](Pipeline& p) {
    EXPECT_EQ(
      pipelines::bytesOf(p.pruned().parts), pipelines::bytesOf(medial::decompose(p.pruned().axis)));
  });
}

TEST(Pruning, HistoryAddsUp)
{
  forEachShape([](Pipeline& p) {
    const std::vector<PruneRow>& history = p.pruned().history;
    const auto schedule = pipelines::standardSchedule().schedule;
    ASSERT_EQ(history.size(), schedule.size());
    EXPECT_EQ(history.front().partsBefore, medial::count(p.parts().parts));
    EXPECT_EQ(history.back().partsAfter, medial::count(p.pruned().parts.parts));
    double volume = 0;
    for (std::size_t i = 0; i < history.size(); ++i)
    {
      const PruneRow& row = history[i];
      EXPECT_TRUE(i == 0 || row.partsBefore == history[i - 1].partsAfter);
      EXPECT_FALSE(row.byHand);
      EXPECT_EQ(row.measure, schedule[i].measure);
      EXPECT_EQ(row.threshold, schedule[i].threshold);
      EXPECT_GE(row.passes, 1);
      EXPECT_GE(row.candidates, row.refused);
      EXPECT_GE(row.volumeRemoved, 0);
      volume += row.volumeRemoved;
    }
    EXPECT_LE(volume, 1 + 1e-9);
  });
}

TEST(Pruning, VolumeRemovedIsThatOfTheBallsThatWent)
{
  forEachShape([](Pipeline& p) {
    double gone = 0, all = 0, said = 0;
    const std::vector<char> keep = p.keptAfterPruning();
    for (std::size_t b = 0; b < keep.size(); ++b)
    {
      all += p.axis().ballVolumes[b];
      gone += keep[b] ? 0 : p.axis().ballVolumes[b];
    }
    for (const PruneRow& row : p.pruned().history)
    {
      said += row.volumeRemoved;
    }
    EXPECT_NEAR(said, gone / all, 1e-9);
  });
}

TEST(Pruning, WithAnEmptyScheduleChangesNothing)
{
  forEachShape([](Pipeline& p) {
    const Pruned pruned = medial::prune(p.axis(), {});
    EXPECT_EQ(pipelines::bytesOf(pruned.axis), pipelines::bytesOf(p.axis()));
    EXPECT_EQ(pipelines::bytesOf(pruned.parts), pipelines::bytesOf(p.parts()));
    EXPECT_TRUE(pruned.history.empty());
  });
}

TEST(Pruning, WithThresholdZeroRemovesNoTriangle)
{
  forEachShape([](Pipeline& p) {
    const Pruned pruned = medial::prune(p.axis(), once(Measure::TriangleCount, 0));
    EXPECT_EQ(pruned.axis.cells.triangles, p.axis().cells.triangles);
    const Pruned byVolume = medial::prune(p.axis(), once(Measure::RelativeVolume, 0));
    ASSERT_EQ(byVolume.history.size(), 1u);
    EXPECT_EQ(byVolume.history[0].volumeRemoved, 0);
  });
}

// They have no area and no border of a sheet, and would go whatever the threshold: a rod would shrink to a point.
TEST(Pruning, ByAreaOrBorderLeavesCurvesAlone)
{
  forEachShape([](Pipeline& p) {
    for (const Measure measure : { Measure::Area, Measure::BoundaryLength })
    {
      const Pruned pruned = medial::prune(p.axis(), once(measure, 1e9));
      EXPECT_EQ(pruned.axis.cells.edges.size(), p.axis().cells.edges.size());
      EXPECT_EQ(pruned.axis.cells.vertices.size(), p.axis().cells.vertices.size());
    }
  });
}

// No part may be just below a threshold: it can have been kept for the slivers that it took over. The
// small sheets of the box have a hundredth of the volume each.
TEST(Pruning, UntilNothingChangesLeavesNothingToDo)
{
  forEachShape([](Pipeline& p) {
    for (const PruneIteration& iteration : { PruneIteration{ Measure::TriangleCount, 5, 0 },
           PruneIteration{ Measure::RelativeVolume, 0.005, 0 } })
    {
      PruneOptions options;
      options.schedule.push_back(iteration);
      const Pruned first = medial::prune(p.axis(), options);
      const Pruned second = medial::prune(first.axis, options);
      EXPECT_EQ(corners(second.axis), corners(first.axis));
      EXPECT_EQ(second.history.at(0).removed, 0);
    }
  });
}

TEST(Pruning, InOnePassIsThePapers)
{
  forEachShape([](Pipeline& p) {
    const Pruned pruned = medial::prune(p.axis(), once(Measure::TriangleCount, 5, 1));
    EXPECT_EQ(pruned.history.at(0).passes, 1);
    expectBetti(pruned, p.shape.betti);
  });
}

TEST(Pruning, RemovesSmallPartsOnly)
{
  forEachShape([](Pipeline& p) {
    PruneOptions options = once(Measure::TriangleCount, 5, 1);
    options.removeBranches = false;
    const Pruned pruned = medial::prune(p.axis(), options);
    for (const Index cell : removedTriangles(p.axis(), pruned))
    {
      const Index part = p.parts().partOfCell[cell];
      EXPECT_LE(p.parts().value(Measure::TriangleCount, part), 5);
      EXPECT_EQ(p.parts().parts[part].level, 1);
    }
  });
}

TEST(Pruning, WithoutTopologyRemovesAllSmallPartsOfLevelOne)
{
  // The control: exactly the parts of level 1 up to the threshold, so more with a higher one.
  forEachShape([](Pipeline& p) {
    std::set<Index> before;
    for (const double threshold : { 2.0, 5.0, 40.0 })
    {
      PruneOptions options = once(Measure::TriangleCount, threshold, 1);
      options.topology = Topology::None;
      options.removeHair = options.removeBranches = false;
      const std::set<Index> removed = removedTriangles(p.axis(), medial::prune(p.axis(), options));
      std::set<Index> expected;
      for (Index cell = p.axis().cells.firstTriangle(); cell < p.axis().cells.size(); ++cell)
      {
        const Index part = p.parts().partOfCell[cell];
        if (p.parts().parts[part].level == 1 &&
          p.parts().value(Measure::TriangleCount, part) <= threshold)
        {
          expected.insert(cell);
        }
      }
      EXPECT_EQ(removed, expected) << "threshold " << threshold;
      EXPECT_TRUE(std::includes(removed.begin(), removed.end(), before.begin(), before.end()));
      before = removed;
    }
  });
}

TEST(Pruning, TakesTheLeastSignificantFirst)
{
  // Three sheets about a line, of 12, 2 and 6 triangles.
  Drawing drawing;
  const Point up(0, 0, 1);
  drawing.sheet(Point(0, 0, 0), up, Point(0, -1, 0), 1, 6);
  drawing.sheet(Point(0, 0, 0), up, Point(1, 0, 0), 1, 1);
  drawing.sheet(Point(0, 0, 0), up, Point(-1, 0, 0), 1, 3);
  const MedialAxis axis = drawing.axis();
  const Pruned pruned = medial::prune(axis, once(Measure::TriangleCount, 100));
  ASSERT_EQ(pruned.parts.parts.size(), 1u);
  EXPECT_EQ(pruned.removedInIteration[0], None);
  EXPECT_EQ(pruned.removedInIteration[12], 0);
  EXPECT_EQ(pruned.removedInIteration[13], 0);
}

TEST(Pruning, DoesNotEatALongFeatureFromItsEnds)
{
  // A string of 20 triangles with an edge between each two. All parts are small, together they are
  // the object; at each of the two ends at most the threshold goes.
  Drawing drawing;
  for (int i = 0; i < 20; ++i)
  {
    const double x = 2 * i;
    drawing.triangle(
      drawing.point(x, 0, 0), drawing.point(x + 1, 0, 0), drawing.point(x + 0.5, 1, 0));
    if (i < 19)
    {
      drawing.edge(drawing.point(x + 1, 0, 0), drawing.point(x + 2, 0, 0));
    }
  }
  for (const double threshold : { 0.06, 0.1, 0.2 })
  {
    SCOPED_TRACE(testing::Message() << "threshold " << threshold);
    const Pruned pruned = medial::prune(drawing.axis(), once(Measure::RelativeVolume, threshold));
    EXPECT_GT(pruned.history.at(0).volumeRemoved, 0);
    EXPECT_LE(pruned.history.at(0).volumeRemoved, 2 * threshold + 1e-9);
  }
}

TEST(Pruning, LeavesMostOfACapsule)
{
  // Its axis is a string of slivers. At the two ends a tenth may go each, and the slivers beside.
  const MedialAxis& axis = pipelines::of("capsule").axis();
  EXPECT_LT(
    medial::prune(axis, once(Measure::RelativeVolume, 0.1)).history.at(0).volumeRemoved, 0.35);
  EXPECT_LT(
    medial::prune(axis, once(Measure::RelativeVolume, 0.01)).history.at(0).volumeRemoved, 0.2);
}

TEST(Pruning, KeepReasonsTellTheThreshold)
{
  forEachShape([](Pipeline& p) {
    const Pruned pruned = medial::prune(p.axis(), once(Measure::TriangleCount, 5));
    for (std::size_t i = 0; i < pruned.keepReason.size(); ++i)
    {
      const medial::MedialPart& part = pruned.parts.parts[i];
      if (part.dimension == 2)
      {
        EXPECT_TRUE(pruned.keepReason[i] != KeepReason::InnerLevel || part.level != 1);
        EXPECT_TRUE(pruned.keepReason[i] != KeepReason::Topology ||
          pruned.parts.value(Measure::TriangleCount, static_cast<Index>(i)) <= 5);
      }
    }
  });
}

TEST(Pruning, ScalesWithTheAxisToTheLastBit)
{
  Pipeline& p = pipelines::of("two-hole plate");
  for (const int exponent : { -20, 20 })
  {
    const double factor = std::ldexp(1, exponent);
    const Pruned pruned =
      medial::prune(pipelines::inUnits(p.axis(), factor), pipelines::standardSchedule());
    EXPECT_EQ(pruned.inputCell, p.pruned().inputCell);
    EXPECT_EQ(pruned.removedInIteration, p.pruned().removedInIteration);
    EXPECT_EQ(pruned.keepReason, p.pruned().keepReason);
  }
}

TEST(Pruning, IsTheSameOnManyThreads)
{
  Pipeline& p = pipelines::of("box");
  EXPECT_EQ(pipelines::bytesOf(
              medial::prune(p.axis(), pipelines::standardSchedule(), pipelines::threaded())),
    pipelines::bytesOf(p.pruned()));
}

TEST(Pruning, ReportsProgressAndStops)
{
  const MedialAxis axis =
    medial::medialAxis(medial::polarBalls(shapes::twoHolePlate(0.12).samples));
  pipelines::expectProgressAndAbort([&](const medial::Execution& execution) {
    medial::prune(axis, pipelines::standardSchedule(), execution);
  });
}

TEST(Pruning, RefusesThresholdsThatAreNoNumbers)
{
  const MedialAxis axis = complexes::cycleWithLoop().axis();
  for (const double bad : { -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_THROW(medial::prune(axis, once(Measure::TriangleCount, bad)), medial::InvalidInput);
    EXPECT_THROW(medial::prune(axis, once(Measure::RelativeVolume, bad)), medial::InvalidInput);
  }
}

TEST(Pruning, RefusesNeckRatiosThatAreNoShares)
{
  PruneOptions options;
  for (const double bad : { -0.1, 1.1, std::numeric_limits<double>::quiet_NaN() })
  {
    options.neckRatio = bad;
    EXPECT_THROW(medial::prune(complexes::cycleWithLoop().axis(), options), medial::InvalidInput);
  }
}

TEST(Pruning, RefusesCellsThatAreNotThere)
{
  const MedialAxis axis = complexes::cycleWithLoop().axis();
  EXPECT_THROW(medial::prune(axis, byHand({ axis.cells.size() })), medial::InvalidInput);
  EXPECT_THROW(medial::prune(axis, byHand({ -1 })), medial::InvalidInput);
  PruneOptions options;
  options.cellsToProtect = { axis.cells.size() };
  EXPECT_THROW(medial::prune(axis, options), medial::InvalidInput);
}
