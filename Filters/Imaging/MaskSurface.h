// SPDX-License-Identifier: BSD-3-Clause
#ifndef MaskSurface_h
#define MaskSurface_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Images/MaskRepair.h"
#include "Images/VoxelMask.h"

#include <vector>

class vtkAlgorithm;

namespace medial
{
struct SurfaceSmoothing
{
  double gaussianRadius; ///< of the mask, in voxels; 0: none
  int iterations;        ///< of vtkWindowedSincPolyDataFilter; 0: none
  double passBand;       ///< 0 ... 2
};

/// How many voxels the smoothing of the mask reaches; with one more outside the solid on all sides, its
/// surface is closed.
Index reach(const SurfaceSmoothing& smoothing);

struct MaskSurface
{
  std::vector<Point> points;       ///< in voxels, from the centre of the first one
  std::vector<Triangle> triangles; ///< counter-clockwise seen from outside
  VoxelMask mask;                  ///< the voxels that the surface encloses
};

/// The smoothed surface of a mask, by VTK's filters.
/// @param filter  the one that they work in
/// @param repair  what is filled and dropped of what smoothing has broken
/// @throw InvalidInput  see repairMask()
/// @throw Aborted
MaskSurface maskSurface(vtkAlgorithm* filter, const VoxelMask& mask,
  const SurfaceSmoothing& smoothing, const MaskOptions& repair, const Execution& execution = {});
}

#endif
