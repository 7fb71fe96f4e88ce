// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_PartCollapse_h
#define medial_PartCollapse_h

#include "AxisEdges.h"
#include "MedialAxis.h"
#include "Types.h"

#include <vector>

namespace medial
{
/// The living cells of an axis, and what may be taken from them without a change of topology.
class LivingCells
{
public:
  LivingCells(const AxisCells& cells, const AxisEdges& edges);

  const std::vector<char>& mask() const { return this->living; }
  bool isLiving(Index cell) const { return this->living[cell]; }
  Index size() const { return this->livingCount; }

  void remove(const std::vector<Index>& cells);

  /// What removing some living cells would do.
  enum class Effect
  {
    None,    ///< they collapse, by free faces, onto their contact with the rest
    Changes, ///< they don't: the Betti numbers could change
    Isolated ///< they have no contact: a whole piece would be lost
  };

  /// Exact, and linear in the number of cells: a 2-complex collapses onto a subcomplex, if at all,
  /// in any order of its free faces. Edges and points that other living cells use are the contact.
  Effect effectOfRemoving(const std::vector<Index>& cells);

private:
  struct Unit;
  Unit unitOf(const std::vector<Index>& cells);
  /// Finds what of a unit other living cells use, by its edges and points; clears the scratch.
  void findContact(const std::vector<Index>& edges, const std::vector<Index>& points, Unit& unit);
  void collapseTriangles(Unit& unit) const;
  bool collapseEdges(Unit& unit) const;

  const AxisCells& axisCells;
  const AxisEdges& axisEdges;
  std::vector<char> living;
  Index livingCount;
  std::vector<Index> trianglesAtEdge, cellsAtPoint; ///< how many live
  std::vector<Index> localEdge, localPoint;         ///< scratch, None between calls
};
}

#endif
