// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PruneOptions_h
#define medial_PruneOptions_h

#include "Base/Types.h"
#include "Pruning/Schedule.h"

#include <vector>

namespace medial
{
/// Which removals are allowed.
enum class Topology
{
  Collapse = 0, ///< of parts that collapse onto their contact with the rest: exact
  None = 1,     ///< of every part of level 1

  /// The paper's test (4.3), for comparison: of parts that touch exactly one node of the topology
  /// graph of contact curves. Such a part is on no loop of the graph and connects nothing. The test is
  /// wrong where a loop lies inside one part, and where parts touch in points and in lines.
  PaperGraph = 2
};

struct PruneOptions
{
  std::vector<PruneIteration> schedule;

  /// Choose the iterations instead of taking them from `schedule`. First by triangle count <= 5, as in
  /// the paper, until an iteration removes less than a tenth of the parts. Then by relative volume,
  /// each with the threshold that the parts suggest (see Thresholds.h), until an iteration removes less
  /// than a tenth of the parts, or a tenth of the volume is gone. The history tells what was chosen.
  bool automatic = false;
  Topology topology = Topology::Collapse;
  bool removeHair = true;     ///< each pass first removes chains of dangling edges that have a free
                              ///< end and at most the threshold; an edge counts like a triangle
  bool removeBranches = true; ///< a part that alone connects a smaller rest may be removed with it,
                              ///< if they have together at most the threshold; only with
                              ///< Topology::Collapse
  double neckRatio = 0;       ///< also cut parts at necks of the input, see Necks.h; 0: don't
  bool verifyTopology = false; ///< compute the Betti numbers anew after every single removal: slow

  /// Cells of the input. After the schedule, every living part that holds one of them is removed,
  /// however significant it is (paper Figure 12), if its removal is allowed.
  std::vector<Index> cellsToRemove;

  /// Cells of the input. A part that holds one of them is never removed.
  std::vector<Index> cellsToProtect;
};
}

#endif
