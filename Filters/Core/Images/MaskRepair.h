// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_MaskRepair_h
#define medial_MaskRepair_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Images/MaskPieces.h"
#include "Images/VoxelMask.h"

#include <optional>

namespace medial
{
struct MaskOptions
{
  Index largestFilled = 50; ///< cavities of up to so many voxels are filled; 0: none
  bool largestOnly = false; ///< keep the largest piece alone; of equal ones the first
  Index smallestKept = 50;  ///< else pieces of at least so many voxels; 1: all
};

/// What repairMask() has done.
struct MaskRepairs
{
  Index filledCavities = 0;
  Index filledVoxels = 0;
  Index droppedPieces = 0;
  Index droppedVoxels = 0;
};

/// Fills small cavities, then drops small pieces. What lies in a filled cavity becomes part of the solid
/// around it.
/// @param contact  tells what is a piece and what is a cavity
/// @throw InvalidInput  no piece is as large as smallestKept; says how large the largest is
/// @throw Aborted
MaskRepairs repairMask(VoxelMask& mask, const MaskOptions& options, const Execution& execution = {},
  VoxelContact contact = VoxelContact::Cubes);

/// The mask with `margin` more voxels on all sides, which are outside the solid.
/// @throw InvalidInput  there are too many voxels then
VoxelMask padded(const VoxelMask& mask, Index margin);

/// How many voxels of the solid lie at the image's border, at the first and last of i, j and k in turn.
std::array<Index, 6> borderVoxels(const VoxelMask& mask);

/// The first of these voxels, as i, j and k.
std::optional<Point> firstBorderVoxel(const VoxelMask& mask);
}

#endif
