// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PlatesAndRods_h
#define medial_PlatesAndRods_h

#include "Axis/MedialAxis.h"
#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Measuring/Elements.h"
#include "Measuring/SheetWidths.h"

#include <vector>

namespace medial
{
/// The plates and rods of a solid, such as trabecular bone.
struct PlatesAndRods
{
  SheetWidths widths;

  /// For each point and for each cell of the axis the plate or rod that it belongs to. None for points
  /// that no cell uses.
  std::vector<Index> elementOfPoint, elementOfCell;

  std::vector<Element>
    elements;           ///< plates by their lowest triangles, then rods by their lowest cells
  IndexLists neighbors; ///< for each element those that it meets, ascending

  // Places where elements meet.
  Index plateJunctions = 0; ///< only plates: seams and necks that hang together
  Index mixedJunctions = 0; ///< plates and rods
  Index rodJunctions = 0;   ///< three or more ends of rods, and no plate
};

struct PlatesAndRodsOptions
{
  double plateRatio = 1.5; ///< plates are wider than this many thicknesses
  double neckRatio =
    0.8; ///< a plate is cut where it is narrower than this part of the narrower side
};

/// Tells plates from rods by SheetWidths, and cuts both into single ones by PlatePieces, RodSkeleton and
/// RodBranches. What lies beside the curve of a rod belongs to the nearest rod along the axis. Bits of
/// rods at a plate that are too short for a rod, such as its rims, belong to the plate. Takes O(n log n)
/// time.
///
/// @throw InvalidInput  a ratio that is not finite, a plateRatio below 1, or a neckRatio not in 0 ... 1
/// @throw Aborted
PlatesAndRods platesAndRods(const MedialAxis& axis, const PlatesAndRodsOptions& options = {},
  const Execution& execution = {});
}

#endif
