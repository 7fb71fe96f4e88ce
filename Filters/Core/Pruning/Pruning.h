// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Pruning_h
#define medial_Pruning_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Base/Execution.h"
#include "Base/Types.h"
#include "Parts/LivingCells.h"
#include "Parts/Measures.h"
#include "Parts/MedialParts.h"
#include "Pruning/Schedule.h"

#include <vector>

namespace medial
{
/// Which removals are allowed.
enum class Topology
{
  Collapse = 0, ///< of a part that collapses onto its contact with the rest: exact
  None = 1,     ///< of every part of level 1

  /// The paper's (4.3), for comparison: of a part that touches one node of the topology graph of
  /// contact curves, so is on no loop of it and connects nothing. Wrong where a loop is inside a part,
  /// and where parts touch in points and lines.
  PaperGraph = 2
};

struct PruneOptions
{
  std::vector<PruneIteration> schedule;

  /// Instead of the schedule: iterations by triangle count <= 5, the paper's, until one removes less
  /// than a tenth of the parts; then by relative volume, each with the threshold that the parts suggest
  /// (see Thresholds.h), until one removes less than a tenth or a tenth of the volume is gone. What it
  /// chose is in the history.
  bool automatic = false;
  Topology topology = Topology::Collapse;
  bool removeHair = true;     ///< in each pass chains of dangling edges with a free end and at most
                              ///< the threshold (an edge counts like a triangle) go first
  bool removeBranches = true; ///< a part goes with the smaller rest that it alone connects, where
                              ///< their significance together is at most the threshold; with
                              ///< Topology::Collapse only
  double neckRatio = 0; ///< parts are cut at necks of the input too, see Necks.h; 0: they aren't
  bool verifyTopology = false; ///< compute the Betti numbers anew after every single removal: slow

  /// Cells of the input. After the schedule, every living part that holds one of them goes, however
  /// significant (paper Figure 12).
  std::vector<Index> cellsToRemove;

  /// Cells of the input. No part that holds one of them ever goes.
  std::vector<Index> cellsToProtect;
};

/// Why a part is still there.
enum class KeepReason : signed char
{
  AboveThreshold = 0, ///< together with what went from it in the last iteration
  Topology = 1,       ///< its removal would change the Betti numbers
  InnerLevel = 2,     ///< not at the border
  Isolated = 3,       ///< a whole component of the axis
  Protected = 4       ///< holds a protected cell
};

/// What became of a cell to be removed by hand.
enum class CellFate : signed char
{
  Removed,
  AlreadyGone, ///< the schedule had removed it
  Topology,    ///< kept: see KeepReason
  Isolated,
  Protected
};

/// What one iteration did. The removal by hand, if any, is the last row.
struct PruneRow
{
  bool byHand;
  Measure measure;
  double threshold;
  int passes; ///< made
  Index partsBefore, partsAfter;
  Index candidates; ///< parts of level 1 with at most the threshold
  Index removed;    ///< parts removed, those of branches and of hair included
  Index refused;    ///< candidates that were kept in the last pass, the sum of the next three
  Index refusedByTopology, refusedIsolated, refusedProtected;
  Index topologyChanges; ///< removals that changed the Betti numbers; None: not verified
  Betti betti;           ///< of the axis after it
  double volumeRemoved;  ///< relative
};

/// What went, and when.
struct PruneRecord
{
  std::vector<Index> removedInIteration; ///< for each cell of the input: row of `history`, or None
  std::vector<Index> removedPart; ///< for each cell of the input: its part when it was removed
  std::vector<PruneRow> history;
};

struct Pruned : PruneRecord
{
  MedialAxis axis;                    ///< all points of the input, the living cells
  MedialParts parts;                  ///< of the living cells
  std::vector<KeepReason> keepReason; ///< for each part
  std::vector<Index> inputCell;       ///< for each living cell: its number in the input
  std::vector<CellFate> fates;        ///< for each of PruneOptions::cellsToRemove
};

/// An axis with what pruning needs of it under any options: made once, for many thresholds.
class PrunableAxis
{
public:
  explicit PrunableAxis(MedialAxis theAxis);
  PrunableAxis(const PrunableAxis&) = delete; // its members refer to each other
  PrunableAxis& operator=(const PrunableAxis&) = delete;

  const MedialAxis axis;
  const AxisEdges edges;
  const LivingCells living; ///< all
  const PartMeasures measures;

  /// How it was pruned last: the iterations with which the next schedule begins, too, are not made again.
  PruneOptions lastOptions;
  PruneRecord lastRecord; ///< empty: not yet
};

/// Removes insignificant parts of level 1, least significant first (paper 4.2, 4.3).
///
/// With Topology::Collapse the Betti numbers never change. Unlike the paper's graph test, which is
/// wrong in both directions, a part may go if and only if it collapses, by free faces, onto its
/// contact with everything else.
///
/// @throw InvalidInput  a threshold that is not a number or negative; a cell that isn't there
/// @throw std::logic_error  verifyTopology found a change with Topology::Collapse: a bug of ours
Pruned prune(PrunableAxis& input, const PruneOptions& options, const Execution& execution = {});

/// The same, for once.
Pruned prune(const MedialAxis& axis, const PruneOptions& options, const Execution& execution = {});
}

#endif
