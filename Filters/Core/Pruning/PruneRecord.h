// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PruneRecord_h
#define medial_PruneRecord_h

#include "Base/Types.h"
#include "Parts/Measures.h"

#include <vector>

namespace medial
{
/// Why a part is still there.
enum class KeepReason : signed char
{
  AboveThreshold = 0, ///< with the significance it took over in the last iteration
  Topology = 1,       ///< its removal would change the Betti numbers
  InnerLevel = 2,     ///< it is not at the border
  Isolated = 3,       ///< it is a whole component of the axis
  Protected = 4       ///< it holds a protected cell
};

/// What became of a cell that was to be removed by hand.
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
  Betti betti;           ///< of the axis after the iteration
  double volumeRemoved;  ///< relative to the solid
};

/// Which cells were removed, and when.
struct PruneRecord
{
  std::vector<Index> removedInIteration; ///< for each cell of the input: row of `history`, or None
  std::vector<Index> removedPart; ///< for each cell of the input: its part when it was removed
  std::vector<PruneRow> history;
};
}

#endif
