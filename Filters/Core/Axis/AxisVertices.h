// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_AxisVertices_h
#define medial_AxisVertices_h

#include "Axis/Carving.h"
#include "Axis/SiteTriangulation.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The Voronoi vertices dual to the cells of an open set. Neighbouring cells on the same ball, and
/// neighbouring cells whose centres coincide, have one vertex (paper 3), as far as together they are
/// an open ball. Those that close a ring have several vertices at one place.
struct AxisVertices
{
  std::vector<Index> ofCell;    ///< the vertex of each cell; None where it is not in the set
  std::vector<Index> firstCell; ///< of each vertex
  std::vector<Index> ball;      ///< the pole that each vertex is, or None
};
AxisVertices axisVertices(const SiteTriangulation& sites, const OpenSet& set);
}

#endif
