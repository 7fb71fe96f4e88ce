// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_VertexMerging_h
#define medial_VertexMerging_h

#include "Base/Types.h"

#include <vector>

namespace medial
{
/// A face of the axis before it is triangulated; with two corners it is an edge.
struct Polygon
{
  std::vector<Index> corners;
  Index siteEdge; ///< the edge of the sites' triangulation it is dual to, or None
  Triangle siteFacet = { None, None, None }; ///< corners of the facet that an edge is dual to
};

/// Cuts a closed walk where it visits a vertex again, drops pieces of one corner, and appends the
/// rest to `polygons`. A cut is a chord of the face, contracted: the topology stays.
void appendSimplePolygons(std::vector<Index> walk, Index siteEdge, std::vector<Polygon>& polygons);

/// What mergeVertices did.
struct MergedVertices
{
  std::vector<char> merged;    ///< for each vertex: was it merged into another one?
  std::vector<Edge> midpoints; ///< the ends of the sides in the middle of which a vertex was added;
                               ///< numbered on from the vertices given
};

/// Merges the vertices that have the same pole, or coincide, into one without a change of topology.
///
/// Merging two vertices makes a loop of each path between them. Exactly one such loop must be closed.
/// The merge itself closes some: it cuts a common face, or folds together two edges to a common
/// neighbour. Where it closes none, a new face fills the shortest loop; where it closes several, sides
/// are split until it closes one. Vertices in different pieces stay apart.
/// @param points  of the vertices, in a frame
/// @param ball    the pole that each vertex is, or None
MergedVertices mergeVertices(
  const std::vector<Point>& points, const std::vector<Index>& ball, std::vector<Polygon>& polygons);
}

#endif
