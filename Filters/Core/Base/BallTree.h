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

/// A search tree of balls: finds the ball whose sphere is nearest to a point, the largest one around it, the one with
/// the least power there.
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

  /// Is the distance at most so much? Quicker than to ask for it.
  bool isWithin(const Point& x, double distance) const;

  /// How far, at most, a ball sticks out of the one that covers it best: the least, over all balls of
  /// other groups than its own, of distance of the centres + its radius - the other's radius; not
  /// below 0. Infinite where there is no other group.
  /// @param enough  the search stops at a value of at most this much, which need not be the least
  double protrusion(const Ball& ball, Index group, double enough = 0) const;

  /// The largest ball that contains a point, or None. The lowest number of several.
  /// @param tolerance  how far outside of its sphere the point may be
  Index largestAround(const Point& x, double tolerance) const;

  /// The ball in whose power cell a point is: |x - center|^2 - radius^2 is least. The lowest number of several, None
  /// without balls.
  Index leastPower(const Point& x) const;

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

  /// The least value of a ball, and the lowest number of the balls that have it.
  struct Least
  {
    double value = std::numeric_limits<double>::infinity();
    Index number = None;
  };

  void build(Index begin, Index end);
  double least(const Ball& ball, Index leftOut, double enough) const;

  /// @param bound   of a node: no ball in it has a smaller value; infinite: nothing to find there
  /// @param value   of a member
  /// @param enough  the search stops at a value of at most this much
  template <typename Bound, typename Value>
  Least search(const Bound& bound, const Value& value, double enough) const;

  static double lowerBound(const Node& node, const Point& x);

  std::vector<Member> members; ///< those of a node follow each other
  std::vector<Node> nodes;
};
}

#endif
