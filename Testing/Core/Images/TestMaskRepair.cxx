// SPDX-License-Identifier: BSD-3-Clause
#include "Images/MaskRepair.h"

#include "Images/ImageWarnings.h"
#include "Images/MaskBetti.h"
#include "Masks.h"

#include <gtest/gtest.h>

#include <string>

using medial::Betti;
using medial::borderVoxels;
using medial::Index;
using medial::maskBetti;
using medial::MaskRepairs;
using medial::repairMask;
using medial::VoxelMask;

namespace
{
/// A hollow cube of 9^3 voxels with one voxel in its cavity of 5^3, and three voxels in a row beside it.
VoxelMask hollow()
{
  VoxelMask mask{ { 13, 9, 9 }, std::vector<unsigned char>(13 * 81, 0) };
  for (Index k = 0; k < 9; ++k)
  {
    for (Index j = 0; j < 9; ++j)
    {
      for (Index i = 0; i < 9; ++i)
      {
        const bool wall = i < 2 || i > 6 || j < 2 || j > 6 || k < 2 || k > 6;
        mask.inside[mask.row(j, k) + i] = wall || (i == 4 && j == 4 && k == 4) ? 1 : 0;
      }
    }
  }
  for (Index j = 3; j < 6; ++j)
  {
    mask.inside[mask.row(j, 4) + 11] = 1;
  }
  return mask;
}

TEST(MaskRepair, FillsCavitiesUpToTheirSize)
{
  for (const Index largest : { 123, 124 })
  {
    VoxelMask mask = hollow();
    const MaskRepairs repairs = repairMask(mask, { largest, false, 1 });
    const bool filled = largest >= 124; // voxels of the cavity, without the one inside
    EXPECT_EQ(repairs.filledCavities, filled ? 1 : 0);
    EXPECT_EQ(repairs.filledVoxels, filled ? 124 : 0);
    EXPECT_EQ(repairs.droppedPieces, 0);
    EXPECT_EQ(maskBetti(mask), filled ? (Betti{ 2, 0, 0 }) : (Betti{ 3, 0, 1 }));
  }
}

TEST(MaskRepair, DropsPiecesBelowTheirSize)
{
  for (const Index smallest : { 1, 2, 3, 4 })
  {
    VoxelMask mask = hollow();
    const MaskRepairs repairs = repairMask(mask, { 0, false, smallest });
    EXPECT_EQ(repairs.droppedPieces, smallest == 1 ? 0 : smallest < 4 ? 1 : 2);
    EXPECT_EQ(repairs.droppedVoxels, smallest == 1 ? 0 : smallest < 4 ? 1 : 4);
    EXPECT_EQ(maskBetti(mask)[0], 3 - repairs.droppedPieces);
  }
}

TEST(MaskRepair, KeepsTheLargestPieceAlone)
{
  VoxelMask mask = hollow();
  EXPECT_EQ(repairMask(mask, { 1000, true, 1 }).droppedVoxels, 3);
  EXPECT_EQ(maskBetti(mask), (Betti{ 1, 0, 0 }));
  VoxelMask equal{ { 5, 1, 1 }, { 1, 1, 0, 1, 1 } };
  repairMask(equal, { 0, true, 1 });
  EXPECT_EQ(equal.inside, (std::vector<unsigned char>{ 1, 1, 0, 0, 0 }));
}

TEST(MaskRepair, RefusesToDropEverything)
{
  VoxelMask mask = hollow();
  try
  {
    repairMask(mask, { 0, false, 100000 });
    FAIL();
  }
  catch (const medial::InvalidInput& error)
  {
    EXPECT_NE(std::string(error.what()).find("the largest has 604"), std::string::npos)
      << error.what();
  }
}

TEST(PaddedMask, HoldsTheSameVoxels)
{
  const VoxelMask mask = hollow();
  const VoxelMask more = medial::padded(mask, 2);
  EXPECT_EQ(more.size, (std::array<Index, 3>{ 17, 13, 13 }));
  EXPECT_EQ(more.inside.size(), 17u * 13 * 13);
  for (Index k = -2; k < 11; ++k)
  {
    for (Index j = -2; j < 11; ++j)
    {
      for (Index i = -2; i < 15; ++i)
      {
        EXPECT_EQ(more(i + 2, j + 2, k + 2), mask(i, j, k));
      }
    }
  }
  EXPECT_THROW(medial::padded(mask, 1000), medial::InvalidInput);
}

TEST(BorderVoxels, AreCountedOnEachSide)
{
  EXPECT_EQ(borderVoxels(hollow()), (std::array<Index, 6>{ 81, 0, 81, 81, 81, 81 }));
  EXPECT_EQ(borderVoxels({ { 1, 2, 3 }, { 1, 0, 0, 0, 0, 1 } }),
    (std::array<Index, 6>{ 2, 2, 1, 1, 1, 1 }));
}

TEST(ImageWarnings, TellOfCutsAndOfSmoothing)
{
  EXPECT_TRUE(medial::imageWarnings({ 1, 2, 0 }, { 1, 2, 0 }, {}, {}, {}).empty());
  const medial::Warnings both = medial::imageWarnings(
    { 1, 12, 0 }, { 1, 8, 0 }, { 0, 0, 0, 0, 7, 8 }, medial::Point(1, 2, 3), {});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].code, "cut_at_border");
  EXPECT_EQ(both[0].count, 15);
  EXPECT_EQ(both[0].place, medial::Point(1, 2, 3));
  EXPECT_NE(both[0].text.find("(first k, last k)"), std::string::npos);
  EXPECT_EQ(both[1].code, "smoothed_topology");
  EXPECT_EQ(both[1].count, 4);
  EXPECT_NE(both[1].text.find("12 tunnels"), std::string::npos);
  EXPECT_FALSE(both[0].doubtsSolid || both[1].doubtsSolid);
}
}
