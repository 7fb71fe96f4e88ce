// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_MaskDifference_h
#define medial_MaskDifference_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Images/VoxelMask.h"

#include <optional>

namespace medial
{
/// A voxel where the topology of two masks of the same size differs, as i, j and k; none if it is the same
/// as far as this can tell.
///
/// Voxels that differ change sides one by one, as long as the union of the solid's voxels as closed cubes
/// keeps its topology by that (simple points); in turns, until none can. The largest group that is left tells
/// the place: a tunnel opens or closes there, or a piece or cavity goes or comes. Linear time for each turn.
/// @throw Aborted
std::optional<Point> topologyDifference(
  VoxelMask from, const VoxelMask& to, const Execution& execution = {});

/// A voxel of the solid that touches another one by an edge or a corner only, as i, j and k; none if there is no such voxel.
/// The two are connected, but not in a contour.
/// @throw Aborted
std::optional<Point> bareContact(const VoxelMask& mask, const Execution& execution = {});
}

#endif
