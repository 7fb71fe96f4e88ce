// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_MoreNeighbors_h
#define medial_MoreNeighbors_h

#include "Base/Neighbors.h"

#include <vector>

namespace medial
{
/// Finds the nearest of many points, of which all but the last few are known from before: only the last ones are
/// sorted into a tree, so that it costs little to try a few points after the others.
class MoreNeighbors
{
public:
  /// @param first   finds those of the points that come first; is referred to
  /// @param points  all; are referred to
  MoreNeighbors(const Neighbors& first, const std::vector<Point>& points)
    : known(first)
    , all(points)
    , last(points.begin() + first.size(), points.end())
    , added(this->last)
  {
  }
  MoreNeighbors(const MoreNeighbors&) = delete;
  MoreNeighbors& operator=(const MoreNeighbors&) = delete;

  /// The point nearest to a place; None if there is none.
  Index nearestOne(const Point& place) const
  {
    const Index old = this->known.nearestOne(place);
    const Index nearer = old == None
      ? this->added.nearestOne(place)
      : this->added.nearestOne(place, (this->all[old] - place).norm());
    return nearer == None ? old : this->known.size() + nearer;
  }

  /// The points that are at most so far from a place; in no particular order.
  std::vector<Index> within(const Point& place, double distance) const
  {
    std::vector<Index> result = this->known.within(place, distance);
    this->added.forEachWithin(
      place, distance, [&](Index point) { result.push_back(this->known.size() + point); });
    return result;
  }

private:
  const Neighbors& known;
  const std::vector<Point>& all;
  std::vector<Point> last;
  Neighbors added; ///< the last ones
};
}

#endif
