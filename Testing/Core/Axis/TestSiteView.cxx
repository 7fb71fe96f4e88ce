// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Axis/SiteView.h"

#include <cmath>
#include <vector>

using medial::Ball;
using medial::Index;
using medial::MedialAxis;
using medial::Point;
using medial::SiteView;
using pipelines::areaOf;
using pipelines::Pipeline;

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
