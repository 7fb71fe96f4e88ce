// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PieceRepair_h
#define medial_PieceRepair_h

#include "Axis/AxisComplex.h"
#include "Balls/PolarBalls.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The connected pieces of a power shape: for each ball the lowest ball of its piece, None where it is not
/// inner.
std::vector<Index> piecesOfBalls(const PolarBalls& polarBalls);

/// Puts an axis together, so that one bad place spoils only the piece of the solid that it is in: each piece
/// comes from `axis` where that has the Betti numbers of `exact` there and does not join it to another
/// piece, and from `exact` where not.
/// @param axis         whose topology may be wrong
/// @param exact        of the same balls, with the right topology
/// @param pieceOfBall  of the power shape
AxisComplex repairedPieces(
  const AxisComplex& axis, const AxisComplex& exact, const std::vector<Index>& pieceOfBall);
}

#endif
