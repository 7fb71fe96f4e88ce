// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/PartColors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

using medial::partColor;

namespace
{
/// CIE L* of an sRGB colour, 0 ... 100.
double lightness(const std::array<double, 3>& rgb)
{
  const auto linear = [](double c) {
    return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92;
  };
  const double y = 0.2126 * linear(rgb[0]) + 0.7152 * linear(rgb[1]) + 0.0722 * linear(rgb[2]);
  return 116 * std::cbrt(y) - 16;
}

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Can a screen show the colour as chosen, without a component cut at 0 or 1?
bool isWithinRange(const std::array<double, 3>& rgb)
{
  return std::all_of(rgb.begin(), rgb.end(), [](double c) { return c > 0 && c < 1; });
}
}

TEST(PartColors, HaveThreeLightnesses)
{
  int checked = 0;
  for (int part = 0; part < 300; ++part)
  {
    const std::array<double, 3> rgb = partColor(part);
    const double expected[] = { 66, 52, 78 };
    if (isWithinRange(rgb))
    {
      EXPECT_NEAR(lightness(rgb), expected[part % 3], 0.1) << part;
      ++checked;
    }
  }
  EXPECT_GT(checked, 100); // many are outside what a screen can show
}

TEST(PartColors, AreBetween0And1)
{
  for (std::int64_t part : { 0, 1, 2, 77, 5000, 114984 })
  {
    for (double component : partColor(part))
    {
      EXPECT_TRUE(component >= 0 && component <= 1) << part << ": " << component;
    }
  }
  for (double component : partColor(std::numeric_limits<std::int64_t>::max()))
  {
    EXPECT_TRUE(component >= 0 && component <= 1);
  }
}

TEST(PartColors, OfNeighboursDiffer)
{
  for (int part = 0; part < 1000; ++part)
  {
    EXPECT_GT(distance(partColor(part), partColor(part + 1)), 0.25) << part;
    EXPECT_GT(distance(partColor(part), partColor(part + 2)), 0.25) << part;
  }
}

TEST(PartColors, OfNoPartIsGrey)
{
  const std::array<double, 3> grey = partColor(-1);
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[1], grey[2]);
}
