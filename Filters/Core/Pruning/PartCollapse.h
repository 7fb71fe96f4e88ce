// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PartCollapse_h
#define medial_PartCollapse_h

#include "Base/Types.h"
#include "Parts/LivingCells.h"

#include <vector>

namespace medial
{
/// Tells what may be taken from the living cells of an axis without a change of topology.
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
    Isolated ///< they have no contact: a whole piece would be lost
  };

  /// Exact, and linear in the number of cells: a 2-complex collapses onto a subcomplex, if at all,
  /// in any order of its free faces. Edges and points that other living cells use are the contact.
  Effect effectOfRemoving(const std::vector<Index>& unit);

private:
  /// Of an edge or a point of the unit.
  enum class State : char
  {
    NotHere, ///< of none; all are between two calls
    Free,
    Fixed, ///< other living cells have it too
    Gone   ///< collapsed
  };

  /// An edge or a point, with what is left of the unit there: how many, and their numbers added without
  /// carry. Where one is left, that is its number.
  struct Face
  {
    Index count = 0;
    Index numbers = 0;
    State state = State::NotHere;

    void add(Index number) { ++this->count, this->numbers ^= number; }
    void take(Index number) { --this->count, this->numbers ^= number; }
  };

  void enter(const std::vector<Index>& unit);
  void leave();
  bool hasContact() const;
  bool collapseTriangles(Index triangles);
  bool collapseEdges();
  void takeFromPoints(Index edge);

  const LivingCells& living;
  std::vector<Face> edges;                ///< with the triangles of the unit
  std::vector<Face> points;               ///< with the edges of the unit
  std::vector<Index> ownEdges, ownPoints; ///< those of the unit
};
}

#endif
