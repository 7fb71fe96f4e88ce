// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ChangedRegions_h
#define medial_ChangedRegions_h

#include "Base/Types.h"

#include <vector>

namespace medial
{
/// A region of space that is divided into cells differently with and without some balls.
struct ChangedRegion
{
  std::vector<Index> balls;   ///< corners of its cells, with and without, ascending
  std::vector<Index> removed; ///< those of them that are missing in the second, ascending

  // The cells that fill the region, corners ascending, in ascending order.
  std::vector<Tetrahedron> with, without;
};

/// The regions in which two regular triangulations differ, by their lowest removed ball. Cells that are
/// in one of the two only are joined across triangles. The rest of both is the same, so what happens
/// in one region doesn't depend on the others. Takes linear time in
/// the cells.
/// @param with     cells of the triangulation of all balls
/// @param without  of all but the removed ones
/// @param removed  ascending
std::vector<ChangedRegion> changedRegions(std::vector<Tetrahedron> with,
  std::vector<Tetrahedron> without, const std::vector<Index>& removed);
}

#endif
