// SPDX-License-Identifier: BSD-3-Clause
#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Base/Frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using medial::DisjointSets;
using medial::Frame;
using medial::frameOf;
using medial::Index;
using medial::Point;

namespace
{
std::vector<Point> box(const Point& lower, const Point& upper)
{
  return { lower, upper, Point(0.5 * (lower + upper)) };
}
}

TEST(Frame, CentresAndScalesToASizeOfAboutOne)
{
  for (const double size : { 1e-80, 3e-5, 0.7, 1.0, 1234.5, 1e80 })
  {
    const Frame frame = frameOf(box(Point(2, 3, 4) * size, Point(3, 3.5, 4.2) * size));
    EXPECT_LT(frame.toLocal(Point(Point(2.5, 3.25, 4.1) * size)).norm(), 1e-12) << size;
    int exponent = 0;
    EXPECT_EQ(std::frexp(frame.scale, &exponent), 0.5) << "a power of two";
    EXPECT_GE(size * frame.scale, 0.5 * (1 - 1e-12)) << size;
    EXPECT_LT(size * frame.scale, 1 + 1e-12) << size;
  }
}

TEST(Frame, LeadsBack)
{
  const Frame frame = frameOf(box(Point(1, 2, 3), Point(4, 6, 8)));
  const medial::Ball ball{ Point(1.5, 2.25, 3.125), 0.75 };
  const medial::Ball back = frame.toWorld(frame.toLocal(ball));
  EXPECT_EQ(back.center, ball.center);
  EXPECT_EQ(back.radius, ball.radius);
}

TEST(Frame, RefusesWhatHasNoSize)
{
  EXPECT_THROW(frameOf({}), medial::InvalidInput);
  EXPECT_THROW(frameOf({ Point(1, 1, 1), Point(1, 1, 1) }), medial::InvalidInput);
  EXPECT_THROW(frameOf(box(Point(0, 0, 0), Point(1e91, 0, 0))), medial::InvalidInput);
  EXPECT_THROW(frameOf(box(Point(0, 0, 0), Point(1e-91, 0, 0))), medial::InvalidInput);
  EXPECT_THROW(frameOf({ Point(0, 0, 0), Point(std::numeric_limits<double>::quiet_NaN(), 0, 0) }),
    medial::InvalidInput);
}

TEST(DisjointSets, AreKnownByTheirLowestMembers)
{
  DisjointSets sets(6);
  EXPECT_TRUE(sets.unite(5, 3));
  EXPECT_TRUE(sets.unite(3, 1));
  EXPECT_FALSE(sets.unite(1, 5));
  EXPECT_TRUE(sets.unite(4, 0));
  const std::vector<Index> expected{ 0, 1, 2, 1, 0, 1 };
  for (Index i = 0; i < 6; ++i)
  {
    EXPECT_EQ(sets.find(i), expected[i]);
  }
}
