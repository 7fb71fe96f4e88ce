// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_RemovalByHand_h
#define medial_RemovalByHand_h

#include "Base/Types.h"
#include "Pruning/PruneRecord.h"
#include "Pruning/PruneRun.h"

#include <string>
#include <vector>

namespace medial
{
/// Removes the parts that hold the cells of PruneOptions::cellsToRemove, as far as that is allowed,
/// and adds the last row to the ledger.
///
/// Parts are removed one by one. Since one removal can make another possible, this is repeated until
/// nothing changes. Parts that only may go together, as the two halves of a handle, go last.
/// @return  for each of the cells what became of it
std::vector<CellFate> removeByHand(PruneRun& run);

/// One sentence about what was to be removed by hand and was not, with the reasons, for example
/// "not removed by hand; parts 3, 7: needed for the topology". Empty if all was removed.
/// @param fates          of `cellsToRemove`, as Pruned has them
/// @param cellsToRemove  as in PruneOptions
/// @param partOfCell     for each cell of the input its part, to name parts; empty: name cells
std::string refusals(const std::vector<CellFate>& fates, const std::vector<Index>& cellsToRemove,
  const std::vector<Index>& partOfCell);
}

#endif
