// SPDX-License-Identifier: BSD-3-Clause
#include "PruningTest.h"

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
using pruningTest::removedTriangles;

TEST(Pruning, KeepsTheBettiNumbers)
{
  forEachShape([](Pipeline& p) { expectBetti(p.pruned(), p.shape.betti); });
}

TEST(Pruning, KeepsTheBettiNumbersOfRandomComplexes)
{
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MedialAxis axis = complexes::randomComplex(seed).axis();
    PruneOptions options;
    options.schedule = { { Measure::TriangleCount, 1, 1 }, { Measure::RelativeVolume, 0.2, 0 },
      { Measure::TriangleCount, 1000, 0 } };
    for (const bool branches : { false, true })
    {
      options.removeBranches = branches;
      options.removeHair = seed % 3 != 0;
      const Pruned pruned = medial::prune(axis, options);
      expectBetti(pruned, axis.betti);
      expectConsistent(axis, pruned);
    }
  }
}

TEST(Pruning, KeepsTheBettiNumbersWithEveryRemoval)
{
  // Verified by computing them anew after each, in every measure, with and without protected cells.
  for (unsigned seed = 200; seed < 230; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MedialAxis axis = complexes::randomComplex(seed).axis();
    for (const medial::MeasureTraits& traits : medial::allMeasures())
    {
      SCOPED_TRACE(traits.name);
      PruneOptions options =
        once(traits.measure, std::min(1e9, medial::largestThreshold(traits.unit)));
      options.verifyTopology = true;
      options.removeBranches = seed % 2 == 0;
      options.cellsToRemove = { static_cast<Index>(seed) % axis.cells.size() };
      for (const bool protects : { false, true })
      {
        if (protects)
        {
          options.cellsToProtect.push_back(static_cast<Index>(7 * seed) % axis.cells.size());
        }
        const Pruned pruned = medial::prune(axis, options);
        expectBetti(pruned, axis.betti);
        expectConsistent(axis, pruned);
        for (const PruneRow& row : pruned.history)
        {
          EXPECT_EQ(row.topologyChanges, 0);
        }
        for (const Index cell : options.cellsToProtect)
        {
          EXPECT_EQ(pruned.removedInIteration[cell], None);
        }
      }
    }
  }
}

TEST(Pruning, VerifiesEveryRemovalOfTheShapes)
{
  forEachShape([](Pipeline& p) {
    PruneOptions options = pipelines::standardSchedule();
    options.verifyTopology = true;
    const Pruned pruned = medial::prune(p.axis(), options);
    EXPECT_EQ(pruned.removedInIteration, p.pruned().removedInIteration);
    for (const PruneRow& row : pruned.history)
    {
      EXPECT_EQ(row.topologyChanges, 0);
    }
    EXPECT_EQ(p.pruned().history[0].topologyChanges, None);
  });
}

TEST(Pruning, ByThePapersGraphLosesALoopInsideAPart)
{
  const MedialAxis axis = complexes::bandWithFin().axis();
  ASSERT_EQ(axis.betti, (Betti{ 1, 1, 0 }));
  PruneOptions options = once(Measure::TriangleCount, 20);
  options.verifyTopology = true;
  expectBetti(medial::prune(axis, options), axis.betti);
  options.topology = Topology::PaperGraph;
  const Pruned pruned = medial::prune(axis, options);
  EXPECT_EQ(pruned.axis.betti, (Betti{ 1, 0, 0 }));
  EXPECT_EQ(pruned.history.at(0).topologyChanges, 1);
}

TEST(Pruning, ByThePapersGraphKeepsTheLoopsOfItsFigures)
{
  for (const Drawing& drawing : { complexes::cycleWithoutLoop(), complexes::cycleWithLoop(),
         complexes::fourNodesAndSixParts(), complexes::boxAxis(8) })
  {
    const MedialAxis axis = drawing.axis();
    PruneOptions options = once(Measure::TriangleCount, 1e9, 1);
    options.topology = Topology::PaperGraph;
    const Pruned pruned = medial::prune(axis, options);
    expectBetti(pruned, axis.betti);
    expectConsistent(axis, pruned);
  }
  const MedialAxis axis = complexes::fourNodesAndSixParts().axis();
  PruneOptions options = byHand({ axis.cells.firstTriangle() });
  options.topology = Topology::PaperGraph;
  EXPECT_EQ(medial::prune(axis, options).fates.at(0), CellFate::Topology);
}

