// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Erosion_h
#define medial_Erosion_h

#include "Axis/AxisComplex.h"

#include <vector>

namespace medial
{
/// How long the axis withstands a fire from its border, more than the ball there needs: burn time minus
/// radius ([YSC16]), a length >= 0.
struct Erosion
{
  std::vector<double> ofPoint; ///< when everything at the point has burnt
  std::vector<double>
    ofCell; ///< when the fire has come to all corners of the cell, in its own sheet
};

/// Burns the axis. The fire starts at the free ends of lines and the free edges of sheets, at each point
/// at the time of its radius, and runs with unit speed. Over an edge with more than two triangles it
/// goes on into the last sheet when it has come there in all others; into a line when all else has
/// burnt at its end.
///
/// A front goes straight on through triangles; where two fronts meet in one, along its sides. So times
/// are exact for lines and straight fronts, and else off by about the length of an edge.
/// What no fire reaches, such as a closed sheet, has the largest thickness: that of anything else or
/// the diagonal of the bounding box of all balls, whichever is larger.
/// @param axis  points, radii and cells count
Erosion erosion(const AxisComplex& axis);
}

#endif
