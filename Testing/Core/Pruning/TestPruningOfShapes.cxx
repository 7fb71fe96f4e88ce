// SPDX-License-Identifier: BSD-3-Clause
#include "Numbers.h"
#include "PruningTest.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

using medial::Index;
using medial::KeepReason;
using medial::Measure;
using medial::MedialAxis;
using medial::Point;
using medial::Pruned;
using medial::PruneOptions;
using pipelines::Pipeline;
using pruningTest::expectBetti;
using pruningTest::once;

namespace
{
/// The share of the crust's area that is farther outside the shape's true boundary than from, in
/// spacings, and not farther than to.
double shareOfArea(const shapes::Shape& shape, const medial::Crust& crust, double from, double to)
{
  double all = 0, between = 0;
  for (Index f = 0; f < medial::count(crust.triangles); ++f)
  {
    const auto corner = [&](int k) -> const Point& { return crust.points[crust.triangles[f][k]]; };
    const Point &a = corner(0), &b = corner(1), &c = corner(2);
    const double area = (b - a).cross(c - a).norm();
    all += area;
    const double outside = shape.outside((a + b + c) / 3) / shape.spacing;
    between += outside > from && outside <= to ? area : 0;
  }
  return between / all;
}
}

TEST(Pruning, TakesNoiseAndLeavesTheShape)
{
  // Paper Figure 11: noise on a part of the object, here on one half of an ellipsoid.
  shapes::Shape shape = shapes::ellipsoid(0.08);
  RecordProperty("seed", 11);
  shapes::Random random(11);
  for (Point& sample : shape.samples)
  {
    const Point normal = shapes::unit(Point(sample.x() / 9, sample.y() / 4, sample.z()));
    sample += (sample.x() > 0 ? shapes::normal(random, 0.7 * shape.spacing) : 0) * normal;
  }
  Pipeline p(shape);
  ASSERT_EQ(p.axis().betti, shape.betti);
  PruneOptions options = once(Measure::TriangleCount, 5);
  options.schedule.push_back({ Measure::TriangleCount, 5, 0 });
  options.schedule.push_back({ Measure::RelativeVolume, 0.01, 0 });
  const Pruned pruned = medial::prune(p.axis(), options);
  expectBetti(pruned, shape.betti);
  EXPECT_LE(10 * pruned.parts.parts.size(), p.parts().parts.size());
  const medial::Crust after = medial::powerCrust(p.balls(), medial::keptBalls(pruned.axis));
  EXPECT_GE(shareOfArea(shape, after, -2, 2), 0.99);
  // What stood out has gone.
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_LT(
    shareOfArea(shape, after, 0.5, infinity), shareOfArea(shape, p.crust(), 0.5, infinity) / 2);
}

TEST(Pruning, LeavesTheMiddleOfABoxAsLevelTwo)
{
  Pipeline& p = pipelines::of("box");
  const Pruned pruned = medial::prune(p.axis(), once(Measure::TriangleCount, 5));
  int middles = 0;
  for (std::size_t i = 0; i < pruned.parts.parts.size(); ++i)
  {
    const medial::MedialPart& part = pruned.parts.parts[i];
    if (part.dimension != 2)
    {
      continue;
    }
    EXPECT_TRUE(part.level == 1 || part.level == 2);
    EXPECT_EQ(
      pruned.keepReason[i], part.level == 1 ? KeepReason::AboveThreshold : KeepReason::InnerLevel);
    if (part.level == 2)
    {
      // The rectangle in the middle: 2 x 1, flat, radius 0.5.
      ++middles;
      EXPECT_NEAR(pruned.parts.value(Measure::Area, i), 2, 0.2);
      EXPECT_LT(std::max(-part.lower.z(), part.upper.z()), 0.05);
      EXPECT_NEAR(pruned.parts.value(Measure::MeanRadius, i), 0.5, 0.02);
    }
  }
  EXPECT_EQ(middles, 1);
}

TEST(Pruning, LeavesTheThirteenPartsOfFigure5)
{
  const MedialAxis axis = complexes::boxAxis(8).axis();
  const Pruned pruned = medial::prune(axis, once(Measure::TriangleCount, 5));
  const auto atLevel = [&pruned](int level) {
    return std::count_if(pruned.parts.parts.begin(), pruned.parts.parts.end(),
      [level](const medial::MedialPart& part) { return part.level == level; });
  };
  EXPECT_EQ(pruned.parts.parts.size(), 13u);
  EXPECT_EQ(atLevel(1), 12);
  EXPECT_EQ(atLevel(2), 1);
}

/// How many sheets are left of a sharp box, at the border and inside, after the slivers have gone.
std::pair<int, int> sheetsOfABox(const std::vector<Point>& samples)
{
  const MedialAxis axis = medial::medialAxis(medial::polarBalls(samples));
  EXPECT_TRUE(axis.certificate);
  const Pruned pruned = medial::prune(axis, once(Measure::TriangleCount, 5));
  expectBetti(pruned, { 1, 0, 0 });
  std::pair<int, int> result;
  for (const medial::MedialPart& part : pruned.parts.parts)
  {
    ++(part.level == 1 ? result.first : result.second);
  }
  return result;
}

// Exact on most samplings, see the known limits in Filters/README.md: on 19 of 24, so that 48 samplings can give a few
// more or fewer than 37. Without cuts at the corners none is: 4 to 11 sheets at the border.
TEST(Pruning, LeavesTheThirteenPartsOfASampledBoxHoweverItLies)
{
  int exact = 0, all = 0;
  for (const double spacing : { 0.07, 0.1, 0.14 })
  {
    for (unsigned seed = 1; seed < 9; ++seed)
    {
      const std::vector<Point> samples = shapes::box(spacing, seed).samples;
      for (const bool turned : { false, true })
      {
        SCOPED_TRACE(testing::Message()
          << "spacing " << spacing << ", seed " << seed << (turned ? ", turned" : ""));
        const auto [outer, inner] = sheetsOfABox(turned ? shapes::rotated(samples, seed) : samples);
        exact += outer == 12 && inner == 1;
        ++all;
        EXPECT_NEAR(outer, 12, 2);
        EXPECT_NEAR(inner, 1, 1);
      }
    }
  }
  EXPECT_GT(3 * exact, 2 * all);
}
