// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_RimTips_h
#define medial_RimTips_h

#include "Axis/AxisComplex.h"
#include "Base/DisjointSets.h"

#include <vector>

namespace medial
{
/// The free ends of lines that are trimmed. Fire runs straight from the tip where it began: lines that are left of
/// sheets are crooked.
class RimTips
{
public:
  /// @param axis  before anything is trimmed; outlives this
  explicit RimTips(const AxisComplex& axis);

  /// When the fire of a free end arrives at the other end of its line, less the radius there.
  double thickness(Index end, Index to) const;

  /// May a line go with its free end?
  /// @param most  erosion thickness
  bool mayGo(Index end, Index to, double most) const;

  /// The same while the sheet that a line is left of is still being trimmed at its other end: twice as much, since the
  /// line is crooked, or half the radius there, since the tip's ball adds little to that one.
  bool mayGoFromSheet(Index end, Index to, double most) const;

  /// A line goes with its free end.
  void go(Index end, Index to);

private:
  /// Without one, a piece would have no part in the solid.
  bool isLastBall(Index point) const;

  const AxisComplex& axis;
  std::vector<Index> begins; ///< for each point where its fire began
  mutable DisjointSets pieces;
  std::vector<Index> ballsLeft; ///< for each piece
};
}

#endif
