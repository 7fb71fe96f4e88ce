// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_MaskBetti_h
#define medial_MaskBetti_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Images/VoxelMask.h"

namespace medial
{
/// The Betti numbers of the solid as the union of its voxels, closed cubes: pieces may hang together at
/// corners, and cavities are closed where only corners or edges would lead out.
///
/// Pieces and voids are counted; tunnels follow from the Euler characteristic. In linear time.
/// @throw Aborted
Betti maskBetti(const VoxelMask& mask, const Execution& execution = {});
}

#endif
