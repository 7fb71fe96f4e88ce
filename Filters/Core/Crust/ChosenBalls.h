// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ChosenBalls_h
#define medial_ChosenBalls_h

#include "Balls/PolarBalls.h"
#include "Base/Frame.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"
#include "Crust/CrustOptions.h"
#include "Crust/PowerDiagram.h"

#include <vector>

namespace medial
{
/// The balls that make the crust: the kept inner ones and the outer ones.
struct ChosenBalls
{
  std::vector<Index> ids; ///< the number in PolarBalls of each ball of the diagram, ascending
  PowerDiagram diagram;   ///< still without its dual and vertices
  bool all;               ///< no ball that has a power cell was left out
};

/// @param keep  one entry for each ball: is this inner ball kept; empty: all are
/// @throw InvalidInput  no inner ball is left
ChosenBalls chosenBalls(
  const PolarBalls& polarBalls, const std::vector<char>& keep, CrustRule rule, const Frame& frame);

/// The cells of `polarBalls` with the balls' numbers in the diagram, where all balls were chosen.
Tetrahedra cellsOfAll(const PolarBalls& polarBalls, const std::vector<Index>& ids);
}

#endif
