// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_FacePolygon_h
#define medial_FacePolygon_h

#include "Base/Types.h"

#include <vector>

namespace medial
{
/// A Voronoi face of the axis before it is triangulated; with two corners it is an edge.
struct FacePolygon
{
  std::vector<Index> corners; ///< in order around the face
  Index siteEdge;             ///< the edge of the sites' triangulation it is dual to, or None
  Triangle siteFacet = { None, None, None }; ///< corners of the facet that an edge is dual to
};

/// Cuts a closed walk where it visits a vertex again, drops pieces of one corner, and appends the
/// rest to `polygons`. A cut is a chord of the face, contracted: the topology stays.
///
/// For example the walk 1 2 3 4 2 5 becomes the polygons 2 3 4 and 1 2 5.
void appendSimplePolygons(
  const std::vector<Index>& walk, Index siteEdge, std::vector<FacePolygon>& polygons);
}

#endif
