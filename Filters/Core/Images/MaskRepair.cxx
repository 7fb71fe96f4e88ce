// SPDX-License-Identifier: BSD-3-Clause
#include "Images/MaskRepair.h"

#include "Base/Errors.h"

#include <algorithm>
#include <limits>

namespace medial
{
namespace
{
/// Turns the voxels of the marked pieces over.
void turn(VoxelMask& mask, const MaskPieces& pieces, const std::vector<char>& marked)
{
  for (Index row = 0; row < pieces.rows.size(); ++row)
  {
    unsigned char* voxels = mask.inside.data() + static_cast<std::size_t>(row) * mask.size[0];
    for (const VoxelRun& run : pieces.rows[row])
    {
      if (marked[run.piece])
      {
        std::fill(voxels + run.begin, voxels + run.end, run.inside ? 0 : 1);
      }
    }
  }
}

void fillCavities(VoxelMask& mask, const MaskPieces& pieces, Index largest, MaskRepairs& repairs)
{
  std::vector<char> marked(pieces.inside.size(), 0);
  for (Index piece = MaskPieces::Outside + 1; piece < count(pieces.inside); ++piece)
  {
    if (!pieces.inside[piece] && pieces.voxels[piece] <= largest)
    {
      marked[piece] = 1;
      ++repairs.filledCavities;
      repairs.filledVoxels += pieces.voxels[piece];
    }
  }
  turn(mask, pieces, marked);
}

Index largestPiece(const MaskPieces& pieces)
{
  Index result = None;
  for (Index piece = 0; piece < count(pieces.inside); ++piece)
  {
    if (pieces.inside[piece] && (result == None || pieces.voxels[piece] > pieces.voxels[result]))
    {
      result = piece;
    }
  }
  return result;
}

void dropPieces(
  VoxelMask& mask, const MaskPieces& pieces, const MaskOptions& options, MaskRepairs& repairs)
{
  const Index largest = largestPiece(pieces);
  if (largest != None && !options.largestOnly && pieces.voxels[largest] < options.smallestKept)
  {
    throw InvalidInput("no piece of the solid has ", options.smallestKept,
      " voxels, the largest has ", pieces.voxels[largest],
      ": keep smaller pieces, or choose another value");
  }
  std::vector<char> marked(pieces.inside.size(), 0);
  for (Index piece = 0; piece < count(pieces.inside); ++piece)
  {
    const bool isKept =
      options.largestOnly ? piece == largest : pieces.voxels[piece] >= options.smallestKept;
    if (pieces.inside[piece] && !isKept)
    {
      marked[piece] = 1;
      ++repairs.droppedPieces;
      repairs.droppedVoxels += pieces.voxels[piece];
    }
  }
  turn(mask, pieces, marked);
}

/// Calls body({ i, j, k }) for each voxel of the solid at the image's border.
template <typename Body>
void forBorderVoxels(const VoxelMask& mask, const Body& body)
{
  for (Index k = 0; k < mask.size[2]; ++k)
  {
    for (Index j = 0; j < mask.size[1]; ++j)
    {
      const bool isBorder = k == 0 || k + 1 == mask.size[2] || j == 0 || j + 1 == mask.size[1];
      const Index step = isBorder ? 1 : std::max(mask.size[0] - 1, Index(1));
      for (Index i = 0; i < mask.size[0]; i += step)
      {
        if (mask(i, j, k))
        {
          body(std::array<Index, 3>{ i, j, k });
        }
      }
    }
  }
}
}

MaskRepairs repairMask(
  VoxelMask& mask, const MaskOptions& options, const Execution& execution, VoxelContact contact)
{
  MaskRepairs repairs;
  fillCavities(mask, maskPieces(mask, execution, contact), options.largestFilled, repairs);
  dropPieces(mask, maskPieces(mask, execution, contact), options, repairs);
  return repairs;
}

VoxelMask padded(const VoxelMask& mask, Index margin)
{
  VoxelMask result{ mask.size, {} };
  for (Index& size : result.size)
  {
    size += 2 * margin;
  }
  const std::size_t rows = static_cast<std::size_t>(result.size[1]) * result.size[2];
  if (rows > std::numeric_limits<Index>::max() / static_cast<std::size_t>(result.size[0]))
  {
    throw InvalidInput("the image has ", result.size[0], " x ", result.size[1], " x ",
      result.size[2], " voxels with its margin: crop it, or take a coarser one");
  }
  result.inside.resize(rows * result.size[0], 0);
  for (Index k = 0; k < mask.size[2]; ++k)
  {
    for (Index j = 0; j < mask.size[1]; ++j)
    {
      const unsigned char* from = mask.inside.data() + mask.row(j, k);
      std::copy(from, from + mask.size[0],
        result.inside.data() + result.row(j + margin, k + margin) + margin);
    }
  }
  return result;
}

std::array<Index, 6> borderVoxels(const VoxelMask& mask)
{
  std::array<Index, 6> result{};
  forBorderVoxels(mask, [&](const std::array<Index, 3>& voxel) {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      result[2 * axis] += voxel[axis] == 0 ? 1 : 0;
      result[2 * axis + 1] += voxel[axis] + 1 == mask.size[axis] ? 1 : 0;
    }
  });
  return result;
}

std::optional<Point> firstBorderVoxel(const VoxelMask& mask)
{
  std::optional<Point> result;
  forBorderVoxels(mask, [&](const std::array<Index, 3>& voxel) {
    result = result.value_or(Point(voxel[0], voxel[1], voxel[2]));
  });
  return result;
}
}
