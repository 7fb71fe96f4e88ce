// SPDX-License-Identifier: BSD-3-Clause
#ifndef VoxelThickness_h
#define VoxelThickness_h

#include "Base/Types.h"

#include <functional>

/// Thickness as programs for voxels measure it, to compare with.
namespace shapes
{
/// The mean over the inner voxels of a cube about the origin of the diameter of the largest ball that fits into the voxels
/// and contains their centre [HR97].
/// @param isInside   the solid
/// @param isCounted  where voxels count for the mean
/// @param half       of the cube's side
/// @param step       side of a voxel
/// @param inward     how far from the centre of an outer voxel the boundary is taken to be, in voxels: 0 or 0.5
double voxelThickness(const std::function<bool(const medial::Point&)>& isInside,
  const std::function<bool(const medial::Point&)>& isCounted, double half, double step,
  double inward);

/// The mean of both conventions for `inward`, extrapolated to voxels of no size from steps `step` and 0.7 of it.
double voxelThickness(const std::function<bool(const medial::Point&)>& isInside,
  const std::function<bool(const medial::Point&)>& isCounted, double half, double step);
}

#endif
