// SPDX-License-Identifier: BSD-3-Clause
#include "PartCollapse.h"

#include <algorithm>

namespace medial
{
namespace
{
/// Calls onEdge(edge) and onPoint(point) for what a cell uses.
template <typename OnEdge, typename OnPoint>
void forFaces(const AxisCells& cells, const AxisEdges& edges, Index cell, const OnEdge& onEdge,
  const OnPoint& onPoint)
{
  if (cell >= cells.firstTriangle())
  {
    const Index t = cell - cells.firstTriangle();
    for (int k = 0; k < 3; ++k)
    {
      onEdge(edges.ofTriangle[t][k]);
      onPoint(cells.triangles[t][k]);
    }
  }
  else if (cell >= cells.firstEdge())
  {
    const Index e = cell - cells.firstEdge();
    onEdge(edges.ofDangling[e]);
    onPoint(cells.edges[e][0]);
    onPoint(cells.edges[e][1]);
  }
  else
  {
    onPoint(cells.vertices[cell]);
  }
}
}

/// Some cells with numbers of their own, and how far they have collapsed.
struct LivingCells::Unit
{
  struct UnitEdge
  {
    Edge points;                  ///< local
    std::vector<Index> triangles; ///< local, at it
    Index uses = 0;               ///< triangles that are still there
    bool fixed = false;           ///< other living cells have it
    bool gone = false;
  };
  struct UnitPoint
  {
    std::vector<Index> edges; ///< local, at it
    Index degree = 0;         ///< edges that are still there
    Index uses = 0;           ///< cells of the unit
    bool fixed = false;
    bool gone = false;
  };
  std::vector<UnitEdge> edges;
  std::vector<UnitPoint> points;
  std::vector<Triangle> triangles; ///< local edges
  Index trianglesLeft = 0;
  bool hasContact = false;
};

LivingCells::LivingCells(const AxisCells& cells, const AxisEdges& edges)
  : axisCells(cells)
  , axisEdges(edges)
  , living(cells.size(), 1)
  , livingCount(cells.size())
  , trianglesAtEdge(edges.points.size(), 0)
  , localEdge(edges.points.size(), None)
{
  Index highest = None;
  const auto nothing = [](Index) {};
  for (Index c = 0; c < cells.size(); ++c)
  {
    forFaces(cells, edges, c, nothing, [&](Index p) { highest = std::max(highest, p); });
  }
  this->cellsAtPoint.assign(highest + 1, 0);
  this->localPoint.assign(highest + 1, None);
  for (Index c = 0; c < cells.size(); ++c)
  {
    const bool isTriangle = c >= cells.firstTriangle();
    forFaces(
      cells, edges, c, [&](Index e) { this->trianglesAtEdge[e] += isTriangle; },
      [&](Index p) { ++this->cellsAtPoint[p]; });
  }
}

void LivingCells::remove(const std::vector<Index>& cells)
{
  for (const Index c : cells)
  {
    const bool isTriangle = c >= this->axisCells.firstTriangle();
    this->living[c] = 0;
    --this->livingCount;
    forFaces(
      this->axisCells, this->axisEdges, c, [&](Index e) { this->trianglesAtEdge[e] -= isTriangle; },
      [&](Index p) { --this->cellsAtPoint[p]; });
  }
}

LivingCells::Unit LivingCells::unitOf(const std::vector<Index>& cells)
{
  Unit unit;
  std::vector<Index> edges, points;
  const auto number = [](std::vector<Index>& local, std::vector<Index>& all, Index i) {
    if (local[i] == None)
    {
      local[i] = count(all);
      all.push_back(i);
    }
  };
  for (const Index c : cells)
  {
    forFaces(
      this->axisCells, this->axisEdges, c, [&](Index e) { number(this->localEdge, edges, e); },
      [&](Index p) { number(this->localPoint, points, p); });
  }
  unit.edges.resize(edges.size());
  unit.points.resize(points.size());
  for (const Index c : cells)
  {
    const bool isTriangle = c >= this->axisCells.firstTriangle();
    Triangle sides{ None, None, None };
    int k = 0;
    forFaces(
      this->axisCells, this->axisEdges, c,
      [&](Index e) {
        sides[k++] = this->localEdge[e];
        if (isTriangle)
        {
          unit.edges[this->localEdge[e]].triangles.push_back(count(unit.triangles));
        }
      },
      [&](Index p) { ++unit.points[this->localPoint[p]].uses; });
    if (isTriangle)
    {
      unit.triangles.push_back(sides);
    }
  }
  this->findContact(edges, points, unit);
  unit.trianglesLeft = count(unit.triangles);
  return unit;
}

void LivingCells::findContact(
  const std::vector<Index>& edges, const std::vector<Index>& points, Unit& unit)
{
  for (Index e = 0; e < count(edges); ++e)
  {
    Unit::UnitEdge& edge = unit.edges[e];
    edge.uses = count(edge.triangles);
    edge.fixed = this->trianglesAtEdge[edges[e]] > edge.uses;
    for (int k = 0; k < 2; ++k)
    {
      edge.points[k] = this->localPoint[this->axisEdges.points[edges[e]][k]];
      unit.points[edge.points[k]].edges.push_back(e);
      ++unit.points[edge.points[k]].degree;
    }
    this->localEdge[edges[e]] = None;
  }
  for (Index p = 0; p < count(points); ++p)
  {
    unit.points[p].fixed = this->cellsAtPoint[points[p]] > unit.points[p].uses;
    unit.hasContact = unit.hasContact || unit.points[p].fixed;
    this->localPoint[points[p]] = None;
  }
}

void LivingCells::collapseTriangles(Unit& unit) const
{
  std::vector<Index> todo;
  const auto offer = [&](Index e) {
    if (unit.edges[e].uses == 1 && !unit.edges[e].fixed)
    {
      todo.push_back(e);
    }
  };
  for (Index e = 0; e < count(unit.edges); ++e)
  {
    offer(e);
  }
  std::vector<char> gone(unit.triangles.size(), 0);
  while (!todo.empty())
  {
    Unit::UnitEdge& edge = unit.edges[todo.back()];
    todo.pop_back();
    if (edge.uses != 1)
    {
      continue; // its last triangle went through another edge
    }
    const Index triangle = *std::find_if(
      edge.triangles.begin(), edge.triangles.end(), [&](Index t) { return !gone[t]; });
    gone[triangle] = 1;
    --unit.trianglesLeft;
    edge.gone = true;
    --unit.points[edge.points[0]].degree;
    --unit.points[edge.points[1]].degree;
    for (const Index e : unit.triangles[triangle])
    {
      --unit.edges[e].uses;
      offer(e);
    }
  }
}

bool LivingCells::collapseEdges(Unit& unit) const
{
  std::vector<Index> todo;
  const auto offer = [&](Index p) {
    if (unit.points[p].degree == 1 && !unit.points[p].fixed)
    {
      todo.push_back(p);
    }
  };
  for (Index p = 0; p < count(unit.points); ++p)
  {
    offer(p);
  }
  while (!todo.empty())
  {
    Unit::UnitPoint& point = unit.points[todo.back()];
    todo.pop_back();
    if (point.degree != 1)
    {
      continue;
    }
    const Index e = *std::find_if(
      point.edges.begin(), point.edges.end(), [&](Index i) { return !unit.edges[i].gone; });
    unit.edges[e].gone = true;
    point.gone = true;
    for (const Index p : unit.edges[e].points)
    {
      --unit.points[p].degree;
      offer(p);
    }
  }
  const auto settledEdge = [](const Unit::UnitEdge& e) { return e.fixed || e.gone; };
  const auto settledPoint = [](const Unit::UnitPoint& p) { return p.fixed || p.gone; };
  return std::all_of(unit.edges.begin(), unit.edges.end(), settledEdge) &&
    std::all_of(unit.points.begin(), unit.points.end(), settledPoint);
}

LivingCells::Effect LivingCells::effectOfRemoving(const std::vector<Index>& cells)
{
  Unit unit = this->unitOf(cells);
  if (!unit.hasContact)
  {
    return Effect::Isolated;
  }
  this->collapseTriangles(unit);
  return unit.trianglesLeft == 0 && this->collapseEdges(unit) ? Effect::None : Effect::Changes;
}
}
