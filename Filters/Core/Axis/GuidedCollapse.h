// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_GuidedCollapse_h
#define medial_GuidedCollapse_h

#include "Axis/ShapeComplex.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Collapses all tetrahedra of a shape so that smooth sheets are left, with nearly all points on them.
/// @param centers  of the shape's points
void collapseToSheets(
  ShapeComplex& shape, const std::vector<Point>& centers, const Execution& execution = {});
}

#endif
