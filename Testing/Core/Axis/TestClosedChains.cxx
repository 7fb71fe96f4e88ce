// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/ClosedChains.h"

#include <gtest/gtest.h>

#include <random>

using medial::Index;
using medial::IndexLists;

namespace
{
/// The base 2 logarithm of the number of sets of groups that have an even number of each edge's
/// triangles and no excluded group, by trying all.
Index triedChains(const IndexLists& groupsAtEdges, const std::vector<char>& excluded)
{
  Index chains = 0;
  for (unsigned set = 0; set < 1u << excluded.size(); ++set)
  {
    bool isClosed = true;
    for (std::size_t group = 0; group < excluded.size(); ++group)
    {
      isClosed = isClosed && !(excluded[group] && (set >> group & 1));
    }
    for (Index edge = 0; edge < groupsAtEdges.size(); ++edge)
    {
      unsigned triangles = 0;
      for (const Index group : groupsAtEdges[edge])
      {
        triangles += set >> group & 1;
      }
      isClosed = isClosed && triangles % 2 == 0;
    }
    chains += isClosed;
  }
  Index dimension = 0;
  for (; chains > 1; chains /= 2)
  {
    ++dimension;
  }
  return dimension;
}
}

TEST(ClosedChains, AreAsManyAsAreFoundByTryingAll)
{
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const Index groupCount = 1 + static_cast<Index>(random() % 10);
    IndexLists groupsAtEdges;
    for (unsigned edge = random() % 8; edge > 0; --edge)
    {
      for (unsigned use = 2 + random() % 4; use > 0; --use)
      {
        groupsAtEdges.items.push_back(static_cast<Index>(random() % groupCount));
      }
      groupsAtEdges.close();
    }
    std::vector<char> excluded(groupCount);
    for (char& value : excluded)
    {
      value = random() % 5 == 0;
    }
    EXPECT_EQ(medial::closedChains(groupsAtEdges, excluded), triedChains(groupsAtEdges, excluded));
  }
}

TEST(ClosedChains, WithoutEdgesAreAllGroups)
{
  EXPECT_EQ(medial::closedChains({}, { 0, 0, 1 }), 2);
  EXPECT_EQ(medial::closedChains({}, {}), 0);
}
