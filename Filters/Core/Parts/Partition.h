// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Partition_h
#define medial_Partition_h

#include "Axis/AxisCells.h"
#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/Types.h"
#include "Parts/LivingCells.h"

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

/// @param maximumLevel  parts above it get level 0; 0 or less: no limit
Partition partition(LivingCells& living, int maximumLevel = 0, const Execution& execution = {});

/// The same where all cells live.
Partition partition(const AxisCells& cells, const AxisEdges& edges, int maximumLevel = 0);

/// Gives a partition of the living cells the levels that it does not have yet.
void findAllLevels(const LivingCells& living, Partition& partition);

/// Calls body(part, part) so often that parts which share a point are linked by these pairs.
template <typename Body>
void forTouchingParts(const LivingCells& living, const Partition& partition, const Body& body)
{
  for (Index p = 0; p < living.cellsOfPoint().size(); ++p)
  {
    if (living.cellsAtPoint(p) < 2)
    {
      continue;
    }
    Index last = None;
    for (const Index cell : living.cellsOfPoint()[p])
    {
      const Index part = partition.partOfCell[cell];
      if (part != None && last != None && part != last)
      {
        body(last, part);
      }
      last = part == None ? last : part;
    }
  }
}

/// The parts of some cells, ascending, each once; cells without a part are left out.
void distinctPartsOf(
  IndexLists::View cells, const std::vector<Index>& partOfCell, std::vector<Index>& parts);

/// The same with repeats.
void partsOf(
  IndexLists::View cells, const std::vector<Index>& partOfCell, std::vector<Index>& parts);
}

#endif
