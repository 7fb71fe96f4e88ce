// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ClearanceFilling_h
#define medial_ClearanceFilling_h

#include "Base/BallTree.h"
#include "Base/Execution.h"
#include "Base/Triangulations.h"
#include "Base/Types.h"
#include "Crust/PowerDiagram.h"

#include <vector>

namespace medial
{
/// The tetrahedra that pruning has not touched: all their balls are left, and they were in the
/// triangulation before.
class UntouchedCells
{
public:
  /// @param before   the cells before pruning; is referred to
  /// @param ballIds  the balls of the diagram, by their numbers in `before`; is referred to
  UntouchedCells(const std::vector<Tetrahedron>& before, const std::vector<Index>& ballIds)
    : cells(before)
    , ids(ballIds)
  {
  }

  /// For each of some different cells: is it one of these? In linear time in the cells before pruning, if few
  /// are asked for.
  /// @param asked  with the numbers of the diagram
  std::vector<char> contain(const std::vector<Tetrahedron>& asked) const;

private:
  const std::vector<Tetrahedron>& cells;
  const std::vector<Index>& ids;
};

/// What filling aims at.
struct FillingGoal
{
  double clearance;  ///< from the union of the inner balls, in the diagram's frame
  int maximumRounds; ///< of insertion
  Betti topology;    ///< that the solid should have
};

/// What filling came to.
struct Filling
{
  int rounds = 0;
  Index inserted = 0; ///< balls
  Index refused = 0;  ///< balls left out in the last round: the topology would have got worse
};

/// Adds outer balls where the crust is farther from the inner balls than the clearance
/// (CrustRule::Clearance).
///
/// Each round takes every power vertex that is too far away, is no sample, and whose tetrahedron
/// pruning has touched. The ball about it that touches the union of the inner balls becomes an outer
/// ball, largest first, unless its centre is in one already taken. Then the vertices are found anew.
/// Invariant: the Betti numbers never get farther from `topology`.
/// A round with n balls and k new ones costs O(n log n) for the distances, O(k^2) for the choice, and
/// one triangulation with its Betti numbers for each attempt to insert; k is at most 5000.
/// @param now            Betti numbers of the simplices of the diagram's inner balls
/// @param innerBalls     of the diagram
/// @param triangulation  of the diagram's balls; they get the new ones both
Filling fillClearance(const FillingGoal& goal, const Betti& now, const UntouchedCells& untouched,
  const BallTree& innerBalls, RegularTriangulation& triangulation, PowerDiagram& diagram,
  const Execution& execution);
}

#endif
