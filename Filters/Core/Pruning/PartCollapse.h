// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PartCollapse_h
#define medial_PartCollapse_h

#include "Base/Types.h"
#include "Parts/LivingCells.h"

#include <vector>

namespace medial
{
/// Tells whether some living cells can be removed without a change of topology.
///
/// Idea: removing a free face together with the one cell that it belongs to (an edge with its only
/// triangle, a point with its only edge) deforms the rest and doesn't tear it. If a set of cells can be
/// removed by such steps alone, down to the edges and points that other cells use too, then the Betti
/// numbers stay the same.
/// Invariant: in a 2-complex the order of the steps doesn't matter. If one order gets stuck, all do. So
/// triangles are collapsed first, then edges, each in whatever order they come free.
/// Cost: O(k) for k cells, whatever the size of the axis, because only the marks of these cells' edges
/// and points are set, and cleared at the end.
class PartCollapse
{
public:
  /// @param livingCells  must outlive this
  explicit PartCollapse(const LivingCells& livingCells);

  /// What removing some living cells would do.
  enum class Effect
  {
    None,    ///< they collapse, by free faces, onto their contact with the rest
    Changes, ///< they don't: the Betti numbers could change
    Isolated ///< they have no contact with the rest: a whole piece would be lost
  };

  /// @param unit  living cells; the edges and points that other living cells use too are the contact
  Effect effectOfRemoving(const std::vector<Index>& unit);

private:
  /// What an edge or a point is in the unit.
  enum class State : char
  {
    NotHere, ///< not in the unit; all are that between two calls
    Free,    ///< no other living cell has it
    Fixed,   ///< other living cells have it too: it stays
    Gone     ///< collapsed
  };

  /// An edge with the triangles of the unit that are left at it, or a point with the edges.
  struct Face
  {
    Index count = 0; ///< how many are left

    /// XOR of the numbers of those that are left. A number is taken out by a second XOR with it. When
    /// one is left, this is its number: so the last one is found without a list.
    Index numbers = 0;
    State state = State::NotHere;

    void add(Index number) { ++this->count, this->numbers ^= number; }
    void take(Index number) { --this->count, this->numbers ^= number; }
  };

  void enter(const std::vector<Index>& unit); ///< sets the marks
  void leave();                               ///< clears them
  bool hasContact() const;

  /// Collapses all they can. @return  is all collapsed that isn't fixed?
  bool collapseTriangles(Index triangleCount);
  bool collapseEdges();

  void takeFromPoints(Index edge);

  const LivingCells& living;
  std::vector<Face> edges;                ///< with the triangles of the unit
  std::vector<Face> points;               ///< with the edges of the unit
  std::vector<Index> ownEdges, ownPoints; ///< those of the unit
};
}

#endif
