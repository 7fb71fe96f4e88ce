// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Polygons_h
#define medial_Polygons_h

#include "Base/Types.h"

#include <algorithm>
#include <unordered_set>
#include <vector>

namespace medial
{
/// Edges by their two corners.
class EdgeSet
{
public:
  void insert(Index a, Index b) { this->edges.insert(key(a, b)); }
  bool contains(Index a, Index b) const { return this->edges.count(key(a, b)) > 0; }

private:
  static std::uint64_t key(Index a, Index b)
  {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 |
      static_cast<std::uint64_t>(std::max(a, b));
  }
  std::unordered_set<std::uint64_t> edges;
};

/// Cuts a convex polygon into a fan of triangles, oriented as it is.
///
/// A diagonal must not be an edge that exists already, or two faces would be glued together along it.
/// Of the fans without such a diagonal it takes the one whose smallest triangle is largest. If there is
/// none, the centroid is appended to `points`, and the triangles are around it. New edges are added to
/// `edges`. Tries at most 32 fans, each in linear time.
/// @param polygon  at least 3 different corners
/// @param edges    with the sides of all polygons
std::vector<Triangle> triangulate(
  const std::vector<Index>& polygon, std::vector<Point>& points, EdgeSet& edges);
}

#endif
