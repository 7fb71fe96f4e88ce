// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/MedialAxis.h"
#include "Balls/DistinctSamples.h"
#include "Balls/PolarBalls.h"
#include "Balls/PowerShape.h"
#include "Base/Errors.h"
#include "Base/NearDuplicates.h"
#include "PoissonDisk.h"
#include "Shapes.h"
#include "Validators.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

using medial::Index;
using medial::MergeOptions;
using medial::None;
using medial::Point;

namespace
{
/// Each point several times, with coordinates that differ by at most `distance`, in random order.
std::vector<Point> soup(const std::vector<Point>& points, int copies, double distance)
{
  shapes::Random random(3);
  const Point corner = Point::Constant(0.5 * distance);
  std::vector<Point> result;
  for (const Point& point : points)
  {
    for (int i = 0; i < copies; ++i)
    {
      result.push_back(point + shapes::uniformInBox(random, corner));
    }
  }
  return shapes::reordered(result, shapes::shuffledOrder(result.size(), 4));
}

/// The places of the samples that count.
std::set<std::array<double, 3>> kept(const std::vector<Point>& samples, const MergeOptions& options)
{
  std::set<std::array<double, 3>> result;
  for (const Index i : medial::distinctSamples(samples, options).ids)
  {
    result.insert({ samples[i].x(), samples[i].y(), samples[i].z() });
  }
  return result;
}
}

TEST(NearDuplicates, AreCopiesOfTheFirstOfThem)
{
  const std::vector<Point> points{ { 0, 0, 0 }, { 0, 0, 1e-3 }, { 1, 0, 0 }, { 1, 0, 1e-3 },
    { 1, 1e-3, 0 }, { 2, 0, 0 } };
  EXPECT_EQ(
    medial::nearDuplicates(points, 2e-3), (std::vector<Index>{ None, 0, None, 2, 2, None }));
  EXPECT_EQ(medial::nearDuplicates(points, 9e-4), std::vector<Index>(6, None));
  EXPECT_EQ(medial::nearDuplicates(points, 0), std::vector<Index>(6, None));
}

TEST(NearDuplicates, AreNotMadeOfDenseSamples)
{
  std::vector<Point> chain; // and at its end one that stands apart, with a copy
  for (int i = 0; i < 1000; ++i)
  {
    chain.emplace_back(i, 0, 0);
  }
  chain.emplace_back(2000, 0, 0);
  chain.emplace_back(2000, 1, 0);
  for (const double tolerance : { 1.0, 1.5, 7.0, 50.0 })
  {
    std::vector<Index> expected(1002, None);
    expected[1001] = 1000;
    EXPECT_EQ(medial::nearDuplicates(chain, tolerance), expected) << tolerance;
  }
  for (const double factor : { 0.2, 1.0, 3.0, 1e6 })
  {
    const shapes::Shape torus = shapes::torus();
    const std::vector<Index> copies = medial::nearDuplicates(torus.samples, factor * torus.spacing);
    EXPECT_EQ(std::count(copies.begin(), copies.end(), None), medial::count(copies)) << factor;
  }
}

TEST(NearDuplicates, DependOnNeitherOrderNorUnit)
{
  const std::vector<Point> samples = soup(shapes::ellipsoid().samples, 3, 1e-6);
  const auto expected = kept(samples, { 2e-6, 0 });
  EXPECT_EQ(expected.size(), samples.size() / 3);
  for (unsigned seed = 0; seed < 5; ++seed)
  {
    const std::vector<Index> order = shapes::shuffledOrder(samples.size(), seed);
    EXPECT_EQ(kept(shapes::reordered(samples, order), { 2e-6, 0 }), expected);
  }
  const double unit = 1 << 20;
  const medial::DistinctSamples small = medial::distinctSamples(samples, { 2e-6, 0 });
  const medial::DistinctSamples large =
    medial::distinctSamples(shapes::scaled(samples, unit), { unit * 2e-6, 0 });
  EXPECT_EQ(small.duplicateOf, large.duplicateOf);
}

TEST(NearDuplicates, OfASoupOfTrianglesGiveTheSolid)
{
  const shapes::Shape torus = shapes::torus();
  const std::vector<Point> samples = soup(torus.samples, 6, 2e-7);
  const medial::PolarBallsAndSamples made = medial::polarBallsAndSamples(samples);
  const medial::MedialAxis axis = medial::medialAxis(made.balls);
  EXPECT_EQ(axis.betti, torus.betti);
  const std::vector<Index>& duplicateOf = made.samples.duplicateOf;
  EXPECT_EQ(std::count(duplicateOf.begin(), duplicateOf.end(), None), medial::count(torus.samples));
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const Index original = duplicateOf[i];
    if (original != None)
    {
      EXPECT_EQ(duplicateOf[original], None);
      EXPECT_LE((samples[i] - samples[original]).norm(), made.samples.mergeTolerance);
      EXPECT_EQ(made.balls.innerBall[i], made.balls.innerBall[original]);
    }
  }
  ASSERT_FALSE(made.samples.warnings.empty());
  const medial::Warning& warning = made.samples.warnings.back();
  EXPECT_EQ(warning.code, "merged_duplicates");
  EXPECT_EQ(warning.count, 5 * medial::count(torus.samples));
  EXPECT_TRUE(warning.place);
}

