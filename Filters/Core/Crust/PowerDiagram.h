// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PowerDiagram_h
#define medial_PowerDiagram_h

#include "Base/BallTree.h"
#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The power diagram of inner and outer balls, given by its dual: the balls' regular triangulation.
///
/// A ball is the dual of a power cell, an edge of the triangulation that of the face between two
/// cells, and a tetrahedron that of a power vertex, where four cells meet. All coordinates are in
/// one Frame.
struct PowerDiagram
{
  // One entry for each ball.
  std::vector<Ball> balls;
  std::vector<char> inner; ///< 1: inside the solid, 0: outside
  IndexLists samples;      ///< on the ball's sphere, ascending; none on a ball that was added

  std::vector<Point> positions; ///< of the samples
  Tetrahedra dual;

  // One entry for each tetrahedron of the dual; meaningful only for mixed ones.
  std::vector<Index> sampleOfVertex; ///< the sample that the power vertex is, or None
  std::vector<Point> vertices;       ///< where it is; zero for tetrahedra that are not mixed
};

/// Has the tetrahedron both inner and outer balls, so that its power vertex is on the crust?
bool isMixed(const PowerDiagram& diagram, const Tetrahedron& cell);

/// Fills dual, sampleOfVertex and vertices, in linear time. If the four balls of a mixed tetrahedron
/// share a sample, that sample is the power vertex; else it is constructed by `powerCenter`.
/// @param numbersBefore  for each tetrahedron its number in the diagram's dual until now, where its vertex is known;
///                       a number that is another one's, or None, does no harm. Empty: none is known
/// @throw InvalidInput  a mixed tetrahedron without a shared sample is flat
void findVertices(Tetrahedra dual, PowerDiagram& diagram, const Execution& execution = {},
  const std::vector<Index>& numbersBefore = {});

/// The inner balls, to ask for the distance of a point to their union.
BallTree treeOfInnerBalls(const PowerDiagram& diagram);
}

#endif
