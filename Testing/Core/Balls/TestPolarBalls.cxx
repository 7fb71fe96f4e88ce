// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Balls/PolarBalls.h"
#include "Base/Lists.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

using medial::Index;
using medial::None;
using medial::Point;
using medial::PolarBalls;
using medial::Side;
using pipelines::forEachShape;
using pipelines::howMany;
using pipelines::Pipeline;

namespace
{
double sum(const std::vector<double>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.0);
}

bool isIn(const medial::IndexLists::View& list, Index item)
{
  return std::find(list.begin(), list.end(), item) != list.end();
}

double power(const Point& place, const medial::Ball& ball)
{
  return (place - ball.center).squaredNorm() - ball.radius * ball.radius;
}
}

TEST(PolarBalls, AreEmptyOfSamples)
{
  forEachShape([](Pipeline& p) {
    for (const medial::Ball& ball : p.balls().balls)
    {
      ASSERT_EQ(validators::pointsInside(ball, p.shape.samples, 1e-9 * p.diagonal), 0)
        << ball.center.transpose() << " radius " << ball.radius;
    }
  });
}

namespace
{
void expectToPassThroughSamples(const PolarBalls& balls, double tolerance)
{
  ASSERT_EQ(balls.ballSamples.size(), medial::count(balls.balls));
  for (Index b = 0; b < balls.ballSamples.size(); ++b)
  {
    for (const Index s : balls.ballSamples[b])
    {
      const double distance = (balls.samples[s] - balls.balls[b].center).norm();
      ASSERT_NEAR(distance, balls.balls[b].radius, tolerance);
    }
  }
}
}

TEST(PolarBalls, PassThroughTheirSamplesUpToTheirPrecision)
{
  forEachShape([](Pipeline& p) { expectToPassThroughSamples(p.balls(), 1e-7 * p.diagonal); });
}

TEST(PolarBalls, PassThroughTheirSamplesWhereTheseAreExact)
{
  forEachShape([](Pipeline& p) {
    expectToPassThroughSamples(
      medial::polarBallsAndSamples(p.shape.samples, { 0, 0 }).balls, 1e-9 * p.diagonal);
  });
}

TEST(PolarBalls, HaveFourSamplesInOrderOrTouchAGuard)
{
  forEachShape([](Pipeline& p) {
    const PolarBalls& balls = p.balls();
    for (Index b = 0; b < balls.ballSamples.size(); ++b)
    {
      const auto samples = balls.ballSamples[b];
      ASSERT_TRUE(samples.size() >= 4 || balls.touchesGuard[b]);
      ASSERT_TRUE(std::is_sorted(samples.begin(), samples.end(), std::less_equal<>()));
    }
  });
}

TEST(PolarBalls, OfASampleAreOnItsTwoSides)
{
  forEachShape([](Pipeline& p) {
    const PolarBalls& balls = p.balls();
    for (Index s = 0; s < medial::count(p.shape.samples); ++s)
    {
      const Index inner = balls.innerBall[s], outer = balls.outerBall[s];
      ASSERT_TRUE(
        inner == None || (isIn(balls.ballSamples[inner], s) && balls.sides[inner] != Side::Outer));
      ASSERT_TRUE(
        outer == None || (isIn(balls.ballSamples[outer], s) && balls.sides[outer] != Side::Inner));
      if (p.shape.smooth)
      {
        ASSERT_NE(inner, None) << "sample " << s;
        ASSERT_NE(outer, None) << "sample " << s;
      }
    }
  });
}

TEST(PolarBalls, AreLabelledAsTheSolidSays)
{
  forEachShape([](Pipeline& p) {
    const PolarBalls& balls = p.balls();
    Index wrong = 0;
    for (std::size_t b = 0; b < balls.balls.size(); ++b)
    {
      const double outside = p.shape.outside(balls.balls[b].center);
      const bool clear = std::abs(outside) > 1e-9 * p.diagonal; // a flat cell's centre may be on it
      wrong +=
        clear && balls.sides[b] != Side::Hidden && (outside > 0) != (balls.sides[b] == Side::Outer);
    }
    EXPECT_EQ(wrong, 0);
  });
}

TEST(PolarBalls, ThatTouchAGuardAreOuter)
{
  forEachShape([](Pipeline& p) {
    for (std::size_t b = 0; b < p.balls().balls.size(); ++b)
    {
      EXPECT_FALSE(p.balls().touchesGuard[b] && p.balls().sides[b] == Side::Inner);
    }
  });
}

