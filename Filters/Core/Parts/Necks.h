// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Necks_h
#define medial_Necks_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// What an axis falls into where its radius has necks: a trunk for each piece, and limbs.
struct Bodies
{
  std::vector<Index> ofCell; ///< for each cell its body
  std::vector<double>
    neckRatio; ///< for each body: its largest radius / that of the body it was cut
               ///< off; 1: of none
};

/// Finds limbs that the paper's parts leave on the rest, as the bunny's feet (its sections 6 and 7).
///
/// From the point with the largest radius a body takes what hangs together with it and has at least
/// seven tenths of that radius, then what hangs together with this and lies inside the balls there.
/// What is left falls apart where the radius dips below eight tenths of the smaller of two maxima.
/// Each of these pieces becomes a body in the same way. It is a limb if its largest radius is at most
/// `neckRatio` times that of the body it is next to, and the cut is short: its squared length is at
/// most 20 times the area cut off. Else it goes on with the body it is next to.
///
/// Nothing is moved: cells are cut off whole. Doesn't depend on units; ties by the lower number.
/// @param neckRatio  0 ... 1; 0 cuts nothing off
Bodies bodies(const MedialAxis& axis, const AxisEdges& edges, double neckRatio);
}

#endif
