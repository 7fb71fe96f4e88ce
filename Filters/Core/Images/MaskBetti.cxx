// SPDX-License-Identifier: BSD-3-Clause
#include "Images/MaskBetti.h"

#include "Images/MaskPieces.h"

#include <algorithm>
#include <cstdint>

namespace medial
{
namespace
{
/// Corners - edges + faces - cubes of all cubes that begin at a corner of the grid.
/// @param cubes  bit x + 2 y + 4 z: is the voxel at offset x - 1, y - 1, z - 1 of the corner inside?
int cellsAt(int cubes)
{
  constexpr int x = 0b10101010, y = 0b11001100, z = 0b11110000; // those on one side of the corner
  const auto any = [cubes](int among) { return (cubes & among) != 0 ? 1 : 0; };
  return any(0xff) - any(x) - any(y) - any(z) + any(x & y) + any(y & z) + any(z & x) -
    any(x & y & z);
}

std::int64_t eulerCharacteristic(const VoxelMask& mask, const Execution& execution)
{
  std::array<int, 256> cells;
  for (int cubes = 0; cubes < 256; ++cubes)
  {
    cells[cubes] = cellsAt(cubes);
  }
  std::int64_t result = 0;
  for (Index k = 0; k <= mask.size[2]; ++k)
  {
    for (Index j = 0; j <= mask.size[1]; ++j)
    {
      execution.pollAt(j);
      int cubes = 0; // as i grows, the far side becomes the near one
      for (Index i = 0; i <= mask.size[0]; ++i)
      {
        cubes = (cubes >> 1) & 0b01010101;
        cubes |= mask(i, j - 1, k - 1) << 1 | mask(i, j, k - 1) << 3 | mask(i, j - 1, k) << 5 |
          mask(i, j, k) << 7;
        result += cells[cubes];
      }
    }
  }
  return result;
}
}

Betti maskBetti(const VoxelMask& mask, const Execution& execution)
{
  const MaskPieces pieces = maskPieces(mask, execution);
  const auto solid = std::count(pieces.inside.begin(), pieces.inside.end(), 1);
  const auto voids = static_cast<std::int64_t>(pieces.inside.size()) - solid - 1;
  const std::int64_t tunnels = solid + voids - eulerCharacteristic(mask, execution);
  return { static_cast<Index>(solid), static_cast<Index>(tunnels), static_cast<Index>(voids) };
}
}