TEST(PolarBalls, VolumesOfTheInnerSumToTheSolids)
{
  forEachShape([](Pipeline& p) {
    const PolarBalls& balls = p.balls();
    EXPECT_NEAR(sum(balls.volumes) / p.shape.volume, 1, 0.06);
    for (std::size_t b = 0; b < balls.balls.size(); ++b)
    {
      EXPECT_GE(balls.volumes[b], 0);
      EXPECT_TRUE(balls.sides[b] == Side::Inner || balls.volumes[b] == 0);
    }
  });
}

TEST(PolarBalls, OfASphereAreOneInside)
{
  const PolarBalls& balls = pipelines::of("sphere").balls();
  EXPECT_EQ(howMany(balls, Side::Inner), 1);
  const Index inner = balls.innerBall[0];
  ASSERT_NE(inner, None);
  EXPECT_LT(balls.balls[inner].center.norm(), 1e-12);
  EXPECT_NEAR(balls.balls[inner].radius, 1, 1e-12);
  EXPECT_EQ(balls.ballSamples[inner].size(), medial::count(balls.samples));
}

TEST(PolarBalls, AreHiddenWhereNoCellHasThem)
{
  forEachShape([](Pipeline& p) {
    const PolarBalls& balls = p.balls();
    std::vector<char> used(balls.balls.size(), 0);
    for (const medial::Tetrahedron& cell : balls.triangulation.cells)
    {
      for (const Index corner : cell)
      {
        used.at(static_cast<std::size_t>(corner)) = 1;
      }
    }
    for (std::size_t b = 0; b < used.size(); ++b)
    {
      EXPECT_EQ(used[b] == 0, balls.sides[b] == Side::Hidden) << "ball " << b;
    }
  });
}

TEST(PolarBalls, CellsFormAnOrientedTriangulationOfABall)
{
  forEachShape([](Pipeline& p) {
    const PolarBalls& balls = p.balls();
    std::map<medial::Triangle, int> sides; // sum of orientations of the cells at a triangle
    std::map<medial::Triangle, int> uses;
    for (const medial::Tetrahedron& cell : balls.triangulation.cells)
    {
      for (int i = 0; i < 4; ++i)
      {
        medial::Triangle t = medial::facet(cell, i);
        const int inversions = (t[0] > t[1]) + (t[0] > t[2]) + (t[1] > t[2]);
        std::sort(t.begin(), t.end());
        sides[t] += inversions % 2 == 0 ? 1 : -1;
        ++uses[t];
      }
    }
    validators::Complex hull;
    for (const auto& [triangle, count] : uses)
    {
      ASSERT_TRUE(count == 1 || (count == 2 && sides[triangle] == 0));
      if (count == 1)
      {
        hull.triangles.push_back(triangle);
      }
    }
    EXPECT_EQ(validators::bettiNumbers(hull), (medial::Betti{ 1, 0, 1 }));
  });
}

TEST(PolarBalls, CellsAreNotTurnedInsideOut)
{
  forEachShape([](Pipeline& p) {
    const PolarBalls& balls = p.balls();
    for (const medial::Tetrahedron& c : balls.triangulation.cells)
    {
      const auto at = [&](int i) { return balls.balls[c[i]].center; };
      const double largest =
        std::max({ (at(1) - at(0)).norm(), (at(2) - at(0)).norm(), (at(3) - at(0)).norm() });
      // Centres are rounded once more when they leave the frame they were made in.
      ASSERT_GE(validators::orientation(at(0), at(1), at(2), at(3)),
        -1e-14 * p.diagonal * largest * largest);
    }
  });
}

TEST(PolarBalls, CellsAreRegular)
{
  // Where four centres are far from flat, no ball has less power at the point equal to theirs.
  for (const char* name : { "capsule", "torus", "ellipsoid" })
  {
    SCOPED_TRACE(name);
    Pipeline& p = pipelines::of(name);
    const PolarBalls& balls = p.balls();
    int checked = 0;
    for (const medial::Tetrahedron& c : balls.triangulation.cells)
    {
      Eigen::Matrix3d rows;
      Point right;
      const medial::Ball& first = balls.balls[c[0]];
      for (int k = 0; k < 3; ++k)
      {
        const medial::Ball& other = balls.balls[c[k + 1]];
        rows.row(k) = 2 * (other.center - first.center).transpose();
        right[k] = (other.center - first.center).squaredNorm() - other.radius * other.radius +
          first.radius * first.radius;
      }
      if (std::abs(rows.determinant()) < 1e-3 * std::pow(p.diagonal, 3))
      {
        continue;
      }
      const Point place = first.center + rows.fullPivLu().solve(right);
      ++checked;
      for (const medial::Ball& other : balls.balls)
      {
        ASSERT_GE(power(place, other), power(place, first) - 1e-7 * p.diagonal * p.diagonal);
      }
    }
    EXPECT_GT(checked, 10);
  }
}

