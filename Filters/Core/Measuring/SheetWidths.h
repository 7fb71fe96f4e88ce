// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SheetWidths_h
#define medial_SheetWidths_h

#include "Axis/AxisEdges.h"
#include "Axis/MedialAxis.h"
#include "Base/Execution.h"

#include <vector>

namespace medial
{
/// How wide and how thick the solid is around each point of its axis; unit of the samples.
///
/// The burn time of a point is its erosion thickness plus its radius: when the fire from the border of
/// the solid has come there. From each point one climbs along the sides of triangles, always the
/// steepest one, to a summit of the burn time, the middle of the sheet. There the fire has come half
/// the width of the sheet: W = 2 * burn time. T is the distance of the walls there, of the samples on both sides:
/// balls bulge between the samples of a plate. A rod with an elliptic section has W / T = a / b but for
/// errors of sampling: it is less by up to 3 % with samples a tenth of the thickness apart, by 3 to 6 % with a fifth, by
/// 7 to 12 % with 0.28. About half of it is that the balls at the rim don't reach the sharp end. A third is that the fire
/// comes first from where the rim happens to be nearest. The rest is in T: summits are where balls happen to be large.
///
/// What no fire reaches (closed sheets, as of a hollow sphere) has the largest erosion thickness of
/// all, at least the diagonal of the box around the balls. So its width is more than twice that
/// diagonal: finite, and no width of the solid.
struct SheetWidths
{
  std::vector<Index> summit;     ///< for each point; itself where it has no triangle
  std::vector<double> width;     ///< W; where there is no triangle 2 * radius
  std::vector<double> thickness; ///< T, at the summit
  std::vector<double> ratio;     ///< W / T; 1 where there is no triangle, or the radius is 0
};

/// Takes linear time. Of equally steep sides the one to the lower point is taken.
/// @param times  burnTimes() of the axis
SheetWidths sheetWidths(const MedialAxis& axis, const AxisEdges& edges,
  const std::vector<double>& times, const Execution& execution = {});
}

#endif
