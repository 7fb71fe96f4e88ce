// SPDX-License-Identifier: BSD-3-Clause
#ifndef Conversion_h
#define Conversion_h

#include "MedialAxis.h"
#include "MedialParts.h"
#include "PolarBalls.h"
#include "PowerCrust.h"
#include "Pruning.h"
#include "TopologyGraph.h"

#include "vtkIndent.h"
#include "vtkType.h"

#include <iosfwd>
#include <string>
#include <vector>

class vtkPointSet;
class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

/// VTK data from and to the core's values. Nothing is computed here but what checking needs.
///
/// Reading trusts nothing: each `read` throws InvalidInput, which tells array, cause and remedy,
/// unless the result has the sizes and ranges that the core's headers promise. `write` fills an
/// empty output. What it writes, the matching `read` gives back to the last bit, also after a trip
/// through a file.
namespace medial
{
/// The points of a data set, in their order.
std::vector<Point> readSamples(vtkPointSet* input);

/// @param powerShape  Betti numbers of the power shape of `balls`
void write(const PolarBalls& balls, const Betti& powerShape, vtkPointSet* input,
  vtkUnstructuredGrid* output);
PolarBalls readPolarBalls(vtkUnstructuredGrid* input);

/// @param balls  what the axis is made from; its field data is passed on
void write(const MedialAxis& axis, vtkUnstructuredGrid* balls, vtkPolyData* output);
MedialAxis readMedialAxis(vtkPolyData* input);

/// The axis with its parts, the table of parts, and the contact curves.
void write(const MedialParts& parts, vtkPolyData* axis, vtkPolyData* output, vtkTable* table,
  vtkPolyData* contacts);

/// The topology graph of these parts as points and lines.
void write(const TopologyGraph& graph, const MedialParts& parts, vtkPolyData* output);

/// The part of each cell of an axis; no entries where it has no array of parts.
std::vector<Index> readParts(vtkPolyData* axis);

/// The cells of an axis in one of `parts`, and `cells`, checked.
/// @param done  what is to be done with them, for messages: "removed", "protected"
/// @throw InvalidInput  the axis has no parts, or a part or cell isn't there
std::vector<Index> readCells(vtkPolyData* axis, const std::vector<vtkIdType>& parts,
  const std::vector<vtkIdType>& cells, const char* done);

/// One sentence about what was to be removed by hand and was not, by part of the input where it has
/// parts, else by cell, with the reason; empty where all went.
std::string refusals(
  const Pruned& pruned, const std::vector<Index>& cellsToRemove, vtkPolyData* axis);

/// The living cells, the history, and the removed cells.
void write(const Pruned& pruned, vtkPolyData* axis, vtkPolyData* output, vtkTable* history,
  vtkPolyData* removed);

/// @throw InvalidInput  `axis` was made from other balls
void checkSameBalls(const MedialAxis& axis, const PolarBalls& balls);

/// @param partOfBall  empty: no ball has a part
/// @param balls       what the crust is made from; its field data is passed on
void write(const Crust& crust, const std::vector<Index>& partOfBall, vtkUnstructuredGrid* balls,
  vtkPolyData* output);

/// The schedule for people, one line for each iteration.
void print(std::ostream& stream, vtkIndent indent, const std::vector<PruneIteration>& schedule);
}

#endif
