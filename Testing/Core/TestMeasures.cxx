// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "AxisEdges.h"
#include "Measures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

using medial::allMeasures;
using medial::Ball;
using medial::Index;
using medial::Measure;
using medial::MeasureTraits;
using medial::MedialAxis;
using medial::MedialPart;
using medial::None;
using medial::Partition;
using medial::Point;
using medial::Pruned;
using medial::PruneOptions;
using medial::SiteView;
using pipelines::forEachShape;
using pipelines::Pipeline;

namespace
{
Partition partitionOf(const MedialAxis& axis)
{
  return medial::partition(axis.cells, medial::axisEdges(axis.cells));
}

double areaOf(const MedialAxis& axis, Index cell)
{
  const medial::Triangle& t = axis.cells.triangles[cell - axis.cells.firstTriangle()];
  const Point& a = axis.points[t[0]];
  return 0.5 * (axis.points[t[1]] - a).cross(axis.points[t[2]] - a).norm();
}

std::vector<double> significance(const MedialAxis& axis, Measure measure)
{
  return medial::PartMeasures(axis).significance(measure, partitionOf(axis));
}
}

TEST(SiteView, IsThatOfTheFarthestTwo)
{
  const SiteView two = medial::siteView(Point(0, 0, 0), { Point(1, 0, 0), Point(0, 2, 0) });
  EXPECT_NEAR(two.objectAngle, 90, 1e-12);
  EXPECT_NEAR(two.lambda, std::sqrt(5), 1e-12);
  const SiteView three =
    medial::siteView(Point(0, 0, 0), { Point(1, 0, 0), Point(0, 1, 0), Point(-3, 0, 0) });
  EXPECT_NEAR(three.objectAngle, 180, 1e-12);
  EXPECT_NEAR(three.lambda, 4, 1e-12);
}

TEST(SiteView, FromItsCornersIsThatOfThePointsWhereTheirSpheresMeet)
{
  const std::vector<Point> sites{ Point(0.3, 0.2, 1), Point(0.3, 0.2, -1) };
  const auto through = [&](double x, double y) {
    return Ball{ Point(x, y, 0), (Point(x, y, 0) - sites[0]).norm() };
  };
  const std::vector<Ball> corners{ through(0, 0), through(2, 0.1), through(0.4, 1.5) };
  const Point centroid = (corners[0].center + corners[1].center + corners[2].center) / 3;
  const SiteView expected = medial::siteView(centroid, sites);
  const SiteView view = medial::siteView(corners);
  EXPECT_NEAR(view.objectAngle, expected.objectAngle, 1e-9);
  EXPECT_NEAR(view.lambda, 2, 1e-12);
  // Two equal balls of radius 5 at the distance 6 meet in a circle of radius 4.
  const SiteView line = medial::siteView({ { Point(0, 0, -3), 5 }, { Point(0, 0, 3), 5 } });
  EXPECT_NEAR(line.objectAngle, 180, 1e-12);
  EXPECT_NEAR(line.lambda, 8, 1e-12);
  const SiteView point = medial::siteView({ { Point(1, 2, 3), 5 } });
  EXPECT_EQ(point.objectAngle, 180);
  EXPECT_EQ(point.lambda, 10);
}

TEST(SiteView, IsNothingWhereTheSpheresDoNotMeet)
{
  const std::vector<Ball> apart{ { Point(0, 0, 0), 1 }, { Point(9, 0, 0), 1 },
    { Point(0, 9, 0), 1 } };
  EXPECT_EQ(medial::siteView(apart).lambda, 0);
  EXPECT_EQ(medial::siteView({ apart[0], apart[1] }).lambda, 0);
  EXPECT_EQ(medial::siteView({ apart[0], apart[1] }).objectAngle, 0);
}

TEST(SiteView, OfThePlateIsStraightAcrossIt)
{
  // Its middle sheet has the two faces on its two sides, 0.4 apart. No point of a face is farther from
  // a sample than the spacing: sites are at most that far aside, and those where balls meet between
  // samples lie that much deeper.
  Pipeline& p = pipelines::of("two-hole plate");
  const MedialAxis& axis = p.axis();
  const double radius = 0.2, spacing = p.shape.spacing;
  const double least = 2 * std::atan2(radius, spacing) * 180 / M_PI;
  double area = 0, flat = 0, lambda = 0;
  for (Index cell = axis.cells.firstTriangle(); cell < axis.cells.size(); ++cell)
  {
    const SiteView& view = axis.siteViews[cell];
    const double size = areaOf(axis, cell);
    area += size;
    if (view.objectAngle >= least)
    {
      flat += size;
      lambda += size * view.lambda;
      EXPECT_LT(view.lambda, 2 * std::hypot(radius, spacing));
    }
  }
  EXPECT_GT(flat, 0.95 * area);
  EXPECT_GT(lambda / flat, 2 * std::sqrt(radius * radius - spacing * spacing));
}

TEST(SiteView, OfABoxTellsTheSeamsFromTheMiddle)
{
  // Sheets along the edges see two sides at right angles, the one in the middle two opposite sides at
  // a distance of 1. It has an area of 2 x 1.
  Pipeline& p = pipelines::of("box");
  const MedialAxis& axis = p.axis();
  double seams = 0, middle = 0, other = 0;
  for (Index cell = axis.cells.firstTriangle(); cell < axis.cells.size(); ++cell)
  {
    const SiteView& view = axis.siteViews[cell];
    const double size = areaOf(axis, cell);
    const bool isMiddle = view.objectAngle > 160;
    const bool isSeam = std::abs(view.objectAngle - 90) < 15;
    (isMiddle ? middle : isSeam ? seams : other) += size;
    EXPECT_TRUE(!isMiddle || std::abs(view.lambda - 1) < 0.02) << view.lambda;
  }
  EXPECT_NEAR(middle, 2, 0.2);
  EXPECT_LT(other, 0.05 * (seams + middle));
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
    const std::vector<MedialPart>& parts = p.parts().parts;
    const auto expectValues = [&](Measure measure, double MedialPart::*value) {
      SCOPED_TRACE(testing::Message() << "measure " << static_cast<int>(measure));
      const std::vector<double> values = significance(p.axis(), measure);
      ASSERT_EQ(values.size(), parts.size());
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        EXPECT_NEAR(values[i], parts[i].*value, 1e-12 * (1 + values[i])) << "part " << i;
      }
    };
    expectValues(Measure::RelativeVolume, &MedialPart::relativeVolume);
    expectValues(Measure::Area, &MedialPart::area);
    expectValues(Measure::MeanRadius, &MedialPart::meanRadius);
    expectValues(Measure::MaximumRadius, &MedialPart::maximumRadius);
  });
}

TEST(Measures, AreFoundByTheirNumbers)
{
  for (const MeasureTraits& traits : allMeasures())
  {
    EXPECT_EQ(medial::findMeasure(static_cast<int>(traits.measure)), &traits);
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

TEST(Measures, OfSeveralPartsAddUpOrAreTheLargest)
{
  EXPECT_EQ(medial::together(Measure::Area, 2, 3), 5);
  EXPECT_EQ(medial::together(Measure::MaximumRadius, 2, 3), 3);
}
