// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_VoronoiFaces_h
#define medial_VoronoiFaces_h

#include "Axis/AxisVertices.h"
#include "Axis/Carving.h"
#include "Axis/FacePolygon.h"
#include "Axis/SiteTriangulation.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The Voronoi faces dual to the edges of an open set, and as polygons of two corners the Voronoi edges
/// that are in none of them.
///
/// A Voronoi cell all of whose faces are there is opened: one of its faces is left out, which is the
/// collapse of the cell through that face.
///
/// The topology of the open set stays: a face that comes to a vertex twice, and vertices that have
/// several edges between them, get further vertices.
struct VoronoiFaces
{
  std::vector<FacePolygon> polygons;
  std::vector<Edge>
    midpoints; ///< further vertices, numbered on from the dual ones: each is to lie in
               ///< the middle between these two, which have lower numbers
};
VoronoiFaces voronoiFaces(const SiteTriangulation& sites, const OpenSet& set,
  const AxisVertices& vertices, const Execution& execution = {});
}

#endif