TEST(NearDuplicates, AreFoundAtAnyDistanceFarBelowTheSpacing)
{
  const shapes::Shape torus = shapes::torus();
  for (const double distance : { 1e-9, 1e-7, 1e-5, 1e-4, 1e-3 })
  {
    for (int copies = 2; copies <= 6; ++copies)
    {
      SCOPED_TRACE(medial::text(copies, " copies at ", distance, " spacings"));
      const std::vector<Point> samples = soup(torus.samples, copies, distance * torus.spacing);
      const medial::DistinctSamples distinct = medial::distinctSamples(samples);
      EXPECT_EQ(distinct.ids.size(), torus.samples.size());
      EXPECT_EQ(distinct.nearDuplicates, (copies - 1) * medial::count(torus.samples));
      for (const double unit : { 1e-20, 1.0, 1e6 })
      {
        const std::vector<Point> moved =
          shapes::scaled(shapes::moved(samples, Point(0.5, -3, 2)), unit);
        EXPECT_EQ(medial::distinctSamples(moved).ids.size(), torus.samples.size()) << unit;
      }
    }
  }
}

TEST(NearDuplicates, AtAnyDistanceGiveTheSolid)
{
  const shapes::Shape torus = shapes::torus();
  for (const double distance : { 1e-7, 1e-5, 1e-3 })
  {
    const std::vector<Point> samples = soup(torus.samples, 6, distance * torus.spacing);
    const medial::PolarBallsAndSamples made = medial::polarBallsAndSamples(samples);
    EXPECT_EQ(medial::powerShape(made.balls).betti, torus.betti) << distance;
    ASSERT_EQ(made.samples.warnings.size(), 1u);
    EXPECT_EQ(made.samples.warnings[0].code, "merged_duplicates");
  }
}

TEST(NearDuplicates, FollowTheSpacingOfEachPlace)
{
  // Seen from near it, a sphere is dense on one side: the spacings differ by the factor 16 here.
  const Point eye(0.6, 0, 0);
  const shapes::Shape sphere = shapes::sphere();
  std::vector<Point> sparse, doubled;
  shapes::Random random(5);
  for (const Point& p : sphere.samples)
  {
    const Point seen = (p - eye) / (p - eye).squaredNorm();
    const double distance = 1e-3 * sphere.spacing / (p - eye).squaredNorm();
    sparse.push_back(seen);
    doubled.push_back(seen);
    doubled.push_back(seen + distance * shapes::uniformInBox(random, Point::Constant(1)));
  }
  EXPECT_EQ(medial::distinctSamples(sparse).ids.size(), sparse.size());
  EXPECT_EQ(medial::distinctSamples(doubled).ids.size(), sparse.size());
}

TEST(NearDuplicates, AreNotMadeOfTinyObjects)
{
  std::vector<Point> samples;
  for (const Index size : { 49, 50 })
  {
    std::vector<Point> object = shapes::scaled(shapes::sphere().samples, 1e-4);
    object.resize(size);
    object = shapes::moved(object, Point(size, 0, 0));
    samples.insert(samples.end(), object.begin(), object.end());
  }
  EXPECT_EQ(medial::distinctSamples(samples).ids.size(), 51u); // 49 are too few for an object
  std::vector<Point> chain;
  for (int i = 0; i < 12; ++i)
  {
    chain.emplace_back(std::pow(150, i), 0, 0);
  }
  EXPECT_EQ(medial::clusteredDuplicates(chain), std::vector<Index>(12, None));
}

TEST(NearDuplicates, AreNotWarnedOfWhereTheyAreFewOrTheVerySame)
{
  std::vector<Point> samples = shapes::torus().samples;
  const auto warnings = [&samples] {
    const medial::DistinctSamples distinct = medial::distinctSamples(samples);
    return medial::mergeWarnings(samples, distinct).size();
  };
  EXPECT_EQ(warnings(), 0u);
  samples.push_back(samples[0] + Point(1e-8, 0, 0));
  EXPECT_EQ(medial::distinctSamples(samples).nearDuplicates, 1);
  EXPECT_EQ(warnings(), 0u);
  samples = shapes::torus().samples;
  samples.insert(samples.end(), samples.begin(), samples.end());
  EXPECT_EQ(medial::distinctSamples(samples).nearDuplicates, 0);
  EXPECT_EQ(warnings(), 0u);
}

TEST(NearDuplicates, FollowTheRoundingOfTheInput)
{
  const std::vector<Point> samples = shapes::torus().samples;
  const double diagonal = validators::diagonal(samples);
  EXPECT_EQ(medial::defaultTolerance(samples, 0), 1e-7 * diagonal);
  EXPECT_EQ(medial::defaultTolerance(samples, 1e-3), 2e-3);
  const std::vector<Point> far = shapes::moved(samples, Point(0, -1e12, 0));
  EXPECT_NEAR(medial::defaultTolerance(far, 0), 4.4e-4, 1e-5);
}

TEST(NearDuplicates, AreNeverAllSamples)
{
  const std::vector<Point> cube = shapes::gridCube(2);
  EXPECT_EQ(medial::distinctSamples(cube, { 100, 0 }).ids.size(), 8u);
}

TEST(NearDuplicates, RefuseLengthsThatAreNone)
{
  const std::vector<Point> cube = shapes::gridCube(2);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(medial::distinctSamples(cube, { infinity, 0 }), medial::InvalidInput);
  EXPECT_THROW(medial::distinctSamples(cube, { 0, infinity }), medial::InvalidInput);
}

TEST(NearDuplicates, AreNamedWhereTooFewSamplesAreLeft)
{
  std::vector<Point> samples;
  for (const Point& place : { Point(0, 0, 0), Point(1, 0, 0) })
  {
    for (const Point& corner : shapes::scaled(shapes::gridCube(2), 1e-9))
    {
      samples.push_back(place + corner);
    }
  }
  try
  {
    medial::polarBalls(samples);
    FAIL();
  }
  catch (const medial::InvalidInput& error)
  {
    EXPECT_STREQ(error.what(),
      "there are only 2 distinct samples, because 14 lie within the merge tolerance of others; at "
      "least 4 points of a closed surface are needed");
  }
}
