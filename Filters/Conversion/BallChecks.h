// SPDX-License-Identifier: BSD-3-Clause
#ifndef BallChecks_h
#define BallChecks_h

#include "Balls/PolarBalls.h"
#include "Conversion/TetrahedraChecks.h"

namespace medial
{
/// Checks what the stages after vtkPolarBalls rely on, beside lengths and ranges of arrays: the list is in
/// README.md. Finds the neighbours of the tetrahedra, which no array holds, on request. Takes time linear in the number of
/// balls, samples and tetrahedra.
/// @throw InvalidInput  it isn't so; the message names array, element and remedy
void checkBalls(PolarBalls& balls, CellNeighbors neighbors);
}

#endif
