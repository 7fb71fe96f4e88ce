// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_AxisEdges_h
#define medial_AxisEdges_h

#include "Axis/AxisCells.h"
#include "Base/Lists.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// All edges of an axis, those of its triangles and the dangling ones, each once.
struct AxisEdges
{
  std::vector<Edge> points;         ///< ascending corners
  IndexLists triangles;             ///< for each edge the triangles at it, ascending
  std::vector<Triangle> ofTriangle; ///< the edges (0,1), (1,2), (2,0) of each triangle
  std::vector<Index> ofDangling;    ///< the edge that each of AxisCells::edges is
};

/// Takes linear time but for sorting the few edges at each point.
AxisEdges axisEdges(const AxisCells& cells);
}

#endif
