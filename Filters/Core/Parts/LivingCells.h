// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_LivingCells_h
#define medial_LivingCells_h

#include "Axis/AxisCells.h"
#include "Axis/AxisEdges.h"
#include "Base/DisjointSets.h"
#include "Base/Lists.h"
#include "Base/Types.h"

#include <memory>
#include <vector>

namespace medial
{
/// The cells of an axis that are still there, and how many of them each edge and point has.
///
/// Cells are joined into groups with union-find; the groups are the parts. Removing cells only ever
/// joins groups: where an edge comes down from three triangles to two, these two now belong together.
/// So remove() notes such edges and points, and join() looks at these alone. All removals together cost
/// about linear time in the number of cells, however many rounds of pruning there are.
class LivingCells
{
public:
  /// In the beginning all cells live.
  /// @param axisCells, axisEdges  must outlive this
  /// @param bodies                for each cell its body, see Necks.h: cells of two bodies are never
  ///                              joined; empty: there is one body
  LivingCells(
    const AxisCells& axisCells, const AxisEdges& axisEdges, std::vector<Index> bodies = {});

  const AxisCells& cells;
  const AxisEdges& edges;

  bool isLiving(Index cell) const { return this->living[cell]; }
  Index size() const { return this->livingCount; }

  /// Points - edges + triangles of the living cells and their faces.
  Index eulerCharacteristic() const { return this->euler; }

  /// How many living triangles has an edge, how many living cells a point?
  Index trianglesAtEdge(Index edge) const { return this->atEdge[edge]; }
  Index cellsAtPoint(Index point) const { return this->atPoint[point]; }

  /// Do parts touch along an edge? They do where it has three living triangles or more, or two of
  /// different bodies.
  bool isContact(Index edge) const;

  /// For each point the cells that it had in the beginning, ascending.
  const IndexLists& cellsOfPoint() const { return *this->ofPoint; }

  /// @param removed  whole groups
  void remove(const std::vector<Index>& removed);

  /// Joins what belongs together since cells were removed. The groups are the parts (paper 4.1):
  /// triangles are joined over edges with exactly two, dangling edges over points with two and nothing
  /// else.
  void join();

  /// The lowest cell of the group.
  Index groupOf(Index cell) { return this->groups.find(cell); }

private:
  void joinAtEdge(Index edge);
  void joinAtPoint(Index point);

  /// Joins the cells if they are all of one body.
  void joinPair(Index first, Index second);

  std::vector<Index> bodyOfCell; ///< or empty
  std::vector<char> living;
  Index livingCount;
  Index euler;
  std::vector<Index> atEdge, atPoint;
  std::vector<Index> usesOfEdge;             ///< by triangles and dangling edges
  std::shared_ptr<const IndexLists> ofPoint; ///< copies share it
  DisjointSets groups;
  std::vector<Index> changedEdges, changedPoints; ///< came down to two cells since the last join()
};

/// For each point up to the last that cells use those, ascending.
IndexLists cellsOfPoints(const AxisCells& cells);

/// Calls onEdge(edge) and onPoint(point) for what a cell uses.
template <typename OnEdge, typename OnPoint>
void forFaces(const AxisCells& cells, const AxisEdges& edges, Index cell, const OnEdge& onEdge,
  const OnPoint& onPoint)
{
  if (cell >= cells.firstTriangle())
  {
    const Triangle& sides = edges.ofTriangle[cell - cells.firstTriangle()];
    onEdge(sides[0]), onEdge(sides[1]), onEdge(sides[2]);
  }
  else if (cell >= cells.firstEdge())
  {
    onEdge(edges.ofDangling[cell - cells.firstEdge()]);
  }
  forPoints(cells, cell, onPoint);
}
}

#endif
