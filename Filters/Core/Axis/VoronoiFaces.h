// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_VoronoiFaces_h
#define medial_VoronoiFaces_h

#include "Axis/Carving.h"
#include "Axis/FacePolygon.h"
#include "Axis/SiteTriangulation.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The Voronoi vertices dual to the cells of an open set. Neighbouring cells on the same ball, and
/// neighbouring cells whose centres coincide, have one vertex (paper 3).
struct AxisVertices
{
  std::vector<Index> ofCell;    ///< the vertex of each cell; None where it is not in the set
  std::vector<Index> firstCell; ///< of each vertex
  std::vector<Index> ball;      ///< the pole that each vertex is, or None
};
AxisVertices axisVertices(const SiteTriangulation& sites, const OpenSet& set);

/// The Voronoi faces dual to the edges of an open set, and as polygons of two corners the Voronoi edges
/// that are in none of them.
///
/// A Voronoi cell all of whose faces are there is opened: one of its faces is left out, which is the
/// collapse of the cell through that face.
std::vector<FacePolygon> voronoiFaces(
  const SiteTriangulation& sites, const OpenSet& set, const AxisVertices& vertices);
}

#endif