TEST(Pruning, ByThePapersGraphLosesTheLoopOfAKnot)
{
  const MedialAxis& axis = pipelines::of("knot").axis();
  PruneOptions options = once(Measure::TriangleCount, 5);
  options.schedule.push_back({ Measure::RelativeVolume, 1, 0 });
  options.verifyTopology = true;
  expectBetti(medial::prune(axis, options), { 1, 1, 0 });
  options.topology = Topology::PaperGraph;
  const Pruned pruned = medial::prune(axis, options);
  EXPECT_EQ(pruned.axis.betti[1], 0);
  EXPECT_GT(pruned.history[0].topologyChanges + pruned.history[1].topologyChanges, 0);
}

TEST(Pruning, CountsWhatChangesWithoutTopology)
{
  PruneOptions options = once(Measure::TriangleCount, 1e9);
  options.topology = Topology::None;
  options.verifyTopology = true;
  EXPECT_GT(
    medial::prune(complexes::cycleWithLoop().axis(), options).history[0].topologyChanges, 0);
}

TEST(Pruning, WithoutTopologyLosesTheLoop)
{
  PruneOptions options = once(Measure::TriangleCount, 1e9);
  options.topology = Topology::None;
  const MedialAxis axis = complexes::cycleWithLoop().axis();
  ASSERT_EQ(axis.betti, (Betti{ 1, 1, 0 }));
  EXPECT_NE(medial::prune(axis, options).axis.betti, axis.betti);
}

TEST(Pruning, OfFigure7LeftLeavesOneSheet)
{
  const MedialAxis axis = complexes::cycleWithoutLoop().axis();
  const Pruned pruned = medial::prune(axis, once(Measure::TriangleCount, 18));
  expectBetti(pruned, { 1, 0, 0 });
  expectConsistent(axis, pruned);
  ASSERT_EQ(pruned.parts.parts.size(), 1u);
  EXPECT_EQ(pruned.keepReason[0], KeepReason::Isolated);
  // Equal significance: the lower parts go first.
  EXPECT_EQ(removedTriangles(axis, pruned).count(axis.cells.firstTriangle()), 1u);
}

TEST(Pruning, OfFigure7RightKeepsTheLoop)
{
  const MedialAxis axis = complexes::cycleWithLoop().axis();
  const Pruned pruned = medial::prune(axis, once(Measure::TriangleCount, 1e9));
  expectBetti(pruned, { 1, 1, 0 });
  expectConsistent(axis, pruned);
  EXPECT_EQ(pruned.axis.cells.triangles.size(), 48u); // the fins go, the three sheets stay
}

TEST(Pruning, OfFigure9KeepsTheThreeTunnels)
{
  // Three tunnels run up between the sheets; every part is a wall of one.
  const MedialAxis axis = complexes::fourNodesAndSixParts().axis();
  ASSERT_EQ(axis.betti, (Betti{ 1, 3, 0 }));
  const medial::MedialParts parts = medial::decompose(axis);
  ASSERT_EQ(parts.parts.size(), 6u);
  const Pruned all = medial::prune(axis, once(Measure::RelativeVolume, 1));
  expectBetti(all, axis.betti);
  expectConsistent(axis, all);
  EXPECT_EQ(all.history.at(0).refusedByTopology, 6);
  for (Index part = 0; part < 6; ++part)
  {
    const Pruned pruned = medial::prune(axis, byHand({ firstTriangleOf(axis, parts, part) }));
    expectBetti(pruned, axis.betti);
    EXPECT_EQ(pruned.fates, std::vector<CellFate>{ CellFate::Topology });
  }
  PruneOptions control = once(Measure::TriangleCount, 12); // the three sheets in the middle
  control.topology = Topology::None;
  EXPECT_NE(medial::prune(axis, control).axis.betti, axis.betti);
}

