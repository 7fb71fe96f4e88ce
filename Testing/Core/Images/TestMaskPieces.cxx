// SPDX-License-Identifier: BSD-3-Clause
#include "Images/MaskPieces.h"

#include "Masks.h"

#include <gtest/gtest.h>

#include <vector>

using medial::Index;
using medial::MaskPieces;
using medial::maskPieces;
using medial::VoxelContact;
using medial::VoxelMask;

namespace
{
/// For each voxel its piece.
std::vector<Index> labels(const MaskPieces& pieces)
{
  std::vector<Index> result;
  for (Index row = 0; row < pieces.rows.size(); ++row)
  {
    for (const medial::VoxelRun& run : pieces.rows[row])
    {
      result.insert(result.end(), run.end - run.begin, run.piece);
    }
  }
  return result;
}

/// Do two voxels that are at most a step apart along each axis touch?
bool touch(const VoxelMask& mask, VoxelContact contact, const std::array<Index, 3>& a,
  const std::array<Index, 3>& b)
{
  const Index steps = std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
  const bool inside = mask(a[0], a[1], a[2]);
  const Index most = contact == VoxelContact::Cubes ? (inside ? 3 : 1) : inside ? 1 : 2;
  return inside == mask(b[0], b[1], b[2]) && steps <= most;
}

/// For each voxel the number of its piece, found by walking from voxel to voxel; those outside begin
/// with 0.
std::vector<Index> walked(const VoxelMask& mask, VoxelContact contact)
{
  std::vector<Index> result(mask.inside.size(), medial::None);
  Index next = 1;
  const auto walk = [&](const std::array<Index, 3>& start, Index piece) {
    std::vector<std::array<Index, 3>> open{ start };
    while (!open.empty())
    {
      const auto at = open.back();
      open.pop_back();
      Index& label = result[mask.row(at[1], at[2]) + at[0]];
      if (label != medial::None)
      {
        continue;
      }
      label = piece;
      for (Index step = 0; step < 27; ++step)
      {
        const std::array<Index, 3> to{ at[0] + step % 3 - 1, at[1] + step / 3 % 3 - 1,
          at[2] + step / 9 - 1 };
        const bool isThere = to[0] >= 0 && to[0] < mask.size[0] && to[1] >= 0 &&
          to[1] < mask.size[1] && to[2] >= 0 && to[2] < mask.size[2];
        if (isThere && to != at && touch(mask, contact, at, to))
        {
          open.push_back(to);
        }
      }
    }
  };
  for (const bool outside : { true, false })
  {
    for (Index k = 0; k < mask.size[2]; ++k)
    {
      for (Index j = 0; j < mask.size[1]; ++j)
      {
        for (Index i = 0; i < mask.size[0]; ++i)
        {
          const bool border = i == 0 || j == 0 || k == 0 || i + 1 == mask.size[0] ||
            j + 1 == mask.size[1] || k + 1 == mask.size[2];
          const bool isNew = result[mask.row(j, k) + i] == medial::None;
          if (isNew && (!outside || (border && !mask(i, j, k))))
          {
            walk({ i, j, k }, outside ? 0 : next++);
          }
        }
      }
    }
  }
  return result;
}

TEST(MaskPieces, AreThoseThatAWalkFinds)
{
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    const std::array<Index, 3> size{ static_cast<Index>(1 + seed % 7),
      static_cast<Index>(5 - seed % 4), 6 };
    const VoxelMask mask = masks::random(size, 0.1 + 0.8 * (seed % 11) / 10, seed);
    for (const VoxelContact contact : { VoxelContact::Cubes, VoxelContact::Contour })
    {
      EXPECT_EQ(labels(maskPieces(mask, {}, contact)), walked(mask, contact)) << "seed " << seed;
    }
  }
}

TEST(MaskPieces, CountTheirVoxels)
{
  const VoxelMask mask = masks::random({ 6, 7, 8 }, 0.5, 3);
  const MaskPieces pieces = maskPieces(mask);
  std::vector<Index> counted(pieces.inside.size(), 0);
  const std::vector<Index> label = labels(pieces);
  for (std::size_t i = 0; i < label.size(); ++i)
  {
    ++counted[label[i]];
    EXPECT_EQ(pieces.inside[label[i]], mask.inside[i]);
  }
  EXPECT_EQ(counted, pieces.voxels);
}

TEST(MaskPieces, CanBeStopped)
{
  medial::Execution execution;
  execution.progress = [](double) { return false; };
  EXPECT_THROW(maskPieces(masks::random({ 4, 4, 4 }, 0.5, 0), execution), medial::Aborted);
}
}
