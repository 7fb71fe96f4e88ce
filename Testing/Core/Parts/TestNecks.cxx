// SPDX-License-Identifier: BSD-3-Clause
#include "Numbers.h"
#include "Pipelines.h"

#include "Parts/BettiNumbers.h"
#include "Parts/LivingCells.h"
#include "Parts/Necks.h"
#include "Pruning/Pruning.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using complexes::Drawing;
using medial::Betti;
using medial::Bodies;
using medial::Index;
using medial::MedialAxis;
using medial::MedialParts;
using medial::Point;
using pipelines::forEachShape;
using pipelines::Pipeline;

namespace
{
Bodies bodiesOf(const MedialAxis& axis, double neckRatio)
{
  return medial::bodies(axis, medial::axisEdges(axis.cells), neckRatio);
}

/// A flat band 4 long and 0.5 wide with a radius that depends on the place along it.
MedialAxis band(const std::function<double(double)>& radius)
{
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(0.125, 0, 0), Point(0, 0.125, 0), 32, 4);
  MedialAxis axis = drawing.axis();
  for (Index p = 0; p < medial::count(axis.points); ++p)
  {
    axis.radii[p] = radius(axis.points[p].x());
  }
  return axis;
}

/// 0.25 thick up to x = 2, then 0.1.
double step(double x)
{
  return x <= 2 ? 0.25 : 0.1;
}

/// 0.2 thick, then 0.18, with a neck of 0.05 at x = 2.
double dumbbell(double x)
{
  return x == 2 ? 0.05 : x < 2 ? 0.2 : 0.18;
}

/// The largest difference of x between the thickest corners of the cells of a body.
double extent(const MedialAxis& axis, const Bodies& bodies, Index body)
{
  double lower = 10, upper = -10;
  for (Index t = 0; t < medial::count(axis.cells.triangles); ++t)
  {
    for (const Index p : axis.cells.triangles[t])
    {
      if (bodies.ofCell[axis.cells.firstTriangle() + t] == body)
      {
        lower = std::min(lower, axis.points[p].x());
        upper = std::max(upper, axis.points[p].x());
      }
    }
  }
  return upper - lower;
}
}

TEST(Necks, CutAThinLimbOffAThickTrunk)
{
  const MedialAxis axis = band(step);
  const Bodies bodies = bodiesOf(axis, 0.5);
  ASSERT_EQ(bodies.neckRatio.size(), 2u);
  EXPECT_EQ(bodies.neckRatio[0], 1);
  EXPECT_DOUBLE_EQ(bodies.neckRatio[1], 0.4);
  // The trunk has its points, those in its balls, and the cells at them.
  EXPECT_DOUBLE_EQ(extent(axis, bodies, 0), 2 + 0.25 + 0.125);
  EXPECT_DOUBLE_EQ(extent(axis, bodies, 1), 4 - 2 - 0.25 - 0.125);
}

TEST(Necks, LeaveALimbThatIsTooThick)
{
  EXPECT_EQ(bodiesOf(band(step), 0.39).neckRatio.size(), 1u);
  EXPECT_EQ(bodiesOf(band(step), 0).neckRatio.size(), 1u);
}

TEST(Necks, CutBetweenTwoThickEnds)
{
  const MedialAxis axis = band(dumbbell);
  const Bodies bodies = bodiesOf(axis, 0.95);
  ASSERT_EQ(bodies.neckRatio.size(), 2u);
  EXPECT_DOUBLE_EQ(bodies.neckRatio[1], 0.9);
  for (Index t = 0; t < medial::count(axis.cells.triangles); ++t)
  {
    const double x = axis.points[axis.cells.triangles[t][0]].x();
    EXPECT_TRUE(std::abs(x - 2) < 0.2 || bodies.ofCell[t] == (x < 2 ? 0 : 1));
  }
}

TEST(Necks, LeaveARim)
{
  // Thin along one side: a long cut for what would go.
  MedialAxis axis = band([](double) { return 0.2; });
  for (Index p = 0; p < medial::count(axis.points); ++p)
  {
    axis.radii[p] = axis.points[p].y() > 0.3 ? 0.001 : 0.01;
  }
  EXPECT_EQ(bodiesOf(axis, 0.5).neckRatio.size(), 1u);
}

