// SPDX-License-Identifier: BSD-3-Clause
#include "Images/MaskDifference.h"

#include "Images/MaskBetti.h"
#include "Masks.h"

#include <gtest/gtest.h>

#include <cmath>

using medial::Index;
using medial::maskBetti;
using medial::Point;
using medial::topologyDifference;
using medial::VoxelMask;

namespace
{
bool ball(double x, double y, double z)
{
  return std::hypot(x, y, z) < 0.7;
}

TEST(MaskDifference, IsNoneBetweenBalls)
{
  const VoxelMask large = masks::cube(20, ball);
  const VoxelMask small = masks::cube(
    20, [](double x, double y, double z) { return ball(1.5 * x + 0.2, 2 * y, 1.5 * z); });
  EXPECT_FALSE(topologyDifference(large, large));
  EXPECT_FALSE(topologyDifference(large, small));
  EXPECT_FALSE(topologyDifference(small, large));
}

TEST(MaskDifference, IsWhereATunnelIs)
{
  const VoxelMask whole = masks::cube(20, ball);
  const VoxelMask drilled = masks::cube(20, [](double x, double y, double z) {
    return ball(x, y, z) && std::hypot(x - 0.2, y + 0.1) > 0.1;
  });
  ASSERT_EQ(maskBetti(drilled)[1], 1);
  for (const auto& place :
    { topologyDifference(whole, drilled), topologyDifference(drilled, whole) })
  {
    ASSERT_TRUE(place);
    EXPECT_NEAR((2 * place->x() + 1) / 20 - 1, 0.2, 0.15);
    EXPECT_NEAR((2 * place->y() + 1) / 20 - 1, -0.1, 0.15);
  }
}

TEST(MaskDifference, IsWhereAPieceOrACavityIs)
{
  const VoxelMask one = masks::cube(20, ball);
  for (const std::size_t voxel : { std::size_t(0), one.row(10, 10) + 10 })
  {
    VoxelMask other = one;
    other.inside[voxel] ^= 1;
    const Point expected = Point::Constant(voxel == 0 ? 0 : 10);
    EXPECT_EQ(topologyDifference(one, other).value(), expected);
    EXPECT_EQ(topologyDifference(other, one).value(), expected);
  }
}

TEST(MaskDifference, IsFoundWhereverBettiNumbersDiffer)
{
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    const VoxelMask a = masks::random({ 4, 5, 6 }, 0.6, seed);
    VoxelMask b = a;
    b.inside[seed % 120] ^= 1;
    b.inside[seed * 7 % 120] ^= 1;
    const auto place = topologyDifference(a, b);
    EXPECT_TRUE(place || maskBetti(a) == maskBetti(b)) << "seed " << seed;
  }
}

/// Two boxes of voxels that touch by an edge, or by a corner. A contour separates them.
TEST(MaskDifference, KnowsBareContacts)
{
  for (const bool byCorner : { false, true })
  {
    VoxelMask mask{ { 6, 6, 6 }, std::vector<unsigned char>(216, 0) };
    const auto fill = [&mask](Index i, Index j, Index k) { mask.inside[mask.row(j, k) + i] = 1; };
    for (Index k = 1; k < 3; ++k)
    {
      fill(1, 1, k);
      fill(2, 1, k);
    }
    EXPECT_FALSE(medial::bareContact(mask));
    fill(3, 2, byCorner ? 3 : 2);
    EXPECT_EQ(medial::bareContact(mask).value(), Point(2, 1, 2));
    fill(2, 2, byCorner ? 3 : 2); // joins them by faces, unless there is a step left
    EXPECT_EQ(medial::bareContact(mask).has_value(), byCorner);
    fill(2, 1, 3);
    EXPECT_FALSE(medial::bareContact(mask));
  }
}

TEST(MaskDifference, CanBeStopped)
{
  medial::Execution execution;
  execution.progress = [](double) { return false; };
  const VoxelMask full = masks::cube(4, [](double, double, double) { return true; });
  EXPECT_THROW(topologyDifference(masks::cube(4, ball), full, execution), medial::Aborted);
}
}
