// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ElementLabels_h
#define medial_ElementLabels_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Base/Execution.h"
#include "Measuring/Elements.h"
#include "Measuring/PlatePieces.h"
#include "Measuring/RodBranches.h"
#include "Measuring/RodCells.h"

#include <vector>

namespace medial
{
/// Which plate or rod everything belongs to.
struct ElementLabels
{
  std::vector<Index> ofPoint; ///< the element of each point, None where no cell uses it
  std::vector<Index> ofCell;  ///< the element of each cell
  std::vector<Index> ofRod;   ///< the element that each rod of RodBranches is; None: it has no cell
  std::vector<Element> elements; ///< not measured, but for the lengths of rods
};

/// Cells and points of plates belong to their plate, those of rods to the rod that is nearest along the axis.
/// Pieces of rods in which no curve is left go to the plates that they touch; where there are none they
/// are rods without a length. Elements are numbered plates first, then rods by their lowest cells.
/// A point where plates meet is of the one whose triangle at it burns last.
ElementLabels elementLabels(const MedialAxis& axis, const AxisEdges& edges,
  const PlatePieces& plates, const RodCells& rods, const RodBranches& branches,
  const Execution& execution = {});
}

#endif
