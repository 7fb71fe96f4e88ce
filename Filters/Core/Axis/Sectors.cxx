// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Sectors.h"

#include "Base/DisjointSets.h"
#include "Base/Lists.h"

namespace medial
{
Sectors::Sectors(const AxisCells& axisCells, Index pointCount)
  : cells(axisCells)
  , edges(axisEdges(axisCells))
  , sectors(this->firstOfLines() + 2 * count(axisCells.edges), None)
  , nextOfSector(sectors.size(), None)
  , sectorCounts(pointCount, 0)
  , lineAt(pointCount, None)
  , nextLine(2 * axisCells.edges.size(), None)
{
  DisjointSets joined(this->cornerCount());
  for (Index e = 0; e < count(this->edges.points); ++e)
  {
    const IndexLists::View at = this->edges.triangles[e];
    for (const Index p : this->edges.points[e])
    {
      if (at.size() == 2)
      {
        joined.unite(this->cornerAt(at[0], p), this->cornerAt(at[1], p));
      }
    }
  }
  // Downwards, so that each list of corners begins with the lowest one.
  for (Index corner = this->cornerCount() - 1; corner >= 0; --corner)
  {
    const Index first = this->sectors[corner] = joined.find(corner);
    const Index p = this->pointOf(corner);
    this->sectorCounts[p] += first == corner;
    if (first != corner)
    {
      this->nextOfSector[corner] = this->nextOfSector[first];
      this->nextOfSector[first] = corner;
    }
    if (this->isOfLine(corner))
    {
      const Index line = corner - this->firstOfLines();
      this->nextLine[line] = this->lineAt[p];
      this->lineAt[p] = corner;
    }
  }
}
}
