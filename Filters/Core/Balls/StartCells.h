// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_StartCells_h
#define medial_StartCells_h

#include "Base/Lists.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Cells of the balls' regular triangulation in which walks begin.
///
/// The cells of a ball lie around its centre. Most balls have about 20, and any of them is near to the end of a walk. A ball on the
/// axis of a rod with n samples has about sqrt(n) cells in a ring: a walk along the ring would visit a quarter of them.
/// So a ball with many cells has several that are spread evenly, and a walk begins in the one whose direction is
/// nearest to that of its end.
class StartCells
{
public:
  /// @param mesh   of the balls; is referred to
  /// @param balls  are referred to
  StartCells(const Tetrahedra& mesh, const std::vector<Ball>& balls);

  /// A cell of a ball that isn't hidden, in the direction of a point.
  Index towards(const Point& p, Index ball) const;

  /// Number of cells with a ball.
  Index cellCount(Index ball) const { return this->cellCounts[ball]; }

private:
  const Tetrahedra& mesh;
  const std::vector<Ball>& balls;
  std::vector<Index> cellCounts;
  IndexLists cellsAt; ///< of each ball: one, or several if it has many
};
}

#endif
