// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_AxisBetti_h
#define medial_AxisBetti_h

#include "Axis/AxisCells.h"
#include "Base/Types.h"

namespace medial
{
/// Betti numbers of the complex of `cells` and their faces. Exact, over Z/2.
Betti bettiNumbers(const AxisCells& cells);
}

#endif
