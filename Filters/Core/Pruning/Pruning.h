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
#include "Pruning/PruneOptions.h"
#include "Pruning/PruneRecord.h"
#include "Pruning/Schedule.h"

#include <vector>

namespace medial
{
struct Pruned : PruneRecord
{
  MedialAxis axis;                    ///< all points of the input, the living cells
  MedialParts parts;                  ///< of the living cells
  std::vector<KeepReason> keepReason; ///< for each part
  std::vector<Index> inputCell;       ///< for each living cell: its number in the input
  std::vector<CellFate> fates;        ///< for each of PruneOptions::cellsToRemove
};

/// An axis with everything that pruning derives from it whatever the options are. Make it once, then
/// prune it with many thresholds.
class PrunableAxis
{
public:
  explicit PrunableAxis(MedialAxis medialAxis);
  PrunableAxis(const PrunableAxis&) = delete; // its members refer to each other
  PrunableAxis& operator=(const PrunableAxis&) = delete;

  const MedialAxis axis;
  const AxisEdges edges;
  const LivingCells living; ///< all
  const PartMeasures measures;

  /// How it was pruned last. If the next schedule begins with the same iterations, prune() takes their
  /// outcome from here instead of making them again.
  PruneOptions lastOptions;
  PruneRecord lastRecord; ///< empty: not yet
};

/// Removes insignificant parts of level 1, least significant first (paper 4.2, 4.3).
///
/// With Topology::Collapse the Betti numbers never change. A part may be removed if and only if it
/// collapses, by free faces, onto its contact with everything else. This is unlike the paper's test by
/// a graph, which allows some removals that change the topology and forbids others that don't.
///
/// @throw InvalidInput  a threshold is negative or not a number; a cell doesn't exist
/// @throw std::logic_error  verifyTopology found a change with Topology::Collapse: a bug of ours
Pruned prune(PrunableAxis& input, const PruneOptions& options, const Execution& execution = {});

/// The same for an axis that is pruned only once.
Pruned prune(const MedialAxis& axis, const PruneOptions& options, const Execution& execution = {});
}

#endif
