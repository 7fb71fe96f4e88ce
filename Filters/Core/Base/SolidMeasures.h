// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SolidMeasures_h
#define medial_SolidMeasures_h

#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// What a triangulated surface tells of the solid that it encloses. Verified on the triangles, not taken
/// over from how they were made.
struct SolidMeasures
{
  bool closed;   ///< every edge lies between two triangles, in opposite directions
  bool manifold; ///< and the triangles at every point form one fan
  Betti betti;   ///< of the enclosed solid, if the surface is a closed manifold
  double volume; ///< enclosed
};

/// Measures the solid in about linear time.
///
/// Each connected piece of a closed surface is an outer boundary if its volume is positive, else the
/// boundary of a void. A piece of genus g adds g tunnels; 2 - 2 g is its vertices - edges + triangles.
/// @param triangles  counter-clockwise seen from outside
SolidMeasures solidMeasures(const std::vector<Point>& points,
  const std::vector<Triangle>& triangles, const Execution& execution = {});
}

#endif
