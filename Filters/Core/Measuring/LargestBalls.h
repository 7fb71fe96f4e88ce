// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_LargestBalls_h
#define medial_LargestBalls_h

#include "Balls/PolarBalls.h"
#include "Base/BallTree.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <functional>
#include <vector>

namespace medial
{
/// The balls of one side, or some of them, ready to be searched.
class LargestBalls
{
public:
  /// @param counts  which balls of the side; all where there is no test
  LargestBalls(
    const PolarBalls& balls, Side side, const std::function<bool(Index ball)>& counts = {});

  /// The largest ball that contains a place, or None: by the thickness of [HR97] twice its radius is how thick the solid
  /// is there. The lowest number of several.
  /// @param tolerance  how far outside of its sphere the place may be
  Index around(const Point& place, double tolerance = 0) const;

  /// The ball in whose power cell the place would be if there were no others; None without balls.
  Index leastPower(const Point& place) const;

  /// Is the place outside of all balls by more than a distance?
  bool isFar(const Point& place, double distance) const
  {
    return !this->tree.isWithin(place, distance);
  }

private:
  std::vector<Index> numbers; ///< ascending
  BallTree tree;
};

/// For each place the largest ball of a side, or None, that contains it, up to a tolerance. Balls that touch the guard
/// don't count. Quicker than to look for one after another: the largest balls first take the places in them, so that
/// each place is taken once.
std::vector<Index> largestBallsAt(const PolarBalls& balls, Side side,
  const std::vector<Point>& places, double tolerance, const Execution& execution = {});
}

#endif
