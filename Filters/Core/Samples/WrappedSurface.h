// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_WrappedSurface_h
#define medial_WrappedSurface_h

#include "Samples/ClosedSurface.h"

namespace medial
{
struct WrapOptions
{
  /// Gaps and holes narrower than this are closed, in the unit of the points; 0: a twenty-fifth of the
  /// diagonal of their bounding box.
  double width = 0;

  /// How far the wrap is outside the polygons, where no gap is too narrow; 0: a sixtieth of the width.
  double offset = 0;
};

/// A closed surface around polygons that need not bound a solid: with holes, with intersections, in any
/// orientation. It encloses all of them, so voids inside are filled. Computed by CGAL's alpha wrapping
/// (Portaneri et al., Alpha wrapping with an offset, 2022).
///
/// The warning `wrapped` tells how far it is from them. `polygons` of the result is the nearest one.
/// @throw InvalidInput  there is no polygon; a length that is negative or not finite; the wrap is only a
///                      shell about the polygons, since it goes inside through a hole that is wider
/// @throw Aborted
ClosedSurface wrappedSurface(const std::vector<Point>& points, const IndexLists& polygons,
  const WrapOptions& options = {}, const Execution& execution = {});
}

#endif
