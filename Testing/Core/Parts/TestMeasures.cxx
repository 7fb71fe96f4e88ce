// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Axis/AxisEdges.h"
#include "Axis/Erosion.h"
#include "Base/BallTree.h"
#include "Base/Lists.h"
#include "Parts/Measures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

using medial::allMeasures;
using medial::Ball;
using medial::Index;
using medial::Measure;
using medial::MeasureTraits;
using medial::MedialAxis;
using medial::None;
using medial::Partition;
using medial::Point;
using medial::Pruned;
using medial::PruneOptions;
using pipelines::areaOf;
using pipelines::forEachShape;
using pipelines::Pipeline;

namespace
{
Partition partitionOf(const MedialAxis& axis)
{
  return medial::partition(axis.cells, medial::axisEdges(axis.cells));
}

std::vector<double> significance(
  const MedialAxis& axis, Measure measure, const medial::Execution& execution = {})
{
  const medial::AxisEdges edges = medial::axisEdges(axis.cells);
  const medial::LivingCells cells(axis.cells, edges);
  return medial::PartMeasures(axis, cells).significance(measure, partitionOf(axis), execution);
}
}

TEST(SiteView, OfACapsuleIsItsDiameter)
{
  // The sites of a line lie about it, so the farthest two of three are at least an equilateral
  // triangle's side apart.
  const MedialAxis& axis = pipelines::of("capsule").axis();
  ASSERT_GT(axis.cells.edges.size(), 0u);
  for (Index cell = axis.cells.firstEdge(); cell < axis.cells.firstTriangle(); ++cell)
  {
    EXPECT_LE(axis.siteViews[cell].lambda, 1 + 1e-6);
  }
  EXPECT_NEAR(significance(axis, Measure::Lambda).front(), 1, 0.05);
}

TEST(SiteView, OfAnEllipsoidIsLargestInTheMiddle)
{
  const std::vector<double> lambdas =
    significance(pipelines::of("ellipsoid").axis(), Measure::Lambda);
  EXPECT_NEAR(*std::max_element(lambdas.begin(), lambdas.end()), 1, 0.02); // its shortest diameter
}

TEST(Measures, AreThoseOfTheParts)
{
  forEachShape([](Pipeline& p) {
    for (const MeasureTraits& traits : allMeasures())
    {
      SCOPED_TRACE(traits.name);
      const std::vector<double> values = significance(p.axis(), traits.measure);
      ASSERT_EQ(values.size(), p.parts().parts.size());
      for (Index i = 0; i < medial::count(values); ++i)
      {
        EXPECT_NEAR(values[i], p.parts().value(traits.measure, i), 1e-12 * (1 + values[i]))
          << "part " << i;
      }
    }
  });
}

TEST(Measures, AreFoundByTheirNumbersAndNames)
{
  std::set<char> letters;
  std::set<std::string> arrays;
  for (const MeasureTraits& traits : allMeasures())
  {
    EXPECT_EQ(medial::findMeasure(static_cast<int>(traits.measure)), &traits);
    EXPECT_EQ(medial::findMeasure(traits.name), &traits);
    EXPECT_TRUE(letters.insert(traits.letter).second) << traits.name;
    EXPECT_TRUE(arrays.insert(traits.cellArray).second) << traits.name;
  }
  EXPECT_EQ(medial::findMeasure(-1), nullptr);
  EXPECT_EQ(medial::findMeasure(77), nullptr);
}

TEST(Measures, DecideInTheSchedule)
{
  Pipeline& p = pipelines::of("box");
  const Partition parts = partitionOf(p.axis());
  for (const MeasureTraits& traits : allMeasures())
  {
    SCOPED_TRACE(traits.name);
    const std::vector<double> values = significance(p.axis(), traits.measure);
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const double threshold = sorted[sorted.size() / 2];
    PruneOptions options;
    options.schedule = { { traits.measure, threshold, 1 } };
    options.removeHair = options.removeBranches = false;
    const Pruned pruned = medial::prune(p.axis(), options);
    EXPECT_EQ(pruned.axis.betti, p.shape.betti);
    EXPECT_GT(pruned.history.at(0).removed, 0);
    for (Index cell = 0; cell < medial::count(pruned.removedInIteration); ++cell)
    {
      if (pruned.removedInIteration[cell] != None)
      {
        EXPECT_LE(values[parts.partOfCell[cell]], threshold);
      }
    }
    options.schedule[0].passes = 0;
    EXPECT_EQ(medial::prune(p.axis(), options).axis.betti, p.shape.betti);
  }
}

