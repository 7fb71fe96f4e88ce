// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/Thresholds.h"

#include "Numbers.h"
#include "Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using medial::RankedPart;
using medial::suggestedThreshold;

namespace
{
/// Parts of these significances that share a hundredth of the volume each.
std::vector<RankedPart> parts(const std::vector<double>& significances, double volume = 0.01)
{
  std::vector<RankedPart> result;
  for (const double significance : significances)
  {
    result.push_back({ significance, volume });
  }
  return result;
}
}

TEST(Thresholds, AreInTheMiddleOfTheLargestRatio)
{
  EXPECT_DOUBLE_EQ(suggestedThreshold(parts({ 1, 2, 3, 48, 96 })), 12);
}

TEST(Thresholds, RemoveHalfOfThePartsOrMore)
{
  EXPECT_DOUBLE_EQ(suggestedThreshold(parts({ 1e-9, 2, 3, 48, 96 })), 12);
  EXPECT_DOUBLE_EQ(suggestedThreshold(parts({ 1, 100, 200 })), std::sqrt(2.0) * 100);
}

TEST(Thresholds, RemoveAtMostTheVolumeAllowed)
{
  const std::vector<RankedPart> large = parts({ 1, 2, 8, 64 }, 0.04);
  EXPECT_DOUBLE_EQ(suggestedThreshold(large), 4);
  EXPECT_NEAR(suggestedThreshold(large, 0.13), std::sqrt(8.0 * 64), 1e-12);
  EXPECT_EQ(suggestedThreshold(large, 0.05), 0);
  EXPECT_EQ(suggestedThreshold(large, -1), 0);
}

TEST(Thresholds, AreZeroWhereNothingStandsOut)
{
  EXPECT_EQ(suggestedThreshold({}), 0);
  EXPECT_EQ(suggestedThreshold(parts({ 7 })), 0);
  EXPECT_EQ(suggestedThreshold(parts({ 7, 7, 7 })), 0);
  EXPECT_EQ(suggestedThreshold(parts({ 0, 0, 7 })), 0);
}

TEST(Thresholds, FollowTheUnitToTheLastBitAndNotTheOrder)
{
  shapes::Random random(5);
  RecordProperty("seed", 5);
  std::vector<RankedPart> some;
  for (int i = 0; i < 100; ++i)
  {
    const double significance = std::ldexp(shapes::uniform(random, 1, 2), i % 12 - 6);
    some.push_back({ significance, 0.001 });
  }
  const double threshold = suggestedThreshold(some);
  EXPECT_GT(threshold, 0);
  std::vector<RankedPart> shuffled;
  for (const medial::Index i : shapes::shuffledOrder(some.size(), 5))
  {
    shuffled.push_back(some[i]);
  }
  EXPECT_EQ(suggestedThreshold(shuffled), threshold);
  for (RankedPart& part : some)
  {
    part.significance = std::ldexp(part.significance, 21);
  }
  EXPECT_EQ(suggestedThreshold(some), std::ldexp(threshold, 21));
}
