// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PruneRound_h
#define medial_PruneRound_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Parts/ContactCurves.h"
#include "Parts/LivingCells.h"
#include "Parts/Measures.h"
#include "Parts/Partition.h"
#include "Pruning/PruneOptions.h"

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace medial
{
/// The parts as one pass finds them, and what decides about them.
///
/// A pass removes parts one by one, but it doesn't decompose the axis again after each: it marks the
/// removed parts as gone. The parts that are left keep their numbers until the next round.
struct PruneRound
{
  std::shared_ptr<const Partition> partition;
  Measure measure;
  std::vector<double> significance; ///< of each part, with what it took over from removed parts
  std::vector<char> gone;           ///< for each part: was it removed since the round began?
  std::vector<char> isProtected;    ///< for each part: does it hold a protected cell?
  std::vector<ContactCurve>
    contacts; ///< only for Topology::PaperGraph, and only curves: the paper's
              ///< graph knows no contact points

  /// For each part, once asked for: the parts that share a point with it and were not gone then,
  /// ascending. Read it by PruneRounds::neighbors.
  mutable std::vector<std::optional<std::vector<Index>>> knownNeighbors;
};

/// Parts of level 1 with at most the threshold and at most this dimension, least significant first.
/// Parts of equal significance stay in the order of their numbers.
std::vector<Index> candidates(const PruneRound& round, double threshold, int dimension);

/// The cells of some parts, part by part.
std::vector<Index> cellsOf(const PruneRound& round, const std::vector<Index>& parts);

/// Makes one round after the other from the living cells of an axis.
///
/// A round costs O(n) for n living cells. The costly steps are skipped where nothing has changed since
/// the last round: the partition is made again only after a removal, and the parts are measured again
/// only after a removal or for another measure.
class PruneRounds
{
public:
  /// @param livingCells, partMeasures, pruneOptions, roundExecution  must outlive this
  PruneRounds(LivingCells& livingCells, const PartMeasures& partMeasures,
    const PruneOptions& pruneOptions, const Execution& roundExecution);

  /// The parts of the cells that live now.
  PruneRound next(Measure measure);

  /// Removes parts: their cells die, and the round marks them as gone.
  /// @param cells  of these parts, as cellsOf() gives them
  void remove(PruneRound& round, const std::vector<Index>& parts, const std::vector<Index>& cells);

  /// Passes the significance of parts that were just removed together to their most significant
  /// neighbor, in this round and those after it. A measure that doesn't add up passes its largest
  /// value, which decides nothing: removed parts have at most the threshold anyway.
  void inherit(PruneRound& round, const std::vector<Index>& removed);

  /// What the part of a cell took over from removed ones in this iteration.
  using Inheritance = std::map<Index, double>;

  /// A new iteration begins. @return  what is forgotten
  Inheritance forgetInheritance() { return std::exchange(this->inherited, {}); }

  /// It doesn't begin after all.
  void remember(Inheritance forgotten) { this->inherited = std::move(forgotten); }

  /// The parts that share a point with this one, ascending. Some of them may be gone by now.
  const std::vector<Index>& neighbors(const PruneRound& round, Index part);

  /// Completes the levels in the partition of the last round, which has level 1 alone.
  void findAllLevels();

private:
  void addInheritance(PruneRound& round) const;

  LivingCells& living;
  const PartMeasures& measures;
  const PruneOptions& options;
  const Execution& execution;
  std::shared_ptr<Partition> current; ///< of the living cells; none after a removal
  std::optional<Measure> measured;    ///< the measure that `significance` is in
  std::vector<double> significance;   ///< of the current parts, without what they took over
  Inheritance inherited;

  // Marks for neighbors(): a number per walk saves clearing them.
  std::vector<Index> visitedIn; ///< for each point the last walk that came there
  std::vector<Index> metIn;     ///< for each part the last walk that met it
  Index walks = 0;
};
}

#endif
