// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Slivers_h
#define medial_Slivers_h

#include "Base/Execution.h"
#include "Crust/CrustSurface.h"

namespace medial
{
/// Takes points at the same place and triangles without an area out of a closed surface in a frame. Its
/// topology stays, and it moves by a few millionths of the object, see SliverLimits.
///
/// - Edges shorter than SliverLimits::distance are contracted, unless they join two samples, or that would
///   pinch the surface.
/// - mendFlatTriangles() contracts or flips sides of flat triangles.
/// - Points that are still at one place carry topology: sheets touch there, or a tunnel has no width. The
///   first stays, a sample if there is one. The others are moved towards their neighbours until single
///   precision tells them apart; they are samples no longer. So a file that knows points by their places,
///   as STL does, gives back the same closed surface.
///
/// Two samples stay two, however near they are. Takes O(n log n), for the points at one place.
/// @param spacing  of the samples, in the frame
void removeSlivers(CrustSurface& surface, double spacing, const Execution& execution = {});
}

#endif
