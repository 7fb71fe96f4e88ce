// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Neighbors_h
#define medial_Neighbors_h

#include "Base/Execution.h"
#include "Base/Types.h"

#include <memory>
#include <vector>

namespace medial
{
/// Finds the nearest of a set of points. Built in O(n log n); a search takes O(k log n).
class Neighbors
{
public:
  /// @param points  are referred to
  explicit Neighbors(const std::vector<Point>& points);
  ~Neighbors();

  /// The other points nearest to a point, nearest first; fewer where there are not so many. Threads
  /// may search at the same time.
  std::vector<Index> nearest(Index point, Index howMany) const;

  /// The points nearest to a place, nearest first; fewer where there are not so many.
  std::vector<Index> nearest(const Point& place, Index howMany) const;

  /// The points, itself among them, that are at most so far from a point; in no particular order.
  std::vector<Index> within(Index point, double distance) const;

  /// The points that are at most so far from a place; in no particular order.
  std::vector<Index> within(const Point& place, double distance) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation;
};

/// Mean distance of each point from its six nearest; 0 where there is no other one.
/// @param neighbors  of the points
std::vector<double> meanDistances(
  const std::vector<Point>& points, const Neighbors& neighbors, const Execution& execution = {});
}

#endif
