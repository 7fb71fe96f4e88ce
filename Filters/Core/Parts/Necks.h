// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Necks_h
#define medial_Necks_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The bodies into which necks divide an axis: a trunk for each connected piece, and limbs.
struct Bodies
{
  std::vector<Index> ofCell; ///< for each cell its body
  /// For each body its largest radius divided by that of the body it was cut off; 1 for a trunk.
  std::vector<double> neckRatio;
};

/// Finds limbs that the paper's parts do not separate from the rest, as the bunny's feet (sections 6, 7).
///
/// 1. A body begins at the point with the largest radius. It takes what is connected to this point and
///    has at least seven tenths of that radius.
/// 2. It then takes what is connected to this and lies inside the maximal balls of what it has.
/// 3. The rest falls into connected pieces. A piece also falls apart where the radius dips below eight
///    tenths of the smaller of two maxima.
/// 4. Each piece becomes a body in the same way. It is a limb if its largest radius is at most
///    `neckRatio` times that of the body next to it, and the cut is short: its squared length is at most
///    20 times the area cut off. Else it belongs to the body next to it.
///
/// Cells are cut off whole, and no point moves. The result does not depend on units; of equal radii the
/// lower number comes first.
/// @param neckRatio  0 ... 1; 0 cuts nothing off
Bodies bodies(const MedialAxis& axis, const AxisEdges& edges, double neckRatio);
}

#endif
