// SPDX-License-Identifier: BSD-3-Clause
#include "PruningTest.h"

#include "Pruning/RemovalByHand.h"

#include <algorithm>
#include <vector>

using complexes::Drawing;
using medial::Betti;
using medial::CellFate;
using medial::Index;
using medial::KeepReason;
using medial::Measure;
using medial::MedialAxis;
using medial::None;
using medial::Point;
using medial::Pruned;
using medial::PruneOptions;
using medial::PruneRow;
using medial::Topology;
using pipelines::forEachShape;
using pipelines::Pipeline;
using pruningTest::byHand;
using pruningTest::expectBetti;
using pruningTest::expectConsistent;
using pruningTest::firstTriangleOf;
using pruningTest::once;

TEST(Pruning, ByHandKeepsTheBettiNumbersOfRandomComplexes)
{
  for (unsigned seed = 100; seed < 130; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MedialAxis axis = complexes::randomComplex(seed).axis();
    std::vector<Index> cells;
    for (Index cell = 0; cell < axis.cells.size(); cell += 2)
    {
      cells.push_back(cell);
    }
    const Pruned pruned = medial::prune(axis, byHand(cells));
    expectBetti(pruned, axis.betti);
    expectConsistent(axis, pruned);
    ASSERT_EQ(pruned.history.size(), 1u);
    EXPECT_TRUE(pruned.history.back().byHand);
  }
}

TEST(Pruning, OneByOneKeepsTheBettiNumbersByTheirDefinition)
{
  // Part after part, each counted by the ranks of the boundary matrices, until nothing may go.
  for (unsigned seed = 300; seed < 325; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    MedialAxis axis = complexes::randomComplex(seed).axis();
    const Betti betti = axis.betti;
    for (Index cell = 0; cell < axis.cells.size();)
    {
      const Pruned pruned = medial::prune(axis, byHand({ cell }));
      const bool went = pruned.fates.at(0) == CellFate::Removed;
      ASSERT_EQ(went, pruned.removedInIteration[cell] == 0);
      ASSERT_EQ(pipelines::independentBetti(pruned.axis), betti) << "cell " << cell;
      axis = pruned.axis;
      cell = went ? 0 : cell + 1;
    }
  }
}

TEST(Pruning, NeverRemovesWhatIsProtected)
{
  forEachShape([](Pipeline& p) {
    for (const Topology topology : { Topology::Collapse, Topology::None, Topology::PaperGraph })
    {
      PruneOptions options = once(Measure::RelativeVolume, 1);
      options.topology = topology;
      const Index cells = p.axis().cells.size();
      options.cellsToProtect = { 0, cells / 3, cells - 1 };
      options.cellsToRemove = { cells / 3 };
      const Pruned pruned = medial::prune(p.axis(), options);
      expectConsistent(p.axis(), pruned);
      for (const Index cell : options.cellsToProtect)
      {
        EXPECT_EQ(pruned.removedInIteration[cell], None);
        const auto at = std::find(pruned.inputCell.begin(), pruned.inputCell.end(), cell);
        const Index part = pruned.parts.partOfCell[at - pruned.inputCell.begin()];
        EXPECT_EQ(pruned.keepReason[part], KeepReason::Protected);
      }
      EXPECT_EQ(pruned.fates, std::vector<CellFate>{ CellFate::Protected });
      EXPECT_EQ(pruned.history.back().refusedProtected, 1);
    }
  });
}

TEST(Pruning, ProtectsABranchThroughOneOfItsParts)
{
  // As in RemovesABranchWhole of TestPruningTopology.cxx, with a cell of a flap protected: the stem stays too.
  Drawing drawing;
  const Point x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  drawing.sheet(Point(0, 0, 0), x, y, 8, 8);
  drawing.sheet(Point(4, 4, 0), z, x, 1, 1);
  drawing.sheet(Point(4, 4, 1), x, y, 1, 2);
  drawing.sheet(Point(4, 4, 1), x, z - y, 1, 2);
  const MedialAxis axis = drawing.axis();
  PruneOptions options = once(Measure::TriangleCount, 10);
  options.cellsToProtect = { 130 };
  const Pruned pruned = medial::prune(axis, options);
  EXPECT_EQ(pruned.removedInIteration[130], None);
  EXPECT_EQ(pruned.removedInIteration[128], None); // without the other flap: one part with it
  EXPECT_EQ(pruned.removedInIteration[134], 0);
  expectBetti(pruned, { 1, 0, 0 });
}

