// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PruneLedger_h
#define medial_PruneLedger_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Parts/LivingCells.h"
#include "Parts/Measures.h"
#include "Parts/Partition.h"
#include "Pruning/PruneOptions.h"
#include "Pruning/PruneRecord.h"
#include "Pruning/PruneRound.h"

#include <utility>
#include <vector>

namespace medial
{
/// Length of the common prefix of two schedules: how many iterations of the second need not be made
/// again after the first. The last of the second is always made: what parts take over in it tells why
/// they are kept, and a record doesn't hold that. 0 where an option differs that bears on them, or where
/// iterations aren't taken from the schedule or are to be verified.
Index sharedIterations(const PruneOptions& earlier, const PruneOptions& options);

/// The record as it was after its first rows.
/// @param rows       0 ... number of rows of the earlier record
/// @param cellCount  of the input
PruneRecord firstRows(const PruneRecord& earlier, Index rows, Index cellCount);

/// The cells that were removed, and those that were not, ascending.
std::vector<Index> removedCells(const PruneRecord& record);
std::vector<Index> livingCells(const PruneRecord& record);

/// Counts a part that was not removed in the row of its iteration.
void countRefusal(KeepReason reason, PruneRow& row);

/// Sets the counts of refusals to 0, for the next pass.
void clearRefusals(PruneRow& row);

/// Keeps the record while an axis is pruned: what goes in which iteration, and with each iteration the
/// Betti numbers and the volume that is left.
class PruneLedger
{
public:
  /// @param livingCells, partMeasures, pruneOptions, ledgerExecution  must outlive this
  /// @param begun  what was done before, after which these cells live
  PruneLedger(const LivingCells& livingCells, const PartMeasures& partMeasures,
    const PruneOptions& pruneOptions, const Execution& ledgerExecution, PruneRecord begun);

  /// A row for an iteration that begins with this round.
  PruneRow newRow(const PruneRound& round) const;

  /// Enters the removal of some cells, all from one unit of parts, and verifies the topology if this is
  /// an option. Call it after the cells have died.
  /// @throw std::logic_error  Topology::Collapse and the Betti numbers have changed
  void enter(const std::vector<Index>& cells, const PruneRound& round, PruneRow& row);

  /// Adds the row of an iteration, after which the parts are those of this round.
  void close(PruneRow row, const PruneRound& round);

  const PruneRecord& record() const { return this->entries; }
  PruneRecord takeRecord() { return std::move(this->entries); }

private:
  void verify(PruneRow& row);
  double livingVolume() const;

  const LivingCells& living;
  const PartMeasures& measures;
  const PruneOptions& options;
  const Execution& execution;
  PruneRecord entries;
  double volume;    ///< of the living cells, relative to the solid
  Betti verified{}; ///< after the last removal, if every removal is verified
};
}

#endif
