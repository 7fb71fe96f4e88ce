// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CurveSkeleton_h
#define medial_CurveSkeleton_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Edges along the middle of an axis. They run where the fires from both sides of a sheet meet.
struct CurveSkeleton
{
  std::vector<Edge> edges; ///< ascending corners, ascending
  Index openedVoids;       ///< closed sheets, a hole in each of which let the fire in
};

/// Collapses the triangles of an axis, those first that burn first: a triangle goes together with an
/// edge that no other triangle has. So pieces and loops stay by construction, and all points. A sheet
/// closed around a void has no such edge; it loses the triangle that would burn last, which ends
/// the void.
///
/// An edge burns no earlier than (sum of its ends' times - its length) / 2, because the fire takes time
/// to cross it. This puts edges across a narrow sheet before edges along its middle.
///
/// Takes O(n log n).
/// @param times   burnTimes() of the axis
/// @param counts  for each triangle: is it there? Lines all are.
CurveSkeleton curveSkeleton(const MedialAxis& axis, const AxisEdges& edges,
  const std::vector<double>& times, const std::vector<char>& counts,
  const Execution& execution = {});
}

#endif
