// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Labels_h
#define medial_Labels_h

#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// What decides which balls are inside the solid.
struct LabelInput
{
  const std::vector<Point>& samples;
  const std::vector<std::array<Index, 2>>& ballsOfSample; ///< its two polar balls, or None
  const std::vector<Ball>& balls;
  const std::vector<char>& touchesGuard;
  const std::vector<Tetrahedron>& cells; ///< of the balls' regular triangulation
};

/// The side of each ball ([ACK01] section 4). Balls that touch a guard or
/// are centred beyond the samples' bounding box are outer; from them labels
/// spread, most certain first: to balls that intersect deeply (same side) and from one pole of a
/// sample to the other (other side). Balls in no cell are hidden.
std::vector<Side> labels(const LabelInput& input, const Execution& execution = {});
}

#endif
