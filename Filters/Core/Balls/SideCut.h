// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SideCut_h
#define medial_SideCut_h

#include "Balls/SideLinks.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Puts balls on the other side where all links together say so: the sides that contradict links of the least
/// total strength, by minimum cuts. Links that join the poles of samples count by the squares of their strengths,
/// and are weighed once less and once more than the others; a ball changes its side only if both cuts agree.
///
/// @param links  between balls
/// @param known  for each ball: is its side known? Then it stays
/// @param sides  of the balls, outer or inner
/// @throw Aborted
void cutSides(const std::vector<SideLink>& links, const std::vector<char>& known,
  std::vector<Side>& sides, const Execution& execution = {});
}

#endif
