// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_OutsideSearch_h
#define medial_OutsideSearch_h

#include "Axis/Carving.h"
#include "Axis/SiteTriangulation.h"
#include "Base/Lists.h"
#include "Base/Types.h"

#include <array>
#include <vector>

namespace medial
{
/// Tells which places outside an open set are connected with each other outside it.
class OutsideSearch
{
public:
  /// @param triangulation  must outlive this
  explicit OutsideSearch(const SiteTriangulation& triangulation)
    : sites(triangulation)
  {
  }

  /// Into how many connected pieces does what is outside around a cell fall when the cell joins the set? These are
  /// cells outside joined over shared vertices; all beyond the hull is one piece with them. The search ends when all but
  /// one are complete, so it takes time linear in the cells of the others, or in those up to where they meet.
  /// @param cell  outside the set
  Index piecesAround(Index cell, const OpenSet& set);

private:
  /// What is reached from one vertex of the cell.
  struct Reached
  {
    Index label;                 ///< the lowest one of those that it has met
    bool isBeyond;               ///< has it, or one that it has met, reached the hull?
    std::vector<Index> vertices; ///< in the order in which it came to them
    std::size_t done;            ///< around so many of them it has looked

    bool isComplete() const { return this->done == this->vertices.size(); }
  };

  void prepare();
  void begin(Index vertex);
  void expand(std::size_t which, Index cell, const OpenSet& set);
  void visit(Index vertex, Index label);
  void unite(Index a, Index b);
  Index activePieces() const;

  const SiteTriangulation& sites;
  IndexLists cellsOfVertex;         ///< once they are needed
  std::vector<char> isOnHull;       ///< for each vertex
  std::vector<Index> labelOfVertex; ///< during a search, else None
  std::vector<Reached> reached;
};
}

#endif
