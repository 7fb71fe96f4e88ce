// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Trimming_h
#define medial_Trimming_h

#include "Axis/FacePolygon.h"
#include "Axis/Sheets.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Leaves out pieces of the axis without a pole of their own, and keeps sheets apart that meet at a
/// seam (SheetSeparation.h), by collapses of faces with a free side: the topology stays.
///
/// Three faces are sheets of a seam if between every two of them a site moves farther than its distance
/// to the axis (Sheets.h). A piece all of whose poles are on other pieces, too, adds nothing to the
/// union of balls, so the solid keeps its shape without it.
/// @return  for each vertex: is it no longer there?
std::vector<char> trimSheets(const FaceGeometry& geometry, std::vector<FacePolygon>& polygons,
  const Execution& execution = {});

/// Leaves out flaps: faces joined over sides with exactly two of them, without a pole of their own. They
/// may lie on a sheet and be equally far from the same sites, so that trimSheets takes them for a part of
/// the sheet. The topology stays, as above.
/// @return  for each vertex: is it no longer there?
std::vector<char> trimFlaps(const FaceGeometry& geometry, std::vector<FacePolygon>& polygons,
  const Execution& execution = {});
}

#endif
