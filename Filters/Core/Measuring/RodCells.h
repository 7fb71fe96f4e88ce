// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_RodCells_h
#define medial_RodCells_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Measuring/PlatePieces.h"

#include <vector>

namespace medial
{
/// What of an axis is no plate, and where it touches plates.
struct RodCells
{
  std::vector<char> triangles; ///< for each triangle: is it of a rod?
  std::vector<char> edges;     ///< for each edge: is it one of a cell of a rod?
  std::vector<char> points;    ///< for each point: is it one of a cell of a rod?
  std::vector<Index> plateAt;  ///< for each point the lowest plate at it, or None

  /// For each point: does a rod hang on a plate there? Of points that hang together in which rods touch plates
  /// it is the one that burns last.
  std::vector<char> anchor;
};

/// Takes linear time, but for finding what hangs together.
RodCells rodCells(const MedialAxis& axis, const AxisEdges& edges, const PlatePieces& plates);
}

#endif
