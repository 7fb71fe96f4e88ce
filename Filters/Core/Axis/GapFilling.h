// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_GapFilling_h
#define medial_GapFilling_h

#include "Axis/Carving.h"
#include "Axis/SiteTriangulation.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// What fillGaps() did.
struct FilledGaps
{
  Betti betti{};    ///< of the set afterwards
  Index places = 0; ///< cells that changed the topology: each joins pieces, fills a tunnel, ...
};

/// Adds cells to an open set, the deepest first, until its Betti numbers are those of `target`: cells that
/// keep the topology, and cells that bring each number nearer to its target or keep it. Cells that were not
/// needed can be carved away again.
///
/// Where it ends without success there is no such cell left. No tunnel is made: a set with too few is wrong in
/// more than gaps.
/// @param pieceOfBall  of the power shape, see piecesOfBalls(): what lies in different ones isn't joined
FilledGaps fillGaps(const SiteTriangulation& sites, const std::vector<Index>& pieceOfBall,
  const Betti& target, OpenSet& set, const Execution& execution = {});
}

#endif
