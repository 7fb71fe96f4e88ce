// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PruneRun_h
#define medial_PruneRun_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Parts/LivingCells.h"
#include "Parts/Measures.h"
#include "Pruning/PruneLedger.h"
#include "Pruning/PruneOptions.h"
#include "Pruning/PruneRecord.h"
#include "Pruning/PruneRound.h"
#include "Pruning/Removability.h"

#include <vector>

namespace medial
{
/// An axis while it is pruned: runs iterations on the cells that are left.
///
/// Idea: one pass walks over the candidates, least significant first, and removes each part whose
/// removal is allowed now. What is left then makes larger parts, and parts that were needed before may
/// have come free, so passes are repeated on the parts of a new round until nothing changes.
/// Invariant (Topology::Collapse): the Betti numbers of the living cells don't change.
/// Cost: O(n) for a pass over n living cells, besides the searches for branches; few passes are usual.
class PruneRun
{
public:
  /// @param living  cells to prune: those that the rows of `begun` have left
  /// @param begun   the rows that need not be made again, see firstRows()
  /// All but `begun` must outlive this.
  PruneRun(LivingCells& living, const PartMeasures& partMeasures, const PruneOptions& pruneOptions,
    const Execution& execution, PruneRecord begun);

  /// Runs one iteration and adds its row to the ledger.
  void iterate(const PruneIteration& iteration);

  /// Removes parts of a round, allowed or not, and enters that in the ledger.
  void remove(PruneRound& round, const std::vector<Index>& parts, PruneRow& row);

  const PruneOptions& options;
  PruneRounds rounds;
  Removability removability;
  PruneLedger ledger;

private:
  bool pass(PruneRound& round, const PruneIteration& iteration, int dimension, PruneRow& row);
};
}

#endif
