// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_DualComplex_h
#define medial_DualComplex_h

#include "Axis/AxisComplex.h"
#include "Axis/Carving.h"
#include "Axis/SingularPoints.h"
#include "Axis/SiteTriangulation.h"
#include "Base/Types.h"

namespace medial
{
/// The Voronoi vertices, edges and faces dual to the cells, facets and edges of an open set.
///
/// Each vertex is there once: neighbouring cells on the same ball have the ball's pole, and
/// neighbouring cells whose centres coincide have one centre (paper 3). Faces are triangulated
/// (paper 4.1). Voronoi edges in no face become edges of their own. A Voronoi cell all of whose faces
/// are there is opened by leaving out one of them, which is an exact collapse.
AxisComplex dualComplex(const PolarBalls& polarBalls, const SingularPoints& singularPoints,
  const SiteTriangulation& sites, const OpenSet& set, const Frame& frame);
}

#endif
