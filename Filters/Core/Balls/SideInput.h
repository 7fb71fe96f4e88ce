// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SideInput_h
#define medial_SideInput_h

#include "Base/Types.h"

#include <array>
#include <vector>

namespace medial
{
/// What decides which balls are inside the solid. All lengths are in one frame.
struct SideInput
{
  const std::vector<Point>& samples;
  const std::vector<std::array<Index, 2>>& ballsOfSample; ///< its two polar balls, or None
  const std::vector<Ball>& balls;
  const std::vector<char>& touchesGuard; ///< for each ball
  const std::vector<Edge>& edges;        ///< of the balls' regular triangulation
};
}

#endif
