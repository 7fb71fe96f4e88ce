// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_FlatTriangles_h
#define medial_FlatTriangles_h

#include "Crust/CrustEdits.h"
#include "Crust/SliverLimits.h"

namespace medial
{
/// Takes triangles that are almost without an area out of a closed crust in a frame. Its topology stays,
/// and it moves by SliverLimits::side at most. Linear time.
///
/// Contracts a side that is so short that nobody sees it. Else it replaces the longest side by
/// the other diagonal of the two triangles there, if the smaller of the two becomes larger so. Else it
/// moves the corner opposite to the longest side off it, unless that is a sample. A triangle
/// whose side is shorter than SliverLimits::distance may stay: its ends are the matter.
void mendFlatTriangles(CrustEdits& edits, const SliverLimits& limits);
}

#endif
