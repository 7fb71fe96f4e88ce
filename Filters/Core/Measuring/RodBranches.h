// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_RodBranches_h
#define medial_RodBranches_h

#include "Axis/MedialAxis.h"
#include "Base/Lists.h"
#include "Measuring/RodSkeleton.h"

#include <vector>

namespace medial
{
/// The single rods of a skeleton, and where they meet.
struct RodBranches
{
  IndexLists points; ///< of each rod, with its ends; points of junctions are of several
  /// Of each rod, to the centres of the largest balls at junctions. In strides of a radius, so that corners
  /// of triangles that lie beside the curve do not make it longer.
  std::vector<double> length;

  IndexLists rodsAtJunction;    ///< for each junction its rods, ascending
  IndexLists pointsAtJunction;  ///< for each junction the points of the skeleton in it, ascending
  IndexLists anchorsAtJunction; ///< for each junction the anchors in it
};

/// Cuts the skeleton where more than two lines meet and at anchors. Two such places are one junction
/// where the way between them is shorter than the sum of the radii there, or than the spacing of the samples. Two rods that end at a place without a third
/// one, and without an anchor, are one rod. Rods are numbered by their first lines.
/// @param covering  for each point, see CoveringBalls.h
RodBranches rodBranches(const MedialAxis& axis, const RodSkeleton& skeleton,
  const std::vector<char>& anchor, const std::vector<Index>& covering);
}

#endif
