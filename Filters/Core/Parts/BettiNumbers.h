// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_BettiNumbers_h
#define medial_BettiNumbers_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Parts/LivingCells.h"
#include "Parts/Partition.h"

namespace medial
{
/// Betti numbers of the living cells and their faces. Exact, over Z/2.
///
/// Takes less time than those of the cells alone (Axis/AxisBetti.h), because pruning keeps the
/// partition and the Euler characteristic up to date anyway.
/// @param partition  of these cells, to level 1 or more
Betti bettiNumbers(
  const LivingCells& living, const Partition& partition, const Execution& execution = {});
}

#endif
