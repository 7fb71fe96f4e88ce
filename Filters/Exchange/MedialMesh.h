// SPDX-License-Identifier: BSD-3-Clause
#ifndef MedialMesh_h
#define MedialMesh_h

#include "Axis/AxisCells.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// A medial mesh, as programs that make medial axes exchange it in .ma files.
struct MedialMesh
{
  std::vector<Point> points;
  std::vector<double> radii; ///< one for each point

  /// Vertices are the points in no other cell. An edge is no side of a triangle, unless it has a type
  /// other than 0.
  AxisCells cells;

  std::vector<Index> pointTypes; ///< one for each point; empty: they have none
  std::vector<Index> edgeTypes;  ///< one for each edge; empty: they have none
};
}

#endif
