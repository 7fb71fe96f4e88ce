// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PlatePieces_h
#define medial_PlatePieces_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Base/Execution.h"
#include "Measuring/SheetWidths.h"

#include <vector>

namespace medial
{
/// Where an axis is a plate, and the single plates of a network of them.
struct PlatePieces
{
  std::vector<Index> ofTriangle; ///< for each triangle its plate 0 ... count - 1, by the lowest
                                 ///< triangles; None: it is no plate
  std::vector<char> isFin;       ///< for each triangle: of a low sheet that stands on a plate
  Index count = 0;
};

/// Finds the triangles of plates, those with two corners of more than `plateRatio`, and cuts what hangs
/// together into single plates:
///
/// 1. A plate that is smaller than 1.5 squares of its thickness, or of the spacing of the samples, is none,
///    unless it holds half of the volume of its connected piece of the axis: it is where rods meet.
/// 2. Cut along seams, where three or more sheets meet. Sheets that on their own are not wider than
///    `plateRatio` are fins of what they stand on: where they go, the others grow together, unless a
///    longer seam is between them.
/// 3. Cut along the bottom of the valley between two summits of the burn time, where it is below
///    `neckRatio` of the lower one: the plate's width is there below this part of the narrower side's.
/// 4. Fins, and pieces that are too small, as in 1, go to the plate that they share the
///    longest border with.
///
/// Where four sheets meet along one line they are four plates in most samplings of the solid, but may be
/// three or two: then the axis itself goes on over gaps in the seam.
///
/// Takes O(n log^2 n) time.
/// @param plateRatio  least W / T of a plate
/// @param neckRatio   0 ... 1; 0 cuts no necks
PlatePieces platePieces(const MedialAxis& axis, const AxisEdges& edges, const SheetWidths& widths,
  double plateRatio, double neckRatio, const Execution& execution = {});
}

#endif
