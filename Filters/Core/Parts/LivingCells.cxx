// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/LivingCells.h"

#include "Base/Lists.h"

#include <algorithm>
#include <utility>

namespace medial
{
IndexLists cellsOfPoints(const AxisCells& cells)
{
  const auto forAll = [&cells](const auto& body) {
    for (Index c = 0; c < cells.size(); ++c)
    {
      forPoints(cells, c, [&](Index p) { body(p, c); });
    }
  };
  Index highest = None;
  forAll([&highest](Index p, Index) { highest = std::max(highest, p); });
  return listsByKey(highest + 1, forAll);
}

LivingCells::LivingCells(
  const AxisCells& axisCells, const AxisEdges& axisEdges, std::vector<Index> bodies)
  : cells(axisCells)
  , edges(axisEdges)
  , bodyOfCell(std::move(bodies))
  , living(axisCells.size(), 1)
  , livingCount(axisCells.size())
  , euler(count(axisCells.triangles))
  , ofPoint(std::make_shared<IndexLists>(cellsOfPoints(axisCells)))
  , groups(axisCells.size())
{
  this->atEdge.reserve(this->edges.points.size());
  this->atPoint.reserve(this->cellsOfPoint().size());
  for (Index e = 0; e < this->edges.triangles.size(); ++e)
  {
    this->atEdge.push_back(this->edges.triangles[e].size());
    this->joinAtEdge(e);
  }
  for (Index p = 0; p < this->cellsOfPoint().size(); ++p)
  {
    this->atPoint.push_back(this->cellsOfPoint()[p].size());
    this->euler += this->atPoint[p] > 0;
    this->joinAtPoint(p);
  }
  // A dangling edge is a cell of its own and an edge of the complex: for the Euler characteristic an edge
  // is there as long as a triangle or a dangling edge uses it.
  this->usesOfEdge = this->atEdge;
  for (const Index e : this->edges.ofDangling)
  {
    ++this->usesOfEdge[e];
  }
  for (const Index uses : this->usesOfEdge)
  {
    this->euler -= uses > 0;
  }
}

void LivingCells::remove(const std::vector<Index>& removed)
{
  for (const Index c : removed)
  {
    const bool isTriangle = c >= this->cells.firstTriangle();
    this->living[c] = 0;
    --this->livingCount;
    this->euler -= isTriangle;
    const auto leaveEdge = [&](Index e) {
      this->euler += --this->usesOfEdge[e] == 0;
      this->atEdge[e] -= isTriangle;
      if (this->atEdge[e] == 2)
      {
        this->changedEdges.push_back(e);
      }
    };
    const auto leavePoint = [&](Index p) {
      --this->atPoint[p];
      this->euler -= this->atPoint[p] == 0;
      if (this->atPoint[p] == 2)
      {
        this->changedPoints.push_back(p);
      }
    };
    forFaces(this->cells, this->edges, c, leaveEdge, leavePoint);
  }
}

// Unions can't be undone, but need not be: cells that are in one group stay connected in the same way as
// long as they live, because a part is only ever removed as a whole.
void LivingCells::join()
{
  for (const Index e : this->changedEdges)
  {
    this->joinAtEdge(e);
  }
  for (const Index p : this->changedPoints)
  {
    this->joinAtPoint(p);
  }
  this->changedEdges.clear();
  this->changedPoints.clear();
}

void LivingCells::joinAtEdge(Index edge)
{
  if (this->atEdge[edge] != 2)
  {
    return;
  }
  Index first = None;
  for (const Index t : this->edges.triangles[edge])
  {
    const Index cell = this->cells.firstTriangle() + t;
    if (this->living[cell])
    {
      this->joinPair(first == None ? cell : first, cell);
      first = cell;
    }
  }
}

void LivingCells::joinPair(Index first, Index second)
{
  if (this->bodyOfCell.empty() || this->bodyOfCell[first] == this->bodyOfCell[second])
  {
    this->groups.unite(first, second);
  }
}

bool LivingCells::isContact(Index edge) const
{
  if (this->atEdge[edge] != 2 || this->bodyOfCell.empty())
  {
    return this->atEdge[edge] > 2;
  }
  Index first = None;
  bool differ = false;
  for (const Index t : this->edges.triangles[edge])
  {
    const Index cell = this->cells.firstTriangle() + t;
    if (this->living[cell])
    {
      differ = first != None && this->bodyOfCell[first] != this->bodyOfCell[cell];
      first = cell;
    }
  }
  return differ;
}

void LivingCells::joinAtPoint(Index point)
{
  if (this->atPoint[point] != 2)
  {
    return;
  }
  Index first = None;
  for (const Index cell : this->cellsOfPoint()[point])
  {
    const bool isDangling = cell >= this->cells.firstEdge() && cell < this->cells.firstTriangle();
    if (isDangling && this->living[cell])
    {
      this->joinPair(first == None ? cell : first, cell);
      first = cell;
    }
  }
}
}
