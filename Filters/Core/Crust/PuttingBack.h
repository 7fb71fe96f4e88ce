// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PuttingBack_h
#define medial_PuttingBack_h

#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/Frame.h"
#include "Base/Triangulations.h"
#include "Base/Types.h"
#include "Crust/ChosenBalls.h"

#include <optional>

namespace medial
{
/// What putting balls back came to.
struct PuttingBack
{
  Index balls = 0;
  Betti betti{};              ///< of the chosen inner balls' simplices then
  std::optional<Point> place; ///< where a contradiction is left, in the samples' unit
};

/// Puts removed inner balls back where leaving them out has changed the topology.
///
/// The place of removed balls goes to whatever balls are around it, inner or outer: the power shape of
/// the balls that are left need not have the topology of the axis that they are on. Where samples are
/// noisy or too few, outer balls may pierce a thin wall there, or leave a gap to a neighbour. With all
/// balls put back the crust is the unpruned one; so if pruning has kept the topology, some suffice.
/// Looks only at regions where the topology changes, and there for few balls. Nothing is put back
/// unless the Betti numbers come nearer to `topology`.
/// Costs about as much as the triangulation of the balls in these regions, and one triangulation with
/// its Betti numbers for each attempt.
/// @param topology       Betti numbers wanted
/// @param now            those of the chosen inner balls' simplices, others than wanted
/// @param triangulation  of the chosen balls; gets those put back, as `chosen` does
PuttingBack putBack(const Betti& topology, const Betti& now, const PolarBalls& polarBalls,
  const Frame& frame, ChosenBalls& chosen, RegularTriangulation& triangulation,
  const Execution& execution);
}

#endif