TEST(PolarBalls, SpacingIsThatOfTheSamples)
{
  forEachShape([](Pipeline& p) {
    const double spacing = validators::meanSpacing(p.shape.samples);
    EXPECT_NEAR(p.balls().spacing / spacing, 1, 1e-9);
  });
}

TEST(PolarBalls, QualityTellsSmoothFromSharp)
{
  forEachShape([](Pipeline& p) {
    std::vector<double> quality = p.ballsAndSamples().samples.quality;
    ASSERT_EQ(quality.size(), p.shape.samples.size());
    for (const double q : quality)
    {
      ASSERT_TRUE(q >= -1 && q <= 1);
    }
    std::nth_element(quality.begin(), quality.begin() + quality.size() / 2, quality.end());
    EXPECT_GT(quality[quality.size() / 2], 0.9);
  });
  const Pipeline& box = pipelines::of("box");
  EXPECT_LT(pipelines::of("box").ballsAndSamples().samples.quality[0], 0.5)
    << box.shape.samples[0].transpose();
}

TEST(PolarBalls, CountRepeatedSamplesOnce)
{
  const std::vector<Point> once = shapes::capsule(0.2).samples;
  std::vector<Point> twice = once;
  twice.insert(twice.end(), once.begin(), once.begin() + 40);
  const PolarBalls a = medial::polarBalls(once);
  const medial::PolarBallsAndSamples made = medial::polarBallsAndSamples(twice);
  const PolarBalls& b = made.balls;
  EXPECT_EQ(
    pipelines::Bytes().add(a.balls).add(a.sides).add(a.ballSamples).add(a.triangulation.cells).text,
    pipelines::Bytes()
      .add(b.balls)
      .add(b.sides)
      .add(b.ballSamples)
      .add(b.triangulation.cells)
      .text);
  for (Index s = 0; s < medial::count(twice); ++s)
  {
    const Index original = s < medial::count(once) ? None : s - medial::count(once);
    EXPECT_EQ(made.samples.duplicateOf[s], original);
    EXPECT_EQ(made.samples.quality[s], made.samples.quality[original == None ? s : original]);
    EXPECT_EQ(b.innerBall[s], b.innerBall[original == None ? s : original]);
  }
}

TEST(PolarBalls, OfACubesCornersAreAllOutside)
{
  // A corner of three faces sees its two farthest Voronoi vertices outside.
  const PolarBalls balls = medial::polarBalls(shapes::gridCube(2));
  EXPECT_EQ(howMany(balls, Side::Inner), 0);
  EXPECT_GT(howMany(balls, Side::Outer), 0);
  EXPECT_EQ(std::count(balls.innerBall.begin(), balls.innerBall.end(), None), 8);
}

TEST(PolarBalls, OfACubesFaceCentersAreOneInside)
{
  const PolarBalls balls = medial::polarBalls(shapes::gridCube(3));
  EXPECT_EQ(howMany(balls, Side::Inner), 1);
  const Index center = 4; // of the lowest face
  ASSERT_NE(balls.innerBall[center], None);
  EXPECT_EQ(balls.ballSamples[balls.innerBall[center]].size(), 6);
  EXPECT_EQ(balls.balls[balls.innerBall[center]].center, Point(1, 1, 1));
  EXPECT_EQ(balls.balls[balls.innerBall[center]].radius, 1);
}

TEST(PolarBalls, OfAGridAreFiniteAndEmpty)
{
  const std::vector<Point> samples = shapes::gridCube(7);
  const PolarBalls balls = medial::polarBalls(samples);
  for (const medial::Ball& ball : balls.balls)
  {
    ASSERT_TRUE(ball.center.allFinite() && std::isfinite(ball.radius));
    ASSERT_EQ(validators::pointsInside(ball, samples, 1e-8), 0);
  }
  EXPECT_NEAR(sum(balls.volumes) / 216, 1, 0.01);
}

TEST(PolarBalls, OfAnOpenSurfaceAreStillEmpty)
{
  const std::vector<Point> samples = shapes::openBowl();
  const PolarBalls balls = medial::polarBalls(samples);
  EXPECT_EQ(balls.innerBall.size(), samples.size());
  for (const medial::Ball& ball : balls.balls)
  {
    ASSERT_EQ(validators::pointsInside(ball, samples, 1e-8), 0);
  }
}
