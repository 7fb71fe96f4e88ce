// SPDX-License-Identifier: BSD-3-Clause
#include "Base/EdgeTable.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>

using medial::EdgeSet;
using medial::EdgeTable;
using medial::Index;
using medial::None;
using medial::TriangleTable;

namespace
{
TEST(EdgeTable, HoldsTheFirstNumberOfEachEdge)
{
  constexpr unsigned seed = 5;
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  for (const Index corners : { 3, 50, 2000 })
  {
    EdgeTable table;
    std::map<std::pair<Index, Index>, Index> expected;
    for (Index i = 0; i < 5000; ++i)
    {
      const Index a = static_cast<Index>(random() % corners);
      const Index b = static_cast<Index>(random() % corners);
      EXPECT_EQ(table.insert(a, b, i), expected.insert({ { a, b }, i }).second);
      const Index c = static_cast<Index>(random() % corners);
      const auto found = expected.find({ a, c });
      EXPECT_EQ(table.find(a, c), found == expected.end() ? None : found->second);
    }
  }
}

TEST(EdgeTable, HoldsAllEdgesOfACornerWithVeryMany)
{
  constexpr Index many = 300000; // minutes, if each was compared with all before it
  EdgeTable table(many);
  for (Index i = 0; i < many; ++i)
  {
    EXPECT_TRUE(table.insert(7, i, i));
    EXPECT_FALSE(table.insert(7, i, 0));
  }
  for (Index i = 0; i < many; ++i)
  {
    EXPECT_EQ(table.find(7, i), i);
    EXPECT_EQ(table.find(8, i), None);
  }
}

TEST(EdgeTable, TellsTheDirectionsOfAnEdgeApart)
{
  EdgeTable table;
  EXPECT_TRUE(table.insert(1, 2, 7));
  EXPECT_EQ(table.find(2, 1), None);
  EXPECT_TRUE(table.insert(2, 1, 8));
  EXPECT_EQ(table.find(1, 2), 7);
}

TEST(EdgeTable, IsEmptyAtFirst)
{
  EXPECT_EQ(EdgeTable().find(0, 0), None);
  EXPECT_EQ(EdgeTable(1000).find(0, 0), None);
}

TEST(EdgeSet, TakesBothDirectionsForOneEdge)
{
  EdgeSet edges;
  edges.insert(4, 3);
  EXPECT_TRUE(edges.contains(3, 4));
  EXPECT_TRUE(edges.contains(4, 3));
  EXPECT_FALSE(edges.contains(3, 3));
}

TEST(TriangleTable, HoldsTheFirstNumberOfTheCornersInAnyOrder)
{
  TriangleTable table;
  for (Index i = 0; i < 200; ++i)
  {
    EXPECT_TRUE(table.insert({ i, i + 1, i + 2 }, i));
    EXPECT_TRUE(table.insert({ i + 2, i, i + 9 }, 1000 + i));
  }
  for (Index i = 0; i < 200; ++i)
  {
    EXPECT_FALSE(table.insert({ i + 2, i + 1, i }, 7));
    EXPECT_EQ(table.numberOf({ i + 1, i, i + 2 }, 7), i);
    EXPECT_EQ(table.numberOf({ i + 9, i + 2, i }, 7), 1000 + i);
    EXPECT_EQ(table.numberOf({ i, i + 1, i + 9 }, 7), 7);
  }
}
}
