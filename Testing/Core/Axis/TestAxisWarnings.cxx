// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/AxisWarnings.h"

#include <gtest/gtest.h>

namespace
{
TEST(AxisWarnings, TellOfTheFallback)
{
  medial::MedialAxis axis{};
  EXPECT_TRUE(medial::axisWarnings(axis).empty());
  axis.fallback = true;
  axis.cells.triangles = { { 0, 1, 2 } };
  const medial::Warnings warnings = medial::axisWarnings(axis);
  ASSERT_EQ(warnings.size(), 1);
  EXPECT_EQ(warnings[0].code, "fallback");
  EXPECT_EQ(warnings[0].count, 1);
  EXPECT_FALSE(warnings[0].doubtsSolid); // its topology is right
}
}
