// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PowerShape_h
#define medial_PowerShape_h

#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// A triangle of the power shape that doesn't lie between two of its tetrahedra.
struct ShapeTriangle
{
  Triangle balls; ///< ascending
  /// The cells on its two sides (None: outside the convex hull). One of them is in the power shape
  /// for a regular triangle, none for a singular triangle.
  std::array<Index, 2> cells;
};

/// The power shape: all simplices of the balls' regular triangulation whose corners are inner
/// balls (paper 2.1). It has the topology of the solid. Balls are labelled before the shape is built.
///
/// Unlike the dual shape of the union of balls (alpha = 0) it depends on labels alone, not on whether
/// balls overlap. All balls through a sample meet there, so rounding error would decide that.
struct PowerShape
{
  std::vector<char>
    contains; ///< for each cell of the balls' triangulation: is it in the power shape?
  std::vector<ShapeTriangle> triangles;
  Betti betti;
};

/// The power shape of `polarBalls`.
PowerShape powerShape(const PolarBalls& polarBalls, const Execution& execution = {});
}

#endif
