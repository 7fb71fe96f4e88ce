// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_MaskPieces_h
#define medial_MaskPieces_h

#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/Types.h"
#include "Images/VoxelMask.h"

#include <vector>

namespace medial
{
/// Voxels begin ... end - 1 of a row along i, all inside the solid or all outside.
struct VoxelRun
{
  Index begin, end;
  bool inside;
  Index piece;
};

/// Which voxels touch.
enum class VoxelContact
{
  /// As in the union of the solid's voxels as closed cubes: those of the solid where they share a corner,
  /// those outside where they share a face.
  Cubes,
  /// As in the surface at one half by Marching Cubes: those of the solid where they share a face, those
  /// outside where they share an edge.
  Contour
};

/// The connected pieces of a solid and of what is around it.
struct MaskPieces
{
  /// The piece of all that is connected with what is beyond the image.
  static constexpr Index Outside = 0;

  Lists<VoxelRun> rows; ///< the runs of each row, in the order of the voxels; row j + k * size[1]
  std::vector<char> inside; ///< for each piece: is it of the solid? Else it is a cavity, or Outside
  std::vector<Index> voxels; ///< how many each piece has
};

/// Pieces are numbered by their first voxels. In linear time, but for union-find.
/// @throw Aborted
MaskPieces maskPieces(const VoxelMask& mask, const Execution& execution = {},
  VoxelContact contact = VoxelContact::Cubes);
}

#endif
