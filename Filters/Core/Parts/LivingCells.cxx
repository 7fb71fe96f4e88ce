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
  std::vector<Index> open = std::exchange(this->notches, {});
  open.insert(open.end(), this->changedEdges.begin(), this->changedEdges.end());
  this->joinAcross(std::move(open));
  for (const Index p : this->changedPoints)
  {
    this->joinAtPoint(p);
  }
  this->changedEdges.clear();
  this->changedPoints.clear();
}

std::array<Index, 2> LivingCells::trianglesOf(Index edge) const
{
  std::array<Index, 2> result{ None, None };
  for (const Index t : this->edges.triangles[edge])
  {
    const Index cell = this->cells.firstTriangle() + t;
    if (this->living[cell])
    {
      result[result[0] == None ? 0 : 1] = cell;
    }
  }
  return result;
}

void LivingCells::joinAtEdge(Index edge)
{
  if (this->atEdge[edge] == 2)
  {
    const auto [first, second] = this->trianglesOf(edge);
    this->joinPair(first, second);
  }
}

void LivingCells::keepOpen(std::vector<Index>& edges, PairLengths& lengths)
{
  const auto isSettled = [&](Index e) {
    if (this->atEdge[e] != 2)
    {
      return true;
    }
    const auto [first, second] = this->trianglesOf(e);
    const std::array pair{ this->groups.find(first), this->groups.find(second) };
    if (pair[0] == pair[1] || !this->mayJoin(first, second))
    {
      return true;
    }
    ++lengths[{ std::min(pair[0], pair[1]), std::max(pair[0], pair[1]) }].open;
    return false;
  };
  edges.erase(std::remove_if(edges.begin(), edges.end(), isSettled), edges.end());
}

void LivingCells::groupsAtEdge(Index edge, std::vector<Index>& result)
{
  result.clear();
  for (const Index t : this->edges.triangles[edge])
  {
    const Index cell = this->cells.firstTriangle() + t;
    if (this->living[cell])
    {
      result.push_back(this->groups.find(cell));
    }
  }
  sortUnique(result);
}

void LivingCells::addSeams(PairLengths& lengths)
{
  std::vector<Index> met;
  for (Index e = 0; e < count(this->atEdge); ++e)
  {
    if (this->atEdge[e] <= 2)
    {
      continue;
    }
    this->groupsAtEdge(e, met);
    for (std::size_t i = 0; i < met.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        const auto pair = lengths.find({ met[j], met[i] });
        if (pair != lengths.end())
        {
          ++pair->second.seam;
        }
      }
    }
  }
}

void LivingCells::joinAcross(std::vector<Index> edges)
{
  constexpr double isShort =
    0.1; // of the seam; measured on boxes, where notches are a few hundredths
  for (bool joined = true; joined;)
  {
    PairLengths lengths;
    this->keepOpen(edges, lengths);
    joined = false;
    if (!edges.empty())
    {
      this->addSeams(lengths);
    }
    for (const auto& [pair, length] : lengths)
    {
      if (length.open >= isShort * length.seam)
      {
        joined = this->groups.unite(pair[0], pair[1]) || joined;
      }
    }
  }
  sortUnique(edges);
  this->notches = std::move(edges);
}

std::vector<LivingCells::GroupSize> LivingCells::groupSizes()
{
  std::vector<GroupSize> result(this->living.size());
  for (Index cell = this->cells.firstTriangle(); cell < this->cells.size(); ++cell)
  {
    if (!this->living[cell])
    {
      continue;
    }
    GroupSize& own = result[this->groups.find(cell)];
    ++own.triangles;
    for (const Index e : this->edges.ofTriangle[cell - this->cells.firstTriangle()])
    {
      own.freeEdges += this->atEdge[e] == 1;
      own.contactEdges += this->isContact(e);
    }
  }
  return result;
}

bool LivingCells::joinScraps()
{
  const std::vector<GroupSize> sizes = this->groupSizes();
  const auto isScrap = [&sizes](Index group) {
    return sizes[group].freeEdges == 0 && sizes[group].triangles <= sizes[group].contactEdges;
  };
  std::map<std::array<Index, 2>, Index> contacts; // a scrap, a neighbor; in edges
  std::vector<Index> met;
  for (Index e = 0; e < count(this->atEdge); ++e)
  {
    if (!this->isContact(e))
    {
      continue;
    }
    this->groupsAtEdge(e, met);
    for (const Index scrap : met)
    {
      for (const Index other : met)
      {
        if (isScrap(scrap) && !isScrap(other) && this->mayJoin(scrap, other))
        {
          ++contacts[{ scrap, other }];
        }
      }
    }
  }
  Index last = None;
  for (const auto& [pair, length] : contacts)
  {
    const auto [scrap, neighbor] = pair;
    if (scrap != last && length == sizes[scrap].contactEdges)
    {
      this->groups.unite(scrap, neighbor);
      last = scrap; // to one neighbor only
    }
  }
  return last != None;
}

bool LivingCells::mayJoin(Index first, Index second) const
{
  return this->bodyOfCell.empty() || this->bodyOfCell[first] == this->bodyOfCell[second];
}

void LivingCells::joinPair(Index first, Index second)
{
  if (this->mayJoin(first, second))
  {
    this->groups.unite(first, second);
  }
}

bool LivingCells::isContact(Index edge) const
{
  if (this->atEdge[edge] != 2)
  {
    return this->atEdge[edge] > 2;
  }
  if (std::binary_search(this->notches.begin(), this->notches.end(), edge))
  {
    return true;
  }
  if (this->bodyOfCell.empty())
  {
    return false;
  }
  const auto [first, second] = this->trianglesOf(edge);
  return !this->mayJoin(first, second);
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
