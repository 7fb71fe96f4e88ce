// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Erosion_h
#define medial_Erosion_h

#include "Axis/AxisComplex.h"
#include "Base/Execution.h"

#include <vector>

namespace medial
{
/// Erosion thickness ([YSC16]): the arrival time of a fire that burns the axis from its border, minus the
/// radius of the maximal ball. A length >= 0, large where a part reaches far beyond the balls at its
/// root.
struct Erosion
{
  std::vector<double> ofPoint; ///< when everything at the point has burnt
  std::vector<double>
    ofCell; ///< when the fire has come to all corners of the cell, in its own sheet
};

/// Burns the axis.
///
/// The fire starts at the free ends of lines and the free edges of sheets, at each point at the time of
/// its radius, and runs with unit speed. At an edge with more than two triangles it enters the last
/// sheet when it has come there in all the others. It enters a line when everything else at the end of
/// the line has burnt.
///
/// A front goes straight on through triangles; where two fronts meet in a triangle it runs along the
/// sides. So times are exact for lines and straight fronts, and else off by about the length of an edge.
/// What no fire reaches, such as a closed sheet, has the largest thickness: that of anything else or
/// the diagonal of the bounding box of all balls, whichever is larger.
/// @param axis  points, radii and cells count
Erosion erosion(const AxisComplex& axis, const Execution& execution = {});
}

#endif
