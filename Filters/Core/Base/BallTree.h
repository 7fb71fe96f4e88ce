// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_BallTree_h
#define medial_BallTree_h

#include "Base/Types.h"

#include <limits>
#include <vector>

namespace medial
{
/// The diagonal of the bounding box of the balls; 0 without any.
double boundingDiagonal(const std::vector<Ball>& balls);

/// Balls in groups, sorted so that the nearest one of another group is found quickly.
class BallTree
{
public:
  /// @param groups  for each ball
  BallTree(const std::vector<Ball>& balls, const std::vector<Index>& groups);

  /// How far, at most, a ball sticks out of the one that covers it best: the least, over all balls of
  /// other groups than its own, of distance + its radius - the other's; not below 0. Infinite where
  /// there is no other group.
  /// @param enough  what is at most this much need not be found exactly: any such value may come back
  double protrusion(const Ball& ball, Index group, double enough = 0) const;

private:
  struct Member
  {
    Ball ball;
    Index group, number;
  };

  struct Node
  {
    Point lower, upper; ///< of the centres
    double radius;      ///< largest
    Index group;        ///< of all balls, or None
    Index begin, end;   ///< its balls
    Index second;       ///< its second child; the first one follows it; None for a leaf
  };

  void build(Index begin, Index end);
  static double leastProtrusion(const Node& node, const Ball& ball);

  std::vector<Member> members; ///< those of a node follow each other
  std::vector<Node> nodes;
};
}

#endif
