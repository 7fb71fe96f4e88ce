// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_FreePlaces_h
#define medial_FreePlaces_h

#include "Base/Types.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace medial
{
/// Finds places for vertices that are added to an axis: in the middle of a side or of a face.
///
/// A middle may be taken. Sides from two merged vertices to a common neighbour have the same middle, and
/// so have two faces with the same corners; where vertices crowd, any other one may lie there. The
/// vertex then gets a place next to it, so that every two vertices are at least half of `coincident`
/// apart. What the vertices belong to is not touched.
class FreePlaces
{
public:
  /// @param taken  the places of all vertices, in a frame
  explicit FreePlaces(const std::vector<Point>& taken);

  /// Takes a place if it is free, else the first free one around it.
  /// @return  the place taken
  Point takeNear(const Point& place);

private:
  using Cube = std::array<std::int64_t, 3>;

  static Cube cube(const Point& place);
  bool isFree(const Point& place) const;
  Point freeNear(const Point& place) const;

  std::map<Cube, std::vector<Point>> cubes; ///< the places in each cube of a grid
};
}

#endif
