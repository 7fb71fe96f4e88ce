// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_SiteTriangulation_h
#define medial_SiteTriangulation_h

#include "Axis/SingularPoints.h"
#include "Balls/PolarBalls.h"
#include "Balls/PowerShape.h"
#include "Base/Execution.h"
#include "Base/Frame.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The Delaunay triangulation of the singular points, the dual of the Voronoi diagram whose faces
/// inside the shape are the medial axis (paper 2.1 step 3). Geometry is in the frame.
struct SiteTriangulation
{
  Tetrahedra mesh; ///< corners are singular points
  EdgeNumbers edges;
  Index siteCount;

  // One entry for each cell.
  std::vector<Ball> spheres; ///< circumspheres; the polar ball itself where the cell is on one
  std::vector<Index> onBall; ///< the inner ball that passes through all four corners, or None
  std::vector<char> isCore;  ///< on a ball, or its centre is in the power shape: surely inside
  /// How deep in the solid the cell's centre is, relative to the solid's thickness there: circumradius /
  /// radius of the largest inner ball through a corner, for the corner where that is smallest. 1 for
  /// cells on a ball, near 0 for centres close to the boundary. Where the centre is outside it is how far
  /// outside, negative.
  std::vector<double> depth;
};

/// @param sites  of this shape
/// @param frame  of the samples
SiteTriangulation siteTriangulation(const PolarBalls& polarBalls, const PowerShape& shape,
  const SingularPoints& sites, const Frame& frame, const Execution& execution = {});
}

#endif
