// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Trimming_h
#define medial_Trimming_h

#include "Axis/VertexMerging.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The vertices and faces of an axis before it is triangulated, and what they are equally far from.
struct SheetComplex
{
  std::vector<Point> points;   ///< of the vertices, in a frame
  std::vector<Index> ball;     ///< the pole that each vertex is, or None
  std::vector<Point> sites;    ///< in the frame
  std::vector<Edge> siteEdges; ///< by Polygon::siteEdge: the two sites of a face
};

/// Keeps sheets apart that meet at a seam, and leaves out pieces without a pole of their own, by
/// collapses of faces with a free side: the topology stays.
///
/// Where three sheets meet and one of them ends a little earlier, as at a sharp corner of the solid, the
/// other two would be one sheet around its end. They are cut apart from there to the border, where this
/// is within the maximal ball. Three faces are sheets of a seam if from each to each other a site jumps
/// farther than its distance. A piece all of whose poles are on other pieces, too, adds nothing to the
/// union of balls.
/// @return  for each vertex: is it no longer there?
std::vector<char> trimSheets(const SheetComplex& complex, std::vector<Polygon>& polygons);
}

#endif
