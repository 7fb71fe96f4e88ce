// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_FaceTriangulation_h
#define medial_FaceTriangulation_h

#include "Axis/AxisComplex.h"
#include "Axis/FacePolygon.h"
#include "Axis/SingularPoints.h"
#include "Axis/SiteTriangulation.h"
#include "Base/Execution.h"
#include "Base/Frame.h"

#include <vector>

namespace medial
{
/// Makes the cells of an axis: triangulates faces (paper 4.1), adds the edges that are sides of no
/// triangle, and the points that are in no other cell, each with its sites.
/// @param polygons  corners are points of the axis
/// @param frame     the one that `sites` are in
/// @param axis      has points and no cells; gets more points where a face needs its centroid
void addCells(const std::vector<FacePolygon>& polygons, const SiteTriangulation& sites,
  const SingularPoints& singularPoints, const Frame& frame, AxisComplex& axis,
  const Execution& execution = {});
}

#endif
