// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CrustSurface_h
#define medial_CrustSurface_h

#include "Base/Execution.h"
#include "Base/Lists.h"
#include "Base/Tetrahedra.h"
#include "Base/Types.h"
#include "Crust/PowerCrust.h"

#include <vector>

namespace medial
{
/// The power diagram of inner and outer balls by its dual, geometry in a frame.
struct PowerDiagram
{
  std::vector<Ball> balls;
  std::vector<char> inner;
  IndexLists samples;           ///< of each ball
  std::vector<Point> positions; ///< of the samples
  Tetrahedra dual;

  // One entry for each cell of the dual whose corners are on both sides (others: None, zero).
  std::vector<Index> sampleOfVertex; ///< the power vertex is this sample, or None
  std::vector<Point> vertices;
};

/// Fills dual, sampleOfVertex and vertices: a power vertex is the sample that its four balls share;
/// only where they share none it is computed.
/// @throw InvalidInput  a cell is flat
void findVertices(Tetrahedra dual, PowerDiagram& diagram, const Execution& execution = {});

/// Triangles between inner and outer power cells, oriented outwards, in the diagram's frame.
///
/// A closed 2-manifold by construction: the power diagram is simple, so its faces between two sides
/// are one. Vertices at the same sample, or the same to rounding, become one where their contraction
/// leaves it a manifold without repeated corners, and stay several where it doesn't.
Crust crustSurface(const PowerDiagram& diagram);
}

#endif
