// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SideLinks_h
#define medial_SideLinks_h

#include "Balls/SideInput.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Evidence about two balls: are they on the same side or on opposite ones, and how surely?
struct SideLink
{
  Index a, b;
  float strength; ///< 0 ... 1
  bool same;
};

/// Links between balls that intersect deeply, which should be on one side, with the cosine of the angle at
/// which their spheres meet; and between the two poles of a sample, which should be on opposite sides,
/// with minus the cosine of the angle at which the sample sees them ([ACK01] section 4).
std::vector<SideLink> sideLinks(const SideInput& input);
}

#endif
