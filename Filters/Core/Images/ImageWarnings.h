// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ImageWarnings_h
#define medial_ImageWarnings_h

#include "Base/Types.h"
#include "Base/Warnings.h"

#include <array>

namespace medial
{
/// What the surface of a segmented image leaves out or adds.
/// @param segmentation  of the voxels
/// @param surface       of the solid that the surface encloses
/// @param cut           see borderVoxels(); all 0 where the surface isn't closed there
/// @param cutAt         one of these voxels
/// @param differsAt     where the surface's topology differs from that of the voxels
Warnings imageWarnings(const Betti& segmentation, const Betti& surface,
  const std::array<Index, 6>& cut, const std::optional<Point>& cutAt,
  const std::optional<Point>& differsAt);
}

#endif
