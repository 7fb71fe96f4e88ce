// SPDX-License-Identifier: BSD-3-Clause
#ifndef CollectParts_h
#define CollectParts_h

#include "vtkType.h"

#include <vector>

class vtkCompositeDataSet;
class vtkMultiProcessController;
class vtkTable;

/// The tables of parts of a collection, a block for each object. Every rank must call these functions;
/// `ranks` is nullptr where there is only one.
namespace medial
{
/// For each block the number of its first part: 0, or where `unique` the rows of all blocks before.
/// @throw InvalidInput  a block isn't a table of parts, on every rank
std::vector<vtkIdType> firstParts(
  vtkCompositeDataSet* tables, bool unique, vtkMultiProcessController* ranks);

/// All rows, in the order of the blocks, with the block as ObjectId; for rank 0 alone.
/// @throw InvalidInput  the tables have different columns
void collectTables(vtkCompositeDataSet* tables, const std::vector<vtkIdType>& firstParts,
  vtkMultiProcessController* ranks, vtkTable* output);

/// Copies `parts`, which may be nullptr, with firstParts[block] added to PartId.
/// @throw InvalidInput  it has more blocks, or PartId isn't whole
void renumberParts(vtkCompositeDataSet* parts, const std::vector<vtkIdType>& firstParts,
  vtkCompositeDataSet* output);
}

#endif
