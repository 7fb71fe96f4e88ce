// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/SampleDistances.h"

#include <gtest/gtest.h>

#include <cmath>

using medial::CrustSurface;
using medial::Index;
using medial::None;
using medial::Point;
using medial::SampleDistances;
using medial::sampleDistances;

namespace
{
/// A tetrahedron with a corner in the origin and edges of length 1 along the axes; its corners are samples 0 to 3.
CrustSurface corner()
{
  CrustSurface surface;
  surface.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  surface.triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  surface.sampleOfPoint = { 0, 1, 2, 3 };
  return surface;
}
}

TEST(SampleDistances, AreNoneWhereAllSamplesArePoints)
{
  const CrustSurface surface = corner();
  const SampleDistances moved = sampleDistances(surface.points, surface);
  EXPECT_EQ(moved.percentile99, 0);
  EXPECT_EQ(moved.largest, 0);
}

TEST(SampleDistances, AreThoseToTheNearestTriangle)
{
  const CrustSurface surface = corner();
  std::vector<Point> samples = surface.points;
  samples.emplace_back(0.25, 0.25, -2); // below a face
  samples.emplace_back(4, 0, 0);        // beyond a corner
  samples.emplace_back(0.1, 0.1, 0.05); // inside
  SampleDistances moved = sampleDistances(samples, surface);
  EXPECT_DOUBLE_EQ(moved.largest, 3);
  EXPECT_DOUBLE_EQ(moved.percentile99, 3);
  // Of 300 samples three may be farther away than 99 %: these.
  samples.resize(300, Point(0.25, 0.25, 0));
  moved = sampleDistances(samples, surface);
  EXPECT_DOUBLE_EQ(moved.largest, 3);
  EXPECT_NEAR(moved.percentile99, 0, 1e-15);
  samples.pop_back();
  EXPECT_DOUBLE_EQ(sampleDistances(samples, surface).percentile99, 0.05);
}

TEST(SampleDistances, AreNoneWithoutASurface)
{
  EXPECT_EQ(sampleDistances({ Point(0, 0, 0) }, {}).largest, 0);
}
