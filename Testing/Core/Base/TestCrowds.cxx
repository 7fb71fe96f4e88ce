// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Crowds.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using medial::Index;
using medial::IndexLists;
using medial::Point;

namespace
{
constexpr double distance = 1e-3;

std::set<std::pair<Index, Index>> pairsOf(const IndexLists& groups)
{
  std::set<std::pair<Index, Index>> pairs;
  for (Index g = 0; g < groups.size(); ++g)
  {
    for (const Index a : groups[g])
    {
      for (const Index b : groups[g])
      {
        if (a < b)
        {
          pairs.insert({ a, b });
        }
      }
    }
  }
  return pairs;
}
}

TEST(Crowds, HoldAllPairsThatAreNear)
{
  for (unsigned seed = 0; seed < 4; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    // Some points are that near to each other.
    const std::vector<Point> points = shapes::scaled(shapes::cloud(3000, seed), 40 * distance);
    const std::vector<char> used(points.size(), 1);
    const auto pairs = pairsOf(medial::crowds(points, used, distance));
    int near = 0;
    for (Index a = 0; a < 3000; ++a)
    {
      for (Index b = a + 1; b < 3000; ++b)
      {
        if ((points[a] - points[b]).norm() < distance)
        {
          ++near;
          ASSERT_TRUE(pairs.count({ a, b })) << a << ", " << b;
        }
      }
    }
    EXPECT_GT(near, 200);
  }
}

TEST(Crowds, OfPointsInAPlaneAreFewWhateverItsDirection)
{
  for (const Point& scale : { Point(0, 1, 1), Point(1, 0, 1), Point(1, 1, 0), Point(0, 0, 1) })
  {
    std::vector<Point> points = shapes::cloud(40000, 1);
    std::transform(points.begin(), points.end(), points.begin(),
      [&](const Point& p) -> Point { return p.cwiseProduct(scale); });
    const std::vector<char> used(points.size(), 1);
    // On a line that is 1 long, every second point has another one within 1/80,000.
    EXPECT_LT(pairsOf(medial::crowds(points, used, 1e-9)).size(), 40U) << scale.transpose();
  }
}

TEST(Crowds, LeaveOutPointsThatAreApartAndThoseThatDoNotCount)
{
  std::vector<Point> points = shapes::gridCube(9);
  std::vector<char> used(points.size(), 1);
  EXPECT_EQ(medial::crowds(points, used, distance / 10).size(), 0);
  points.push_back(points[3]);
  used.push_back(1);
  const IndexLists groups = medial::crowds(points, used, distance / 10);
  ASSERT_EQ(groups.size(), 1);
  EXPECT_EQ(groups[0][0], 3);
  EXPECT_EQ(groups[0][1], medial::count(points) - 1);
  used[3] = 0;
  EXPECT_EQ(medial::crowds(points, used, distance / 10).size(), 0);
}
