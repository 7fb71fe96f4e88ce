// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Sectors_h
#define medial_Sectors_h

#include "Axis/AxisCells.h"
#include "Axis/AxisEdges.h"
#include "Base/Types.h"

#include <algorithm>
#include <vector>

namespace medial
{
/// The corners of the cells of an axis, and the sectors that they form at each point.
///
/// A corner is where a triangle or a line has a point: number 3 t + k for corner k of triangle t, and
/// after those 2 e + k for end k of line e. A sector is what hangs together at a point: the corners of
/// triangles joined over edges with exactly two, or one end of a line. Where three sheets meet along a
/// seam, for example, each point of the seam has three sectors. A sector is known by its lowest corner.
class Sectors
{
public:
  /// @param axisCells  must outlive this
  Sectors(const AxisCells& axisCells, Index pointCount);

  const AxisCells& cells;
  const AxisEdges edges;

  Index cornerCount() const { return count(this->sectors); }
  Index firstOfLines() const { return 3 * count(this->cells.triangles); }
  bool isOfLine(Index corner) const { return corner >= this->firstOfLines(); }

  Index pointOf(Index corner) const
  {
    const Index line = corner - this->firstOfLines();
    return line < 0 ? this->cells.triangles[corner / 3][corner % 3]
                    : this->cells.edges[line / 2][line % 2];
  }
  Index cellOf(Index corner) const
  {
    const Index line = corner - this->firstOfLines();
    return line < 0 ? this->cells.firstTriangle() + corner / 3 : this->cells.firstEdge() + line / 2;
  }
  Index cornerAt(Index triangle, Index point) const
  {
    const Triangle& t = this->cells.triangles[triangle];
    return 3 * triangle + static_cast<Index>(std::find(t.begin(), t.end(), point) - t.begin());
  }
  Index otherEndOfLine(Index corner) const
  {
    return this->firstOfLines() + ((corner - this->firstOfLines()) ^ 1);
  }

  Index sectorOf(Index corner) const { return this->sectors[corner]; }

  /// How many sectors each point has.
  const std::vector<Index>& sectorsAt() const { return this->sectorCounts; }

  /// Calls body(corner) for the corners of a sector, lowest first.
  template <typename Body>
  void forCornersOf(Index sector, const Body& body) const
  {
    for (Index corner = sector; corner != None; corner = this->nextOfSector[corner])
    {
      body(corner);
    }
  }

  /// Calls body(corner) for the ends of lines at a point.
  template <typename Body>
  void forLinesAt(Index point, const Body& body) const
  {
    for (Index corner = this->lineAt[point]; corner != None;
         corner = this->nextLine[corner - this->firstOfLines()])
    {
      body(corner);
    }
  }

private:
  std::vector<Index> sectors;      ///< for each corner the lowest of its sector
  std::vector<Index> nextOfSector; ///< for each corner the next one of its sector, or None
  std::vector<Index> sectorCounts; ///< for each point
  std::vector<Index> lineAt;       ///< for each point the first end of a line there, or None
  std::vector<Index> nextLine;     ///< for each end of a line the next one at its point, or None
};
}

#endif
