// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Pruned_h
#define Conversion_Pruned_h

#include "Pruning/Pruning.h"

#include <string>
#include <vector>

class vtkPolyData;
class vtkTable;

namespace medial
{
/// The living cells, the history, and the removed cells.
void write(const Pruned& pruned, vtkPolyData* axis, vtkPolyData* output, vtkTable* history,
  vtkPolyData* removed);

/// One sentence about what was to be removed by hand and was not, by part of the input where it has
/// parts, else by cell, with the reason; empty where all went.
std::string refusals(
  const Pruned& pruned, const std::vector<Index>& cellsToRemove, vtkPolyData* axis);
}

#endif
