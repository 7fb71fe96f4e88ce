// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PowerLocator_h
#define medial_PowerLocator_h

#include "Base/Frame.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Finds the cell of the balls' regular triangulation that contains a point of a frame, by walking.
class PowerLocator
{
public:
  /// @param mesh  of the balls; is referred to
  PowerLocator(const Tetrahedra& mesh, const std::vector<Ball>& balls, const Frame& frame);

  /// The balls in the frame.
  const std::vector<Ball>& balls() const { return this->localBalls; }

  /// @param ball  where to start; not hidden
  /// @return      the cell, or None outside the convex hull of the centres
  Index locate(const Point& p, Index ball) const;

  /// The ball of a cell with the least power at a point.
  Index nearestBall(const Point& p, Index cell) const;

private:
  bool isBeyond(const Point& p, Index cell, int side) const;

  const Tetrahedra& mesh;
  std::vector<Ball> localBalls;
  std::vector<Index> cellAtBall;
};
}

#endif
