// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Partition_h
#define medial_Partition_h

#include "AxisEdges.h"
#include "MedialAxis.h"
#include "Types.h"

#include <vector>

namespace medial
{
/// The parts of the living cells of an axis (paper 4.1): which cell is in which, and their levels.
struct Partition
{
  std::vector<Index> partOfCell; ///< None where the cell does not live
  IndexLists cells;           ///< of each part, ascending; parts of triangles, then of edges, then
                              ///< of vertices, each kind by lowest cell
  std::vector<int> dimension; ///< of each part: 2, 1, 0
  std::vector<int> level;     ///< of each part; 0: not reached
};

/// @param living        for each cell; empty: all live
/// @param maximumLevel  parts above it keep level 0; 0 or less: no limit
Partition partition(const AxisCells& cells, const AxisEdges& edges,
  const std::vector<char>& living = {}, int maximumLevel = 0);

/// For each point the parts of the living cells there, ascending, once for each cell.
IndexLists partsAtPoints(
  const AxisCells& cells, const std::vector<Index>& partOfCell, Index pointCount);
}

#endif
