// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Carving_h
#define medial_Carving_h

#include "Axis/SiteTriangulation.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// An open set of a triangulation: some cells, and the facets, edges and vertices all of whose cells are
/// in it. Its dual is a complex of Voronoi vertices, edges, faces and cells.
struct OpenSet
{
  std::vector<char> cells; ///< for each cell: is it in the set?
};

/// The inside of the shape: core cells, and others at least as deep as `kappa`, without components
/// in which no cell is on a ball.
/// @param kappa  least SiteTriangulation::depth of a candidate: 0 takes all that can be inside, and
///               larger values fewer, only those far from the boundary
OpenSet insideCells(const SiteTriangulation& sites, double kappa);

/// Betti numbers of an open set of cells.
Betti bettiNumbers(const SiteTriangulation& sites, const OpenSet& set);

/// Removes cells that are not core, the shallowest first, as long as the topology stays: a cell can
/// go if the vertices (V), edges (E) and facets (F) that it shares with the outside are connected and
/// V - E + F is 1.
void carve(const SiteTriangulation& sites, OpenSet& set, const Execution& execution = {});

/// The simplices of the triangulation with a cell outside an open set (or on the hull).
struct Outside
{
  std::vector<char> vertices, edges; ///< by singular point, by number of the edge
};
Outside outsideOf(const SiteTriangulation& sites, const OpenSet& set);
}

#endif
