// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_RimTrimming_h
#define medial_RimTrimming_h

#include "Axis/AxisComplex.h"
#include "Axis/Erosion.h"
#include "Base/Execution.h"

#include <vector>

namespace medial
{
/// Takes from the rims of an axis what small bumps of the surface have put there: long spikes of almost no erosion
/// thickness. A sheet is trimmed from its free edges inwards. What is left of a sheet that is noise everywhere, as in
/// a round shaft, is a line; where such a line ends, a little of it goes, too. Lines of the axis itself are trimmed as
/// sheets are.
///
/// Only free faces go, so that the topology stays, and at least one ball of each piece.
/// @param spacings  for each cell how far samples are apart there
/// @param trim      a triangle may go if its erosion thickness is at most so many spacings
/// @return          without the points that no cell has any more
AxisComplex trimmedRims(const AxisComplex& axis, const Erosion& erosion,
  const std::vector<double>& spacings, double trim, const Execution& execution = {});
}

#endif
