// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_MissedDetails_h
#define medial_MissedDetails_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Samples/BlueNoise.h"
#include "Samples/LocalThickness.h"
#include "Samples/SpacingField.h"

#include <vector>

namespace medial
{
/// For each triangle, which connected piece of the surface it belongs to: the lowest point of the piece.
std::vector<Index> pieceOfTriangle(const std::vector<Triangle>& triangles, Index pointCount);

/// A place of the surface where samples that are spread by area may miss something.
struct Detail
{
  SurfacePoint place; ///< the middle of a triangle
  double
    area; ///< of the connected piece that it is on, or of all triangles where something is missed
};

/// Grains, and pores inside the solid: connected pieces that samples with this spacing would be few on, or miss. Some
/// triangles of each.
std::vector<Detail> smallPieces(const TriangleSet& surface, double spacing);

/// Connected pieces that have so few samples that these tell no shape. Some triangles of each.
/// @param samples  of the surface
std::vector<Detail> barePieces(
  const TriangleSet& surface, const std::vector<SurfacePoint>& samples);

/// Spikes: triangles with a corner that is much farther from all samples than the spacing there.
/// @param samples  of the surface, not none
std::vector<Detail> spikes(const TriangleSet& surface, const std::vector<SurfacePoint>& samples,
  const SpacingField& spacing, const Execution& execution = {});

/// Small handles and the like: triangles that face away from the nearest sample's.
/// @param samples  of the surface, not none
std::vector<Detail> hiddenSides(const TriangleSet& surface,
  const std::vector<SurfacePoint>& samples, const Execution& execution = {});
}

#endif
