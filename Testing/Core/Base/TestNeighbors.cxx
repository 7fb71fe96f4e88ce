// SPDX-License-Identifier: BSD-3-Clause
#include "Base/MoreNeighbors.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

using medial::Index;
using medial::Point;

TEST(Neighbors, AreTheNearestPointsInOrder)
{
  const std::vector<Point> points = shapes::cloud(300, 4);
  const medial::Neighbors neighbors(points);
  for (Index p = 0; p < medial::count(points); ++p)
  {
    std::vector<std::pair<double, Index>> all;
    for (Index q = 0; q < medial::count(points); ++q)
    {
      if (q != p)
      {
        all.emplace_back((points[q] - points[p]).squaredNorm(), q);
      }
    }
    std::sort(all.begin(), all.end());
    const std::vector<Index> found = neighbors.nearest(p, 7);
    ASSERT_EQ(found.size(), 7u);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      ASSERT_EQ(found[i], all[i].second);
    }
  }
}

TEST(Neighbors, ContainTheNearestOneIfItIsNearEnough)
{
  const std::vector<Point> points = shapes::cloud(300, 4);
  const medial::Neighbors neighbors(points);
  for (Index p = 1; p < medial::count(points); ++p)
  {
    const Point place = (points[p] + points[p - 1]) / 2;
    const Index nearest = neighbors.nearest(place, 1).front();
    const double distance = (points[nearest] - place).norm();
    ASSERT_EQ(neighbors.nearestOne(place), nearest);
    ASSERT_EQ(neighbors.nearestOne(place, distance * (1 + 1e-9)), nearest);
    ASSERT_EQ(neighbors.nearestOne(place, distance * (1 - 1e-9)), medial::None);
  }
}

TEST(Neighbors, AreFoundAmongManyAtTheSamePlace)
{
  std::vector<Point> points(100000, Point(1, 2, 3));
  points.emplace_back(1, 2, 4);
  const medial::Neighbors neighbors(points);
  EXPECT_EQ(neighbors.within(Point(1, 2, 3), 0).size(), 100000u);
  EXPECT_EQ(neighbors.nearestOne(Point(1, 2, 5)), 100000);
}

TEST(Neighbors, AreNoneOfNoPoints)
{
  const std::vector<Point> points;
  const medial::Neighbors neighbors(points);
  EXPECT_EQ(neighbors.nearestOne(Point(0, 0, 0)), medial::None);
  EXPECT_TRUE(neighbors.nearest(Point(0, 0, 0), 3).empty());
  EXPECT_TRUE(neighbors.within(Point(0, 0, 0), 1).empty());
}

TEST(Neighbors, AreAllOthersWhereThereAreFew)
{
  const std::vector<Point> points = shapes::cloud(4, 1);
  EXPECT_EQ(medial::Neighbors(points).nearest(2, 6).size(), 3u);
}

TEST(Neighbors, WithinADistanceOfAPlaceAreAllThatAre)
{
  const std::vector<Point> points = shapes::cloud(300, 4);
  const Point place = (points[0] + points[1]) / 2;
  const double distance = (points[2] - place).norm() * (1 + 1e-9);
  std::vector<Index> expected;
  for (Index q = 0; q < medial::count(points); ++q)
  {
    if ((points[q] - place).norm() <= distance)
    {
      expected.push_back(q);
    }
  }
  std::vector<Index> found = medial::Neighbors(points).within(place, distance);
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, expected);
}

TEST(Neighbors, AreTakenOnceEach)
{
  const std::vector<Point> points = shapes::cloud(300, 4);
  const medial::Neighbors neighbors(points);
  medial::Neighbors::Left left = neighbors.all();
  std::vector<char> isTaken(points.size(), 0);
  for (Index p = 0; p < medial::count(points); p += 3)
  {
    const double distance = 0.05 * static_cast<double>(p % 7);
    std::vector<Index> expected, found;
    for (const Index q : neighbors.within(p, distance))
    {
      if (!isTaken[q])
      {
        isTaken[q] = 1;
        expected.push_back(q);
      }
    }
    neighbors.takeEachWithin(points[p], distance, left, [&](Index q) { found.push_back(q); });
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected);
  }
  EXPECT_EQ(left.inNode[0], std::count(isTaken.begin(), isTaken.end(), 0));
}

TEST(Neighbors, InOrderAreAllOfThem)
{
  const std::vector<Point> points = shapes::cloud(300, 4);
  std::vector<Index> order = medial::Neighbors(points).inOrder();
  std::sort(order.begin(), order.end());
  ASSERT_EQ(order.size(), points.size());
  for (Index p = 0; p < medial::count(points); ++p)
  {
    ASSERT_EQ(order[p], p);
  }
}

TEST(MoreNeighbors, AreThoseAmongAllPoints)
{
  const std::vector<Point> points = shapes::cloud(300, 4);
  const medial::Neighbors all(points);
  for (const Index some : { 0, 7, 290, 300 })
  {
    const std::vector<Point> start(points.begin(), points.begin() + some);
    const medial::Neighbors known(start);
    const medial::MoreNeighbors neighbors(known, points);
    for (const Point& place : shapes::cloud(50, 5))
    {
      ASSERT_EQ(neighbors.nearestOne(place), all.nearestOne(place)) << some;
      std::vector<Index> found = neighbors.within(place, 0.3), expected = all.within(place, 0.3);
      std::sort(found.begin(), found.end());
      std::sort(expected.begin(), expected.end());
      ASSERT_EQ(found, expected) << some;
    }
  }
}
