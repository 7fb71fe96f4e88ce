// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_OutsideCounts_h
#define medial_OutsideCounts_h

#include "Axis/SiteTriangulation.h"
#include "Base/Types.h"

#include <array>
#include <vector>

namespace medial
{
/// A piece of the boundary of a tetrahedron, closed as a set.
struct BoundaryPiece
{
  int components; ///< connected ones
  int loops;      ///< a ring has one, a disc none, the whole boundary -1

  bool isContractible() const { return this->components == 1 && this->loops == 0; }
};

/// @param vertices, edges  which are in the piece, as in cellEdges
/// @param facets           how many are
BoundaryPiece boundaryPiece(
  const std::array<bool, 4>& vertices, const std::array<bool, 6>& edges, int facets);

/// How many cells outside an open set there are around each vertex and edge of a triangulation, while
/// cells come and go. A facet of the hull counts as one cell more.
class OutsideCounts
{
public:
  /// All cells are outside at first.
  explicit OutsideCounts(const SiteTriangulation& triangulation);

  void takeIn(Index cell) { this->add(cell, -1); }
  void putOut(Index cell) { this->add(cell, 1); }

  /// What a cell outside shares with the other cells outside.
  /// @param facets  how many facets it shares with them and with the hull
  BoundaryPiece sharedWithOthers(Index cell, int facets) const;

private:
  void add(Index cell, Index one);
  void addBeyond(Index cell, int i);

  const SiteTriangulation& sites;
  std::vector<Index> atVertex, atEdge;
};
}

#endif
