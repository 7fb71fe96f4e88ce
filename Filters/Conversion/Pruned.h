// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Pruned_h
#define Conversion_Pruned_h

#include "Pruning/Pruning.h"

#include <vector>

class vtkPolyData;
class vtkTable;

namespace medial
{
/// The living cells, the history, and the removed cells.
/// @param topology   what the pruning was allowed to remove
/// @param cellRanks  of the cells of `axis`, see Parts/PartRanks.h
void write(const Pruned& pruned, Topology topology, const std::vector<Index>& cellRanks,
  vtkPolyData* axis, vtkPolyData* output, vtkTable* history, vtkPolyData* removed);
}

#endif
