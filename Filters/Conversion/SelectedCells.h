// SPDX-License-Identifier: BSD-3-Clause
#ifndef SelectedCells_h
#define SelectedCells_h

#include "vtkType.h"

#include <vector>

class vtkCompositeDataSet;
class vtkPolyData;
class vtkSelection;

namespace medial
{
constexpr vtkIdType Alone = -1;

/// The cells of an axis that a selection names, ascending: cells, or all cells at selected points.
/// What VTK's own extraction finds without rendering: indices, values, thresholds, ids, locations,
/// frusta. Process ids are ignored, the axis is one piece.
///
/// @param selection  nullptr: none
/// @param block  the axis' flat index in its collection: what is selected in another block isn't here.
///               Alone: it is in no collection, and composite indices are ignored
/// @throw InvalidInput  a selection that can't be evaluated here, such as a query; says what to do
std::vector<vtkIdType> selectedCells(
  vtkSelection* selection, vtkPolyData* axis, vtkIdType block = Alone);

/// The flat index of an axis in a collection; Alone: it is not in it, or there is none.
vtkIdType blockOf(vtkPolyData* axis, vtkCompositeDataSet* collection);
}

#endif
