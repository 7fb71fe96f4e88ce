// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_BallShares_h
#define medial_BallShares_h

#include "Axis/MedialAxis.h"
#include "Base/Lists.h"
#include "Base/Types.h"
#include "Parts/LivingCells.h"

#include <vector>

/// Which part holds which polar ball. An inner ball that is not on the axis follows its owner there.
namespace medial
{
/// What share of a polar ball's volume counts for a part.
struct BallShare
{
  Index part;
  double share; ///< 0 ... 1
};

/// For each polar ball on the axis the shares of the parts at its medial points, by part; they sum to 1.
/// Empty for the other balls. The shares are in proportion to the sizes of the parts: if a spike on a
/// large sheet goes, the sheet keeps the balls at its root. No share jumps where parts of one size meet.
/// @param partOfCell    for each cell of the axis, or None
/// @param sizeOfPart    for each part, not negative; where all at a ball are 0 they have equal shares
/// @param cellsOfPoint  of the axis
Lists<BallShare> ballShares(const MedialAxis& axis, const std::vector<Index>& partOfCell,
  const std::vector<double>& sizeOfPart, const IndexLists& cellsOfPoint);

/// The one part that each polar ball is shown with: of the parts at its medial point the one with most
/// cells there, the first of several. A ball off the axis goes with the part of its owner. None where the
/// owner is no longer on the axis.
/// @param partOfCell  for each cell of the axis, or None
std::vector<Index> partOfBall(const MedialAxis& axis, const std::vector<Index>& partOfCell);

/// For each polar ball: does it, or its owner, lie on a point that a cell of the axis uses? After
/// pruning these are the balls that make the surface (paper 5).
std::vector<char> keptBalls(const MedialAxis& axis);

/// The same where only the living cells of the axis count.
std::vector<char> keptBalls(const MedialAxis& axis, const LivingCells& living);
}

#endif
