// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/SheetMerging.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

using medial::Bond;
using medial::DisjointSets;
using medial::Index;

namespace
{
/// The lowest member of the set of each.
std::vector<Index> merged(Index size, const std::vector<Bond>& bonds)
{
  DisjointSets sets(size);
  medial::mergeByBonds(sets, bonds);
  std::vector<Index> result;
  for (Index i = 0; i < size; ++i)
  {
    result.push_back(sets.find(i));
  }
  return result;
}
}

TEST(SheetMerging, PositiveBondsUnite)
{
  EXPECT_EQ(merged(4, { { 3, 1, 2 }, { 0, 2, -1 } }), (std::vector<Index>{ 0, 1, 2, 1 }));
}

TEST(SheetMerging, BondsAddUp)
{
  EXPECT_EQ(merged(2, { { 0, 1, 2 }, { 1, 0, -3 } }), (std::vector<Index>{ 0, 1 }));
  EXPECT_EQ(merged(2, { { 0, 1, -2 }, { 1, 0, 3 } }), (std::vector<Index>{ 0, 0 }));
}

TEST(SheetMerging, ASmallSetDoesNotBindWhatALongSeamParts)
{
  // 0 and 1 meet at a seam of 10; 2 is a piece of 0 that has a gap in the seam with 1.
  EXPECT_EQ(
    merged(3, { { 0, 1, -10 }, { 0, 2, 3 }, { 1, 2, 1 } }), (std::vector<Index>{ 0, 1, 0 }));
}

TEST(SheetMerging, AGapInALongBorderDoesNotUnite)
{
  EXPECT_EQ(
    merged(4, { { 0, 1, 0.5 }, { 0, 2, -10 }, { 1, 3, -10 } }), (std::vector<Index>{ 0, 1, 2, 3 }));
  EXPECT_EQ(
    merged(4, { { 0, 1, 2.5 }, { 0, 2, -10 }, { 1, 3, -10 } }), (std::vector<Index>{ 0, 0, 2, 3 }));
}

TEST(SheetMerging, SetsThatAreThereStay)
{
  DisjointSets sets(4);
  sets.unite(2, 3);
  medial::mergeByBonds(sets, { { 0, 3, 1 }, { 0, 2, -2 }, { 2, 3, 5 }, { 0, 1, 1 } });
  EXPECT_EQ(sets.find(1), 0);
  EXPECT_EQ(sets.find(3), 2);
}

TEST(SheetMerging, TheOrderOfBondsDoesNotMatter)
{
  constexpr unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::vector<Bond> bonds;
  for (int i = 0; i < 3000; ++i)
  {
    const auto a = static_cast<Index>(random() % 500), b = static_cast<Index>(random() % 500);
    bonds.push_back({ a, b, static_cast<double>(random() % 201) - 120 });
  }
  const std::vector<Index> expected = merged(500, bonds);
  EXPECT_GT(std::count(expected.begin(), expected.end(), expected[0]), 0);
  for (int i = 0; i < 5; ++i)
  {
    std::shuffle(bonds.begin(), bonds.end(), random);
    EXPECT_EQ(merged(500, bonds), expected);
  }
}
