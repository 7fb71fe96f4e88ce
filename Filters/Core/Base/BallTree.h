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

/// A search tree of balls: finds the ball whose sphere is nearest to a point.
///
/// A k-d tree of the centres: each node holds the bounding box of its centres and its largest
/// radius. Built in O(n log n); a search usually visits O(log n) nodes. The values found are exactly
/// those that a loop over all balls would give.
class BallTree
{
public:
  explicit BallTree(const std::vector<Ball>& balls);

  /// @param groups  a number for each ball, 0 or more: `protrusion` leaves one group out
  BallTree(const std::vector<Ball>& balls, const std::vector<Index>& groups);

  /// The distance of a point to the union of all balls: the least of |x - center| - radius. Negative
  /// inside; infinite without balls.
  /// @param enough  the search stops at a value of at most this much, which need not be the least
  double distance(const Point& x, double enough = -std::numeric_limits<double>::infinity()) const;

  /// How far, at most, a ball sticks out of the one that covers it best: the least, over all balls of
  /// other groups than its own, of distance of the centres + its radius - the other's radius; not
  /// below 0. Infinite where there is no other group.
  /// @param enough  the search stops at a value of at most this much, which need not be the least
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
    Index group;        ///< of all its balls, or `Mixed`
    Index begin, end;   ///< its balls
    Index second;       ///< its second child; the first one follows it; None for a leaf
  };

  // Instead of a group:
  static constexpr Index Mixed = -1;   ///< the node's balls are of several groups
  static constexpr Index Nothing = -2; ///< nothing is left out of a search

  void build(Index begin, Index end);
  double least(const Ball& ball, Index leftOut, double enough) const;
  static double lowerBound(const Node& node, const Ball& ball);

  std::vector<Member> members; ///< those of a node follow each other
  std::vector<Node> nodes;
};
}

#endif