TEST(Measures, SumToTheWholeWhereTheyShare)
{
  forEachShape([](Pipeline& p) {
    const MedialAxis& axis = p.axis();
    double area = 0, volume = 0, sheets = 0;
    for (Index i = 0; i < medial::count(p.parts().parts); ++i)
    {
      area += p.parts().value(Measure::Area, i);
      volume += p.parts().value(Measure::RelativeVolume, i);
    }
    for (Index cell = axis.cells.firstTriangle(); cell < axis.cells.size(); ++cell)
    {
      sheets += areaOf(axis, cell);
    }
    EXPECT_NEAR(area, sheets, 1e-9 * p.diagonal * p.diagonal);
    EXPECT_NEAR(volume, 1, 1e-9);
  });
}

TEST(Measures, RelativePoleVolumeCountsEveryPoleOfThePart)
{
  forEachShape([](Pipeline& p) {
    const MedialAxis& axis = p.axis();
    std::vector<std::set<Index>> poles(p.parts().parts.size());
    for (Index cell = 0; cell < axis.cells.size(); ++cell)
    {
      medial::forPoints(axis.cells, cell,
        [&](Index point) { poles[p.parts().partOfCell[cell]].insert(axis.ballOfPoint[point]); });
    }
    double solid = 0;
    for (std::size_t b = 0; b < axis.ballVolumes.size(); ++b)
    {
      solid += axis.ballVolumes[b];
      EXPECT_GE(axis.poleVolumes[b], 0);
      EXPECT_LE(axis.poleVolumes[b], axis.ballVolumes[b] * (1 + 1e-9));
    }
    for (Index i = 0; i < medial::count(poles); ++i)
    {
      double volume = 0;
      for (const Index ball : poles[i])
      {
        volume += ball == None ? 0 : axis.poleVolumes[ball];
      }
      EXPECT_NEAR(p.parts().value(Measure::RelativePoleVolume, i), volume / solid, 1e-9);
    }
  });
}

TEST(Measures, HausdorffDistanceIsWhatABruteForceSearchFinds)
{
  forEachShape([](Pipeline& p) {
    const MedialAxis& axis = p.axis();
    std::map<Index, std::set<Index>> partsOfBall;
    std::map<Index, Ball> balls;
    for (Index cell = 0; cell < axis.cells.size(); ++cell)
    {
      medial::forPoints(axis.cells, cell, [&](Index point) {
        if (axis.ballOfPoint[point] != None)
        {
          partsOfBall[axis.ballOfPoint[point]].insert(p.parts().partOfCell[cell]);
          balls[axis.ballOfPoint[point]] = { axis.points[point], axis.radii[point] };
        }
      });
    }
    std::vector<double> expected(p.parts().parts.size(), 0);
    for (const auto& [b, parts] : partsOfBall)
    {
      double least = INFINITY;
      for (const auto& [c, others] : partsOfBall)
      {
        const double protrusion =
          (balls[b].center - balls[c].center).norm() + balls[b].radius - balls[c].radius;
        least = parts == others && parts.size() == 1 ? least : std::min(least, protrusion);
      }
      if (parts.size() == 1 && least < INFINITY)
      {
        double& value = expected[*parts.begin()];
        value = std::max(value, least);
      }
    }
    for (Index i = 0; i < medial::count(expected) && expected.size() > 1; ++i)
    {
      EXPECT_NEAR(p.parts().value(Measure::HausdorffDistance, i), expected[i], 1e-12)
        << "part " << i;
    }
  });
}

TEST(Measures, HausdorffDistanceOfAFinIsItsHeight)
{
  // Balls of radius 1: those of the fin's rim are 3 away from the nearest of the sheet.
  complexes::Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 8, 8);
  drawing.sheet(Point(4, 2, 0), Point(0, 1, 0), Point(0, 0, 1), 4, 3);
  const MedialAxis axis = drawing.axis();
  const std::vector<double> values = significance(axis, Measure::HausdorffDistance);
  ASSERT_EQ(values.size(), 2u);
  EXPECT_NEAR(values[1], 3, 1e-12);
  EXPECT_NEAR(values[0], std::hypot(4, 2), 1e-12); // the sheet's corners from the fin's foot
}