TEST(Pruning, SplitsRefusalsByReason)
{
  forEachShape([](Pipeline& p) {
    for (const PruneRow& row : p.pruned().history)
    {
      EXPECT_EQ(row.refused, row.refusedByTopology + row.refusedIsolated + row.refusedProtected);
      EXPECT_EQ(row.refusedProtected, 0);
    }
  });
  const MedialAxis axis = complexes::cycleWithLoop().axis();
  PruneOptions options = once(Measure::TriangleCount, 1e9, 1);
  options.cellsToProtect = { axis.cells.size() - 1 }; // of a fin
  const PruneRow row = medial::prune(axis, options).history.at(0);
  EXPECT_EQ(row.refusedByTopology, 3);
  EXPECT_EQ(row.refusedProtected, 1);
  EXPECT_EQ(row.removed, 2);
  const MedialAxis sheet = complexes::cycleWithoutLoop().axis();
  EXPECT_EQ(
    medial::prune(sheet, once(Measure::TriangleCount, 1e9)).history.at(0).refusedIsolated, 1);
}

TEST(Pruning, TellsWhatBecameOfEachCellNamed)
{
  const MedialAxis axis = complexes::cycleWithLoop().axis();
  PruneOptions options = once(Measure::TriangleCount, 4, 1); // the fins of 4 triangles
  const Index last = axis.cells.size() - 1, first = axis.cells.firstTriangle();
  options.cellsToProtect = { last };
  options.cellsToRemove = { first, last, last - 4, last };
  EXPECT_EQ(medial::prune(axis, options).fates,
    (std::vector<CellFate>{
      CellFate::Topology, CellFate::Protected, CellFate::AlreadyGone, CellFate::Protected }));
}

TEST(Pruning, OfFigure7LeftMayTakeAnyOfTheThree)
{
  const MedialAxis axis = complexes::cycleWithoutLoop().axis();
  const medial::MedialParts parts = medial::decompose(axis);
  for (Index part = 0; part < 3; ++part)
  {
    const Pruned pruned = medial::prune(axis, byHand({ firstTriangleOf(axis, parts, part) }));
    EXPECT_EQ(pruned.axis.cells.triangles.size(), 36u);
    EXPECT_EQ(pruned.history.at(0).refused, 0);
    expectBetti(pruned, { 1, 0, 0 });
  }
}

TEST(Pruning, OfFigure7RightRefusesThePartsOfTheLoop)
{
  const MedialAxis axis = complexes::cycleWithLoop().axis();
  const medial::MedialParts parts = medial::decompose(axis);
  for (Index part = 0; part < 6; ++part)
  {
    SCOPED_TRACE(testing::Message() << "part " << part);
    const Pruned pruned = medial::prune(axis, byHand({ firstTriangleOf(axis, parts, part) }));
    ASSERT_EQ(pruned.history.size(), 1u);
    EXPECT_TRUE(pruned.history[0].byHand);
    expectBetti(pruned, { 1, 1, 0 });
    if (part < 3)
    {
      EXPECT_EQ(pruned.axis.cells.triangles.size(), 60u);
      EXPECT_EQ(pruned.history[0].refused, 1);
      EXPECT_EQ(pruned.keepReason.at(static_cast<std::size_t>(part)), KeepReason::Topology);
    }
    else
    {
      EXPECT_EQ(pruned.axis.cells.triangles.size(), 56u);
      EXPECT_EQ(pruned.history[0].removed, 1);
    }
  }
}

