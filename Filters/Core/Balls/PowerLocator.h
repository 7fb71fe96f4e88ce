// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PowerLocator_h
#define medial_PowerLocator_h

#include "Balls/StartCells.h"
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

  /// A cell of a ball that isn't hidden, to start in on the way to a point.
  Index cellTowards(const Point& p, Index ball) const { return this->starts.towards(p, ball); }

  /// How far a cell with a ball is likely to be from a point, for comparing: those of a ball with many cells are
  /// far from each other.
  double remoteness(const Point& p, Index ball) const
  {
    return (this->localBalls[ball].center - p).squaredNorm() * this->starts.cellCount(ball);
  }

  /// @param start  the cell where to start: the nearer, the faster
  /// @return       the cell, or None outside the convex hull of the centres
  Index locate(const Point& p, Index start) const;

  /// The ball of a cell with the least power at a point.
  Index nearestBall(const Point& p, Index cell) const;

private:
  bool isBeyond(const Point& p, Index cell, int side) const;

  const Tetrahedra& mesh;
  std::vector<Ball> localBalls;
  StartCells starts;
};
}

#endif
