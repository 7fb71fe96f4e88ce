// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CellFaces_h
#define medial_CellFaces_h

#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/Types.h"
#include "Crust/PowerDiagram.h"

#include <vector>

namespace medial
{
/// The faces between inner and outer power cells. A power vertex is named by its tetrahedron of the
/// dual, so a face is the cycle of tetrahedra around its dual edge.
struct CellFaces
{
  Lists<Index> cycles;     ///< counter-clockwise seen from outside
  std::vector<Edge> balls; ///< inner, outer
};

/// One face for each edge of the diagram's dual between an inner and an outer ball, in the order in which its
/// tetrahedra have them; none for edges on the convex hull. Takes linear time.
CellFaces cellFaces(const PowerDiagram& diagram, const Execution& execution = {});
}

#endif
