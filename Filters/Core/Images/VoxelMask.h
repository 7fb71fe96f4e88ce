// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_VoxelMask_h
#define medial_VoxelMask_h

#include "Base/Types.h"

#include <array>
#include <cstddef>
#include <vector>

namespace medial
{
/// Which voxels of an image belong to the solid. What is beyond the image doesn't.
///
/// There are fewer voxels than an Index can count.
struct VoxelMask
{
  std::array<Index, 3> size;         ///< voxels along i, j and k
  std::vector<unsigned char> inside; ///< 1 or 0 for each voxel, i fastest

  /// The place of a row along i in `inside`.
  std::size_t row(Index j, Index k) const
  {
    return (static_cast<std::size_t>(k) * this->size[1] + j) * this->size[0];
  }

  bool operator()(Index i, Index j, Index k) const
  {
    return i >= 0 && i < this->size[0] && j >= 0 && j < this->size[1] && k >= 0 &&
      k < this->size[2] && this->inside[this->row(j, k) + i] != 0;
  }
};
}

#endif
