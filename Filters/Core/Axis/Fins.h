// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Fins_h
#define medial_Fins_h

#include "Axis/ShapeComplex.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The collapse of a triangle through one of its edges.
struct TriangleCollapse
{
  Index triangle, edge;
};

/// How to remove a fin that stands on an edge: the collapses, in order, that lead from its border to the
/// edge. A fin has at most two triangles from there to the border; anything larger may be a sheet of the
/// axis, and stays. No point is lost.
/// @param triangle  the fin's triangle at the edge
/// @param centers   of the shape's points; of two borders the longer edge goes
/// @return  empty: it is no fin
std::vector<TriangleCollapse> finCollapses(
  const ShapeComplex& shape, const std::vector<Point>& centers, Index triangle, Index edge);
}

#endif
