// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_LivingCells_h
#define medial_LivingCells_h

#include "Axis/AxisCells.h"
#include "Axis/AxisEdges.h"
#include "Base/DisjointSets.h"
#include "Base/Lists.h"
#include "Base/Types.h"

#include <array>
#include <map>
#include <memory>
#include <vector>

namespace medial
{
/// The cells of an axis that are still there, and how many of them each edge and point has.
///
/// Cells are joined into groups with union-find; the groups are the parts. Removing cells only ever
/// joins groups: where an edge comes down from three triangles to two, these two now belong together.
/// So remove() notes such edges and points, and join() looks at these alone.
///
/// A notch in a third part does not join two: where only a scrap of it has gone, the two still meet along the rest of
/// it, as the sheets of a box beside one of its corners. They stay two as long as the notch is short against that.
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
  /// different bodies or at a notch.
  bool isContact(Index edge) const;

  /// For each point the cells that it had in the beginning, ascending.
  const IndexLists& cellsOfPoint() const { return *this->ofPoint; }

  /// @param removed  whole groups
  void remove(const std::vector<Index>& removed);

  /// Joins what belongs together since cells were removed. The groups are the parts (paper 4.1):
  /// triangles are joined over edges with exactly two, but not over notches; dangling edges over points with two
  /// and nothing else. Linear in the number of edges where notches are, else in what has changed.
  void join();

  /// Joins each scrap to a neighbor that is at all of its border: a group without a free edge, with no more triangles
  /// than edges at contacts, so that a patch has one point inside at most. Seams between sheets leave scraps
  /// where they zigzag. Linear in the number of cells.
  /// @return  were there any?
  bool joinScraps();

  /// The lowest cell of the group.
  Index groupOf(Index cell) { return this->groups.find(cell); }

private:
  /// The two living triangles of an edge that has two.
  std::array<Index, 2> trianglesOf(Index edge) const;

  void joinAtEdge(Index edge);

  /// Joins groups over edges of two triangles, but leaves notches.
  void joinAcross(std::vector<Index> edges);

  /// How long two groups border on each other, in edges.
  struct BorderLengths
  {
    Index open = 0; ///< with nothing else
    Index seam = 0; ///< with others
  };
  using PairLengths = std::map<std::array<Index, 2>, BorderLengths>;

  /// Drops edges that don't lie between two groups that may be joined, and adds the others to the lengths.
  void keepOpen(std::vector<Index>& edges, PairLengths& lengths);

  /// The groups of the living triangles at an edge, ascending.
  void groupsAtEdge(Index edge, std::vector<Index>& result);

  /// Adds the edges with other groups to the lengths of the pairs that are known.
  void addSeams(PairLengths& lengths);

  void joinAtPoint(Index point);

  /// How many triangles a group has, and how often these are at an edge without others, or at a contact.
  struct GroupSize
  {
    Index triangles = 0, freeEdges = 0, contactEdges = 0;
  };

  /// Of each group, by the cell that it is known by.
  std::vector<GroupSize> groupSizes();

  /// Are they of one body?
  bool mayJoin(Index first, Index second) const;

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
  std::vector<Index> notches;                     ///< edges of two triangles that don't join them
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
