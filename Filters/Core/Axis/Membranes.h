// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Membranes_h
#define medial_Membranes_h

#include "Axis/FacePolygon.h"
#include "Axis/Sheets.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Contracts membranes to edges. The topology stays.
///
/// A membrane is a small patch of faces across a tunnel through one sheet, or between two. At its sides a sheet
/// passes by. So it can't be left out, but would stay a part of its own whatever is pruned. Such tunnels
/// are as narrow as a few sites are close together.
/// @return  for each vertex: is it no longer there?
std::vector<char> closeMembranes(const FaceGeometry& geometry, std::vector<FacePolygon>& polygons);
}

#endif
