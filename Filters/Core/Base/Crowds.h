// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Crowds_h
#define medial_Crowds_h

#include "Base/Lists.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Groups of points that may be near to each other: any two nearer than `distance` are together in one
/// group at least. Most points are in none. O(n log n) whatever the points are, by a grid.
/// @param used      for each point: does it count?
/// @param distance  far below that of most points
IndexLists crowds(const std::vector<Point>& points, const std::vector<char>& used, double distance);
}

#endif
