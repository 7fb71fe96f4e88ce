// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PolygonIncidence_h
#define medial_PolygonIncidence_h

#include "Axis/FacePolygon.h"
#include "Base/Types.h"

#include <algorithm>
#include <set>
#include <vector>

namespace medial
{
/// Polygons with shared vertices, and which of them are at each vertex while they change.
class PolygonIncidence
{
public:
  /// @param facePolygons  are changed in place and must outlive this
  PolygonIncidence(std::vector<FacePolygon>& facePolygons, Index vertexCount);

  /// The ends of the sides in the middle of which a vertex was added, which may have been added
  /// themselves; numbered on from the first vertices.
  const std::vector<Edge>& midpoints() const { return this->splitSides; }

  const std::vector<Index>& corners(Index polygon) const { return this->polygons[polygon].corners; }

  /// Calls body(polygon, place of the vertex among its corners) for the polygons at a vertex.
  template <typename Body>
  void forPolygonsAt(Index vertex, const Body& body) const
  {
    for (const Index p : this->at[vertex])
    {
      const std::vector<Index>& corners = this->corners(p);
      const auto place = std::find(corners.begin(), corners.end(), vertex);
      if (place != corners.end()) // else the entry is stale
      {
        body(p, static_cast<Index>(place - corners.begin()));
      }
    }
  }

  /// As many polygons as are at a vertex, or somewhat more.
  Index entries(Index vertex) const { return count(this->at[vertex]); }

  /// The vertices with which a vertex shares a side.
  std::set<Index> neighbors(Index vertex) const;

  /// Do two vertices share a side?
  bool areNeighbors(Index a, Index b) const;

  /// From a to b along sides, both included, with the fewest sides; empty where there is no path.
  std::vector<Index> shortestPath(Index a, Index b) const;

  void append(FacePolygon polygon);

  /// Puts a new vertex in the middle of the side between two neighbours, in all polygons that have it.
  /// @return  the vertex
  Index splitSide(Index a, Index b);

  /// Cuts the corner `vertex` off a polygon as a triangle, through the middles of its two sides.
  void cutOffCorner(Index polygon, Index vertex);

  /// Replaces a vertex by another one. A polygon that has both falls apart into simple ones, which are
  /// appended; what it was has no corners any more.
  void rename(Index from, Index to);

private:
  void enter(Index polygon);

  std::vector<FacePolygon>& polygons;
  std::vector<std::vector<Index>> at; ///< the polygons at each vertex, and some that no longer are
  std::vector<Edge> splitSides;
};

/// The corner `step` places further on around a polygon.
inline Index cornerAfter(const std::vector<Index>& corners, Index place, Index step)
{
  const Index n = count(corners);
  return corners[(place + n + step) % n];
}
}

#endif
