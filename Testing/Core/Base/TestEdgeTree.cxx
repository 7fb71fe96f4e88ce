// SPDX-License-Identifier: BSD-3-Clause
#include "Base/EdgeTree.h"

#include "Numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace
{
using medial::Edge;
using medial::EdgeTree;
using medial::Point;

constexpr unsigned seed = 5;

double distanceTo(const Point& place, const Point& from, const Point& to)
{
  const Point along = to - from;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp(along.dot(place - from) / square, 0.0, 1.0) : 0;
  return (from + t * along - place).norm();
}

TEST(EdgeTree, TellsTheDistanceToTheNearestEdge)
{
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  shapes::Random engine{ seed };
  std::vector<Point> points;
  std::vector<Edge> edges;
  for (int i = 0; i < 60; ++i)
  {
    points.push_back(shapes::uniformInBox(engine, Point::Ones()));
    edges.push_back({ i, (5 * i) % 60 }); // some have the same point twice
  }
  const EdgeTree tree(points, edges);
  for (int i = 0; i < 500; ++i)
  {
    const Point place = shapes::uniformInBox(engine, Point::Constant(2));
    double nearest = std::numeric_limits<double>::infinity();
    for (const Edge& edge : edges)
    {
      nearest = std::min(nearest, distanceTo(place, points[edge[0]], points[edge[1]]));
    }
    EXPECT_NEAR(tree.distance(place), nearest, 1e-12);
  }
}

TEST(EdgeTree, OfNoEdgesIsInfinitelyFar)
{
  const EdgeTree tree({ Point::Zero() }, {});
  EXPECT_EQ(tree.distance(Point::Zero()), std::numeric_limits<double>::infinity());
}
}
