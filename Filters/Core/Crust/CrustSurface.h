// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CrustSurface_h
#define medial_CrustSurface_h

#include "Base/Execution.h"
#include "Base/Types.h"
#include "Crust/PowerDiagram.h"

#include <vector>

namespace medial
{
/// The triangulated surface between the inner and the outer cells of a power diagram.
struct CrustSurface
{
  // One entry for each point.
  std::vector<Point> points;
  std::vector<Index> sampleOfPoint; ///< the sample that the point is, or None

  // One entry for each triangle.
  std::vector<Triangle> triangles; ///< points, counter-clockwise seen from outside
  std::vector<Index> innerBall;    ///< the ball behind the triangle
  std::vector<Index> outerBall;    ///< the ball in front of it
};

/// The faces between inner and outer power cells, contracted and cut into triangles, in the diagram's
/// frame and with its numbers of the balls. Takes linear time on average (hash tables).
///
/// A closed 2-manifold by construction. The power diagram is simple: three cells meet at an edge and
/// four at a vertex. So of the faces at an edge none or two lie between the two sides, and those at a
/// vertex form one fan. Contraction and triangulation keep that. Power vertices that are the same
/// sample, or the same up to rounding, become one point if the surface is a manifold after that;
/// otherwise they stay several points at one place.
CrustSurface crustSurface(const PowerDiagram& diagram, const Execution& execution = {});
}

#endif
