// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Pruning_h
#define medial_Pruning_h

#include "Execution.h"
#include "Measures.h"
#include "MedialAxis.h"
#include "MedialParts.h"
#include "Types.h"

#include <vector>

namespace medial
{
/// Which removals are allowed.
enum class Topology
{
  Collapse = 0, ///< a part that collapses onto its contact with the rest: exact
  None = 1      ///< every part of level 1
};

/// One round of decompose - measure - prune.
///
/// Unlike the paper, passes are repeated. So that a long feature isn't eaten up from its end by small
/// pieces, a part takes over the significance of what was removed from it before: what goes at one
/// place in one iteration has at most the threshold in sum, where the measure adds up. With one pass,
/// or without topology, each part counts alone, as in the paper.
struct PruneIteration
{
  Measure measure = Measure::TriangleCount;
  double threshold = 5; ///< parts with at most this significance go
  int passes = 0;       ///< how often to repeat; 0: until nothing changes (the paper: 1)
};

struct PruneOptions
{
  std::vector<PruneIteration> schedule;
  Topology topology = Topology::Collapse;
  bool removeHair = true;     ///< in each pass chains of dangling edges with a free end and at most
                              ///< the threshold (an edge counts like a triangle) go first
  bool removeBranches = true; ///< a part goes with the smaller rest that it alone connects, where
                              ///< their significance together is at most the threshold

  /// Cells of the input. After the schedule, every living part that holds one of them goes, however
  /// significant (paper Figure 12).
  std::vector<Index> cellsToRemove;
};

/// Why a part is still there.
enum class KeepReason : signed char
{
  AboveThreshold = 0, ///< together with what went from it in the last iteration
  Topology = 1,       ///< its removal would change the Betti numbers
  InnerLevel = 2,     ///< not at the border
  Isolated = 3        ///< a whole component of the axis
};

/// What one iteration did. The removal by hand, if any, is the last row.
struct PruneRow
{
  bool byHand;
  Measure measure;
  double threshold;
  int passes; ///< made
  Index partsBefore, partsAfter;
  Index candidates;     ///< parts of level 1 with at most the threshold
  Index removed;        ///< parts removed, those of branches and of hair included
  Index refused;        ///< candidates that topology kept
  Betti betti;          ///< of the axis after it
  double volumeRemoved; ///< relative
};

struct Pruned
{
  MedialAxis axis;                       ///< all points of the input, the living cells
  MedialParts parts;                     ///< of the living cells
  std::vector<KeepReason> keepReason;    ///< for each part
  std::vector<Index> inputCell;          ///< for each living cell: its number in the input
  std::vector<Index> removedInIteration; ///< for each cell of the input: row of `history`, or None
  std::vector<Index> removedPart; ///< for each cell of the input: its part when it was removed
  std::vector<PruneRow> history;
};

/// Removes insignificant parts of level 1, least significant first (paper 4.2, 4.3).
///
/// With Topology::Collapse the Betti numbers never change. Unlike the paper's graph test, which is
/// wrong in both directions, a part may go if and only if it collapses, by free faces, onto its
/// contact with everything else.
///
/// @throw InvalidInput  a threshold that is not a number or negative; a cell that isn't there
Pruned prune(const MedialAxis& axis, const PruneOptions& options, const Execution& execution = {});
}

#endif
