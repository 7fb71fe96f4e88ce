// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Removability_h
#define medial_Removability_h

#include "Base/Types.h"
#include "Parts/LivingCells.h"
#include "Pruning/PartCollapse.h"
#include "Pruning/PruneOptions.h"
#include "Pruning/PruneRecord.h"
#include "Pruning/PruneRound.h"

#include <optional>
#include <vector>

namespace medial
{
/// Tells which parts of a round may be removed, and why others may not.
class Removability
{
public:
  /// @param livingCells, pruneRounds, pruneOptions  must outlive this
  Removability(
    const LivingCells& livingCells, PruneRounds& pruneRounds, const PruneOptions& pruneOptions);

  /// Why some parts may not be removed together; nothing if they may.
  std::optional<KeepReason> refusal(const PruneRound& round, const std::vector<Index>& parts);

  /// A branch: a part together with the smaller pieces that it alone connects with the rest.
  ///
  /// A part in the middle of a feature can't be removed alone, as the feature would fall apart. It can
  /// be removed with everything that hangs on it, if this is insignificant too.
  /// @return  empty if nothing hangs on the part, if there is no larger rest, or if the branch would be
  ///          above the threshold; refusal() still decides
  std::vector<Index> branch(const PruneRound& round, Index part, double threshold);

private:
  const LivingCells& living;
  PruneRounds& rounds;
  const PruneOptions& options;
  PartCollapse collapse;
};
}

#endif
