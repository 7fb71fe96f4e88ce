// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ClosedChains_h
#define medial_ClosedChains_h

#include "Base/Lists.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The dimension, over Z/2, of the space of closed 2-chains of a complex: sets of triangles of which
/// every edge has an even number. In a complex without tetrahedra this is the number of voids.
///
/// Triangles come in groups: a closed chain holds all triangles of a group or none. For triangles
/// that are joined over edges with exactly two this is so, and there are far fewer groups than
/// triangles.
///
/// @param groupsAtEdges  for each edge where groups meet: the group of each of its triangles, in any
///                       order, with repeats
/// @param excluded       for each group: is it known to be in no closed chain, as one with an edge
///                       that has one triangle?
Index closedChains(const IndexLists& groupsAtEdges, std::vector<char> excluded);
}

#endif
