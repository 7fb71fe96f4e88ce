// SPDX-License-Identifier: BSD-3-Clause
#ifndef Masks_h
#define Masks_h

#include "Images/VoxelMask.h"

#include <random>

/// Made masks for tests.
namespace masks
{
using medial::Index;
using medial::VoxelMask;

/// Of n^3 voxels, those where isInside(x, y, z) with coordinates -1 ... 1 at the voxels' centres.
template <typename IsInside>
VoxelMask cube(Index n, const IsInside& isInside)
{
  VoxelMask mask{ { n, n, n }, {} };
  const auto at = [n](Index i) { return (2.0 * i + 1) / n - 1; };
  for (Index k = 0; k < n; ++k)
  {
    for (Index j = 0; j < n; ++j)
    {
      for (Index i = 0; i < n; ++i)
      {
        mask.inside.push_back(isInside(at(i), at(j), at(k)) ? 1 : 0);
      }
    }
  }
  return mask;
}

/// @param density  the share of voxels inside
inline VoxelMask random(const std::array<Index, 3>& size, double density, unsigned seed)
{
  std::mt19937 generator(seed);
  VoxelMask mask{ size, {} };
  for (Index i = 0; i < size[0] * size[1] * size[2]; ++i)
  {
    mask.inside.push_back(generator() < density * 4294967296.0 ? 1 : 0);
  }
  return mask;
}
}

#endif
