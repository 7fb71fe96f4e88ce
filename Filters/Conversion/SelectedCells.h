// SPDX-License-Identifier: BSD-3-Clause
#ifndef SelectedCells_h
#define SelectedCells_h

#include "vtkType.h"

#include <vector>

class vtkPolyData;
class vtkSelection;

namespace medial
{
/// The cells of an axis that a selection names, ascending: cells, or all cells at selected points.
/// What VTK's own extraction finds without rendering: indices, values, thresholds, ids, locations,
/// frusta. Composite indices and process ids are ignored, the axis is one piece.
///
/// @param selection  nullptr: none
/// @throw InvalidInput  a selection that can't be evaluated here, such as a query; says what to do
std::vector<vtkIdType> selectedCells(vtkSelection* selection, vtkPolyData* axis);
}

#endif