TEST(Pruning, ByHandTakesAPartHoweverSignificant)
{
  Pipeline& p = pipelines::of("box");
  const Pruned slivers = medial::prune(p.axis(), once(Measure::TriangleCount, 5));
  const auto triangles = [&slivers](Index part) {
    return slivers.parts.value(Measure::TriangleCount, part);
  };
  Index largest = 0;
  for (Index i = 0; i < medial::count(slivers.parts.parts); ++i)
  {
    largest = slivers.parts.parts[i].level == 1 && triangles(i) > triangles(largest) ? i : largest;
  }
  const Index cell = firstTriangleOf(slivers.axis, slivers.parts, largest);
  const Pruned pruned = medial::prune(slivers.axis, byHand({ cell }));
  expectBetti(pruned, { 1, 0, 0 });
  EXPECT_EQ(pruned.removedInIteration[cell], 0);
  EXPECT_EQ(pruned.removedPart[cell], largest);
  EXPECT_EQ(
    medial::count(slivers.axis.cells.triangles) - medial::count(pruned.axis.cells.triangles),
    triangles(largest));
}

TEST(Pruning, ByHandTakesAnEarAndNothingElse)
{
  // Paper Figure 12: naming one triangle takes the ear; what is not its own does not move.
  Pipeline p(shapes::head());
  ASSERT_EQ(p.axis().betti, (Betti{ 1, 0, 0 }));
  PruneOptions options = once(Measure::TriangleCount, 5);
  options.schedule.push_back({ Measure::RelativeVolume, 0.01, 0 });
  const Pruned clean = medial::prune(p.axis(), options);
  Index ear = 0;
  for (Index i = 0; i < medial::count(clean.parts.parts); ++i)
  {
    const auto& parts = clean.parts.parts;
    ear = parts[i].centroid.x() > parts[ear].centroid.x() ? i : ear;
  }
  options.cellsToRemove = { clean.inputCell[firstTriangleOf(clean.axis, clean.parts, ear)] };
  const Pruned pruned = medial::prune(p.axis(), options);
  EXPECT_EQ(pruned.fates, std::vector<CellFate>{ CellFate::Removed });
  expectBetti(pruned, { 1, 0, 0 });
  const std::vector<char> before = medial::keptBalls(clean.axis);
  const std::vector<char> after = medial::keptBalls(pruned.axis);
  std::vector<medial::Ball> gone;
  for (std::size_t b = 0; b < before.size(); ++b)
  {
    if (before[b] && !after[b])
    {
      gone.push_back(p.balls().balls[b]);
    }
  }
  const medial::Crust full = medial::powerCrust(p.balls(), before);
  const medial::Crust earless = medial::powerCrust(p.balls(), after);
  const validators::NearestPoint nearest(earless.points);
  int surroundings = 0;
  double rightmost = 0, leftmost = 0, rightmostBefore = 0;
  for (const Point& point : full.points)
  {
    rightmostBefore = std::max(rightmostBefore, point.x());
    if (validators::clearance(point, gone) > p.shape.spacing)
    {
      ++surroundings;
      EXPECT_LT(nearest.distance(point), p.shape.spacing);
    }
  }
  for (const Point& point : earless.points)
  {
    rightmost = std::max(rightmost, point.x());
    leftmost = std::min(leftmost, point.x());
  }
  EXPECT_GT(surroundings, medial::count(full.points) / 2);
  EXPECT_GT(rightmostBefore, 1.5);
  EXPECT_LT(rightmost, 1 + 3 * p.shape.spacing); // the sphere
  EXPECT_LT(leftmost, -1.5);                     // the other ear
}

TEST(Pruning, SaysInASentenceWhatWasNotRemovedByHand)
{
  using medial::refusals;
  const std::vector<Index> cells = { 5, 1, 4, 3, 0 };
  const std::vector<CellFate> fates = { CellFate::Topology, CellFate::Removed, CellFate::Topology,
    CellFate::AlreadyGone, CellFate::Isolated };
  EXPECT_EQ(refusals(fates, cells, {}),
    "not removed by hand; cells 4, 5: needed for the topology; cells 0: a whole piece of the axis; "
    "cells 3: already gone with the schedule");
  // By part, each once.
  EXPECT_EQ(refusals(fates, cells, { 2, 2, 2, 0, 1, 1 }),
    "not removed by hand; parts 1: needed for the topology; parts 2: a whole piece of the axis; "
    "parts 0: already gone with the schedule");
  EXPECT_EQ(
    refusals({ CellFate::Protected }, { 1 }, {}), "not removed by hand; cells 1: protected");
  EXPECT_EQ(refusals({ CellFate::Removed, CellFate::Removed }, { 1, 2 }, {}), "");
}