TEST(Necks, GiveEveryPieceATrunkAndEveryCellABody)
{
  forEachShape([](Pipeline& p) {
    for (const double ratio : { 0.0, 0.5, 1.0 })
    {
      const Bodies bodies = bodiesOf(p.axis(), ratio);
      ASSERT_EQ(medial::count(bodies.ofCell), p.axis().cells.size());
      std::vector<char> used(bodies.neckRatio.size(), 0);
      for (const Index body : bodies.ofCell)
      {
        used.at(body) = 1;
      }
      EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
      for (const double value : bodies.neckRatio)
      {
        EXPECT_TRUE(value == 1 || value <= ratio);
      }
      if (ratio == 0)
      {
        EXPECT_EQ(medial::count(bodies.neckRatio), p.axis().betti[0]);
      }
    }
  });
}

TEST(Necks, ScaleWithTheAxisToTheLastBit)
{
  const MedialAxis axis = medial::medialAxis(medial::polarBalls(shapes::head().samples));
  const Bodies bodies = bodiesOf(axis, 0.9);
  EXPECT_GE(bodies.neckRatio.size(), 3u); // the sphere and its ears
  for (const int exponent : { -21, 21 })
  {
    const Bodies other = bodiesOf(pipelines::inUnits(axis, std::ldexp(1, exponent)), 0.9);
    EXPECT_EQ(other.ofCell, bodies.ofCell);
    EXPECT_EQ(other.neckRatio, bodies.neckRatio);
  }
}

TEST(Necks, BoundTheParts)
{
  const MedialAxis axis = band(step);
  const Bodies bodies = bodiesOf(axis, 0.5);
  const MedialParts parts = medial::decompose(axis, 0, {}, 0.5);
  ASSERT_EQ(parts.parts.size(), 2u);
  EXPECT_EQ(parts.partOfCell, bodies.ofCell);
  EXPECT_EQ(parts.parts[1].neckRatio, bodies.neckRatio[1]);
  EXPECT_EQ(parts.parts[1].level, 1);
  ASSERT_EQ(parts.contacts.size(), 1u);
  EXPECT_EQ(parts.contacts[0].points.size(), 5u); // straight across
  EXPECT_EQ(parts.contacts[0].parts, (std::vector<Index>{ 0, 1 }));
}

TEST(Necks, DontChangeTheBettiNumbers)
{
  // Any cells as bodies: closed sheets that are cut count as well.
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const MedialAxis axis = complexes::randomComplex(seed).axis();
    std::mt19937 random(seed);
    std::vector<Index> bodies(axis.cells.size());
    std::generate(bodies.begin(), bodies.end(), [&] { return static_cast<Index>(random() % 3); });
    const medial::AxisEdges edges = medial::axisEdges(axis.cells);
    medial::LivingCells living(axis.cells, edges, bodies);
    EXPECT_EQ(medial::bettiNumbers(living, medial::partition(living, 1)), axis.betti);
  }
}

TEST(Necks, KeepPruningExact)
{
  const auto expectExact = [](MedialAxis axis) {
    medial::PruneOptions options;
    options.neckRatio = 1;
    options.verifyTopology = true;
    options.schedule = { { medial::Measure::TriangleCount, 5, 0 },
      { medial::Measure::RelativeVolume, 0.3, 0 } };
    const medial::Pruned pruned = medial::prune(axis, options);
    EXPECT_EQ(pipelines::independentBetti(pruned.axis), pipelines::independentBetti(axis));
    EXPECT_EQ(pruned.keepReason.size(), pruned.parts.parts.size());
  };
  for (unsigned seed = 0; seed < 30; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    MedialAxis axis = complexes::randomComplex(seed).axis();
    shapes::Random random(seed);
    std::generate(
      axis.radii.begin(), axis.radii.end(), [&] { return shapes::uniform(random, 0.01, 1); });
    expectExact(axis);
  }
  expectExact(pipelines::of("two-hole plate").axis());
  expectExact(band(step));
}

TEST(Necks, LetALimbGoByHand)
{
  const MedialAxis axis = band(step);
  medial::PruneOptions options;
  options.neckRatio = 0.5;
  options.cellsToRemove = { axis.cells.size() - 1 };
  const medial::Pruned pruned = medial::prune(axis, options);
  EXPECT_EQ(pruned.axis.betti, axis.betti);
  ASSERT_EQ(pruned.parts.parts.size(), 1u);
  EXPECT_DOUBLE_EQ(pruned.parts.parts[0].upper.x(), 2.375);
}
