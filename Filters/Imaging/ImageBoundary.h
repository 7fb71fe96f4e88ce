// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImageBoundary_h
#define ImageBoundary_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Base/Warnings.h"
#include "Images/MaskRepair.h"
#include "Images/VoxelMask.h"
#include "Imaging/MaskSurface.h"

class vtkAlgorithm;

namespace medial
{
struct BoundaryOptions
{
  MaskOptions repair;
  bool pad; ///< close the surface at the image's border
  SurfaceSmoothing smoothing;
};

/// Voxels outside the solid that an image needs on each side.
Index marginOf(const BoundaryOptions& options);

/// The surface of the solid in an image, and what was done for it.
struct ImageBoundary
{
  MaskRepairs repairs;
  std::array<Index, 6> cut; ///< see borderVoxels()
  Index margin;             ///< voxels that the image was padded by
  VoxelMask mask;           ///< as used, padded
  Betti segmentation;       ///< of the mask
  MaskSurface surface;
  Betti betti;       ///< of the surface; all 0 if it is not closed
  Warnings warnings; ///< their places are in voxels, as the points of the surface
};

/// Mends the mask, smooths and meshes it.
/// @param filter  the one that VTK's filters work in
/// @throw InvalidInput  see repairMask() and padded(), or the smoothing leaves nothing
/// @throw Aborted
ImageBoundary imageBoundary(vtkAlgorithm* filter, VoxelMask mask, const BoundaryOptions& options,
  const Execution& execution = {});
}

#endif
