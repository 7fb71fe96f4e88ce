// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_Parts_h
#define Conversion_Parts_h

#include "Parts/MedialParts.h"
#include "Parts/TopologyGraph.h"

#include "vtkType.h"

#include <vector>

class vtkCellData;
class vtkFieldData;
class vtkPolyData;
class vtkTable;

namespace medial
{
/// The axis with its parts, the table of parts, and the contact curves. Parts take over the ranks that the
/// axis has, see Parts/PartRanks.h.
void write(const MedialParts& parts, vtkPolyData* axis, vtkPolyData* output, vtkTable* table,
  vtkPolyData* contacts);

/// The topology graph of these parts as points and lines.
void write(const TopologyGraph& graph, const MedialParts& parts, vtkPolyData* output);

/// Adds what each cell tells of its part, and the field data about all parts.
/// @param ranks  of the parts
void addParts(vtkCellData* cells, vtkFieldData* field, const MedialParts& parts,
  const std::vector<Index>& ranks);

/// The part of each cell of an axis; no entries where it has no array of parts.
std::vector<Index> readParts(vtkPolyData* axis);

/// The rank of each cell of an axis; no entries where it has no array of ranks.
std::vector<Index> readRanks(vtkPolyData* axis);

/// The cells of an axis in one of `parts`, and `cells`, checked.
/// @param done  what is to be done with them, for messages: "removed", "protected"
/// @throw InvalidInput  the axis has no parts, or a part or cell isn't there
std::vector<Index> readCells(vtkPolyData* axis, const std::vector<vtkIdType>& parts,
  const std::vector<vtkIdType>& cells, const char* done);
}

#endif