TEST(Measures, HausdorffDistanceOfAllThereIsIsTheDiagonal)
{
  complexes::Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 4, 3);
  EXPECT_EQ(
    significance(drawing.axis(), Measure::HausdorffDistance).front(), Point(6, 5, 2).norm());
}

TEST(Measures, OfABallThatAnotherOneCoversIsNothing)
{
  const medial::BallTree tree(
    { { Point(0, 0, 0), 5 }, { Point(1, 0, 0), 1 }, { Point(9, 0, 0), 1 } }, { 0, 1, 2 });
  EXPECT_EQ(tree.protrusion({ Point(1, 0, 0), 1 }, 1), 0);
  EXPECT_EQ(tree.protrusion({ Point(9, 0, 0), 1 }, 2), 5);
  EXPECT_EQ(tree.protrusion({ Point(0, 0, 0), 5 }, 0), 5);
  EXPECT_EQ(medial::BallTree({ { Point(0, 0, 0), 5 } }, { 7 }).protrusion({ Point(0, 0, 0), 5 }, 7),
    INFINITY);
}

TEST(Measures, ScaleWithTheAxisToTheLastBit)
{
  const std::map<medial::Unit, double> exponents{ { medial::Unit::Count, 0 },
    { medial::Unit::Share, 0 }, { medial::Unit::Degrees, 0 }, { medial::Unit::Length, 1 },
    { medial::Unit::Area, 2 } };
  Pipeline& p = pipelines::of("two-hole plate");
  const MedialAxis scaled = pipelines::inUnits(p.axis(), 1024);
  for (const MeasureTraits& traits : allMeasures())
  {
    const double factor = std::pow(1024, exponents.at(traits.unit));
    EXPECT_EQ(significance(scaled, traits.measure),
      pipelines::times(significance(p.axis(), traits.measure), factor))
      << traits.name;
  }
}

TEST(Measures, DoNotChangeWithAMotion)
{
  Pipeline& p = pipelines::of("box");
  MedialAxis axis = p.axis();
  axis.points = shapes::moved(shapes::rotated(axis.points, 5), Point(3, -2, 1));
  for (const MeasureTraits& traits : allMeasures())
  {
    const std::vector<double> before = significance(p.axis(), traits.measure);
    const std::vector<double> after = significance(axis, traits.measure);
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      EXPECT_NEAR(after[i], before[i], 1e-9) << traits.name;
    }
  }
  const medial::Erosion burnt = medial::erosion(axis);
  for (std::size_t i = 0; i < burnt.ofPoint.size(); ++i)
  {
    EXPECT_NEAR(burnt.ofPoint[i], axis.erosion[i], 1e-6);
  }
}

TEST(Measures, DoNotChangeWithTheOrderOfTheSamples)
{
  // Diagonals of the faces do, and with them what is counted by triangles or points.
  const shapes::Shape& shape = pipelines::of("box").shape;
  const MedialAxis other = medial::medialAxis(medial::polarBalls(
    shapes::reordered(shape.samples, shapes::shuffledOrder(shape.samples.size(), 3))));
  for (const Measure measure : { Measure::RelativePoleVolume, Measure::MaximumRadius,
         Measure::Lambda, Measure::HausdorffDistance })
  {
    std::vector<double> before = significance(pipelines::of("box").axis(), measure);
    std::vector<double> after = significance(other, measure);
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      EXPECT_NEAR(after[i], before[i], 1e-9) << "measure " << static_cast<int>(measure);
    }
  }
}

TEST(Measures, AreTheSameOnManyThreads)
{
  Pipeline& p = pipelines::of("box");
  for (const MeasureTraits& traits : allMeasures())
  {
    EXPECT_EQ(significance(p.axis(), traits.measure, pipelines::threaded()),
      significance(p.axis(), traits.measure));
  }
}

TEST(Measures, OfSeveralPartsAddUpOrAreTheLargest)
{
  EXPECT_EQ(medial::together(Measure::Area, 2, 3), 5);
  EXPECT_EQ(medial::together(Measure::MaximumRadius, 2, 3), 3);
}
