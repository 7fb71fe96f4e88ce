// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_VertexMerging_h
#define medial_VertexMerging_h

#include "Axis/FacePolygon.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// What mergeVertices did.
struct MergedVertices
{
  std::vector<char> merged;    ///< for each vertex: was it merged into another one?
  std::vector<Edge> midpoints; ///< the ends of the sides in the middle of which a vertex was added;
                               ///< numbered on from the vertices given
};

/// Merges the vertices that have the same pole, or coincide, into one without a change of topology.
///
/// Merging two vertices turns each path between them into a loop. Exactly one such loop must be filled.
/// The merge itself fills some: it cuts a common face, or folds together two edges to a common
/// neighbour. Where it fills none, a new face fills the shortest loop; where it fills several, sides
/// are split until it fills one. Vertices in different pieces stay apart.
/// @param points    of the vertices, in a frame
/// @param ball      the pole that each vertex is, or None
/// @param polygons  changed in place; may have corners among the new vertices afterwards
MergedVertices mergeVertices(const std::vector<Point>& points, const std::vector<Index>& ball,
  std::vector<FacePolygon>& polygons);
/// Contracts each patch of faces to an edge, or as far as this fills just one loop at each step.
/// @param sidesOfPatches  of each patch its sides, those first that are to be contracted first
/// @param ball            the pole that each vertex is, or None: a pole stays rather than another vertex
/// @param polygons        changed in place
/// @return  for each vertex: was it merged into another one?
std::vector<char> contractToEdges(const std::vector<std::vector<Edge>>& sidesOfPatches,
  const std::vector<Index>& ball, std::vector<FacePolygon>& polygons);
}

#endif
