// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_DualComplex_h
#define medial_DualComplex_h

#include "Axis/AxisComplex.h"
#include "Axis/Carving.h"
#include "Axis/SingularPoints.h"
#include "Axis/SiteTriangulation.h"
#include "Balls/PolarBalls.h"
#include "Base/Execution.h"
#include "Base/Frame.h"

namespace medial
{
/// The Voronoi vertices, edges and faces dual to the cells, facets and edges of an open set, with the
/// set's Betti numbers.
///
/// Each vertex is there once (VoronoiFaces.h, VertexMerging.h), without slivers (Trimming.h); faces are
/// triangulated (FaceTriangulation.h).
/// @param frame  the one that `sites` are in
AxisComplex dualComplex(const PolarBalls& polarBalls, const SingularPoints& singularPoints,
  const SiteTriangulation& sites, const OpenSet& set, const Frame& frame,
  const Execution& execution = {});
}

#endif
