// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/Distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using medial::distribution;
using medial::Distribution;
using medial::Index;

namespace
{
TEST(Distribution, TellsTheNumbersOfAFewValues)
{
  const Distribution result = distribution({ 1, 3, 5, 7 });
  EXPECT_EQ(result.mean, 4);
  EXPECT_EQ(result.deviation, std::sqrt(5.0));
  EXPECT_EQ(result.smallest, 1);
  EXPECT_EQ(result.largest, 7);
  EXPECT_EQ(result.number, 4);
}

TEST(Distribution, CountsEachValueInItsRange)
{
  const Distribution result = distribution({ 0, 0.5, 1, 1.5, 38.5, 39, 40, 40 });
  std::array<Index, 40> expected{};
  expected[0] = expected[1] = 2;
  expected[38] = 1;
  expected[39] = 3; // the largest values, too
  EXPECT_EQ(result.histogram, expected);
}

TEST(Distribution, HasAHistogramThatDoesNotDependOnTheUnit)
{
  std::vector<double> values, inInches;
  for (int i = 0; i < 1000; ++i)
  {
    values.push_back(std::fmod(i * 0.6180339887, 1));
    inInches.push_back(values.back() / 25.4);
  }
  const auto histogram = distribution(values).histogram;
  EXPECT_EQ(histogram, distribution(inInches).histogram);
  EXPECT_EQ(std::accumulate(histogram.begin(), histogram.end(), 0), 1000);
  for (const Index count : histogram)
  {
    EXPECT_NEAR(count, 25, 4);
  }
}

TEST(Distribution, WithoutValuesHasNoNumbers)
{
  const Distribution result = distribution({});
  EXPECT_TRUE(std::isnan(result.mean));
  EXPECT_TRUE(std::isnan(result.largest));
  EXPECT_EQ(result.number, 0);
  EXPECT_EQ(result.histogram, Distribution().histogram);
  EXPECT_EQ(distribution({ 0, 0 }).histogram[0], 2);
}
}