TEST(Pruning, RemovesHairAndKeepsBridges)
{
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 3, 3);
  drawing.sheet(Point(9, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 3, 3);
  const Index a = drawing.point(5, 0, 0), b = drawing.point(7, 0, 0);
  drawing.edge(drawing.point(3, 0, 0), a); // the bridge
  drawing.edge(a, b);
  drawing.edge(b, drawing.point(9, 0, 0));
  const Index c = drawing.point(0, 5, 0);
  drawing.edge(drawing.point(0, 3, 0), c); // hair on a sheet
  drawing.edge(c, drawing.point(0, 6, 0));
  drawing.edge(a, drawing.point(5, 1, 0)); // hair on the bridge
  const MedialAxis axis = drawing.axis();
  const Pruned pruned = medial::prune(axis, once(Measure::TriangleCount, 5));
  expectBetti(pruned, { 1, 0, 0 });
  expectConsistent(axis, pruned);
  EXPECT_EQ(pruned.axis.cells.triangles.size(), 36u);
  EXPECT_EQ(pruned.axis.cells.edges.size(), 3u);
  PruneOptions options = once(Measure::TriangleCount, 1e-9, 1);
  options.schedule[0].measure = Measure::RelativeVolume;
  options.removeHair = false;
  EXPECT_EQ(medial::prune(axis, options).axis.cells.edges.size(), 6u);
}

TEST(Pruning, KeepsALoopOfEdges)
{
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 2, 2);
  const Index a = drawing.point(4, 0, 1), b = drawing.point(4, 0, -1);
  drawing.edge(drawing.point(2, 0, 0), a);
  drawing.edge(a, b);
  drawing.edge(b, drawing.point(2, 0, 0));
  const MedialAxis axis = drawing.axis();
  ASSERT_EQ(axis.betti, (Betti{ 1, 1, 0 }));
  const Pruned pruned = medial::prune(axis, once(Measure::TriangleCount, 100));
  expectBetti(pruned, { 1, 1, 0 });
  EXPECT_EQ(pruned.axis.cells.edges.size(), 3u);
}

TEST(Pruning, KeepsOneOfEachPiece)
{
  Drawing drawing;
  for (int i = 0; i < 4; ++i)
  {
    drawing.sheet(Point(5.0 * i, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 1, 1 + i);
  }
  drawing.vertex(drawing.point(-5, 0, 0));
  const Pruned pruned = medial::prune(drawing.axis(), once(Measure::TriangleCount, 1e9));
  expectBetti(pruned, { 5, 0, 0 });
  for (const KeepReason reason : pruned.keepReason)
  {
    EXPECT_EQ(reason, KeepReason::Isolated);
  }
}

TEST(Pruning, RemovesABranchWhole)
{
  // A stem of 2 triangles carries two flaps of 4. It is the first in the order and can't go alone.
  Drawing drawing;
  const Point x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  drawing.sheet(Point(0, 0, 0), x, y, 8, 8);
  drawing.sheet(Point(4, 4, 0), z, x, 1, 1);
  drawing.sheet(Point(4, 4, 1), x, y, 1, 2);
  drawing.sheet(Point(4, 4, 1), x, z - y, 1, 2);
  const MedialAxis axis = drawing.axis();
  ASSERT_EQ(axis.betti, (Betti{ 1, 0, 0 }));
  ASSERT_EQ(medial::decompose(axis).parts.size(), 4u);
  const Pruned pruned = medial::prune(axis, once(Measure::TriangleCount, 10, 1));
  expectBetti(pruned, { 1, 0, 0 });
  EXPECT_EQ(pruned.axis.cells.triangles.size(), 128u);
  EXPECT_EQ(pruned.history.at(0).removed, 3);
}
