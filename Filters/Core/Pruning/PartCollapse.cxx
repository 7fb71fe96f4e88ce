// SPDX-License-Identifier: BSD-3-Clause
#include "Pruning/PartCollapse.h"

#include <algorithm>

namespace medial
{
PartCollapse::PartCollapse(const LivingCells& livingCells)
  : living(livingCells)
  , edges(livingCells.edges.points.size())
  , points(livingCells.cellsOfPoint().size())
{
}

void PartCollapse::enter(const std::vector<Index>& unit)
{
  const AxisCells& cells = this->living.cells;
  for (const Index c : unit)
  {
    const bool isTriangle = c >= cells.firstTriangle();
    const auto onEdge = [&](Index e) {
      Face& edge = this->edges[e];
      if (edge.state == State::NotHere)
      {
        edge.state = State::Free;
        this->ownEdges.push_back(e);
      }
      if (isTriangle)
      {
        edge.add(c - cells.firstTriangle());
      }
    };
    const auto onPoint = [&](Index p) {
      Face& point = this->points[p];
      if (point.state == State::NotHere)
      {
        point.state = State::Free;
        this->ownPoints.push_back(p);
      }
      ++point.count; // of cells, until the states are known; then of edges
    };
    forFaces(cells, this->living.edges, c, onEdge, onPoint);
  }
  // An edge or a point with more living cells than the unit has there belongs to the rest, too.
  for (const Index p : this->ownPoints)
  {
    Face& point = this->points[p];
    point.state = this->living.cellsAtPoint(p) > point.count ? State::Fixed : State::Free;
    point.count = 0;
  }
  for (const Index e : this->ownEdges)
  {
    Face& edge = this->edges[e];
    edge.state = this->living.trianglesAtEdge(e) > edge.count ? State::Fixed : State::Free;
    for (const Index p : this->living.edges.points[e])
    {
      this->points[p].add(e);
    }
  }
}

void PartCollapse::leave()
{
  for (const Index e : this->ownEdges)
  {
    this->edges[e] = {};
  }
  for (const Index p : this->ownPoints)
  {
    this->points[p] = {};
  }
  this->ownEdges.clear();
  this->ownPoints.clear();
}

bool PartCollapse::hasContact() const
{
  return std::any_of(this->ownPoints.begin(), this->ownPoints.end(),
    [this](Index p) { return this->points[p].state == State::Fixed; });
}

void PartCollapse::takeFromPoints(Index edge)
{
  this->edges[edge].state = State::Gone;
  for (const Index p : this->living.edges.points[edge])
  {
    this->points[p].take(edge);
  }
}

bool PartCollapse::collapseTriangles(Index triangleCount)
{
  Index left = triangleCount;
  std::vector<Index> todo;
  const auto offer = [&](Index e) {
    if (this->edges[e].count == 1 && this->edges[e].state == State::Free)
    {
      todo.push_back(e);
    }
  };
  std::for_each(this->ownEdges.begin(), this->ownEdges.end(), offer);
  while (!todo.empty())
  {
    const Index edge = todo.back();
    todo.pop_back();
    if (this->edges[edge].count != 1)
    {
      continue; // its last triangle was collapsed through another edge
    }
    const Index triangle = this->edges[edge].numbers;
    --left;
    this->takeFromPoints(edge);
    for (const Index e : this->living.edges.ofTriangle[triangle])
    {
      this->edges[e].take(triangle);
      offer(e);
    }
  }
  return left == 0;
}

bool PartCollapse::collapseEdges()
{
  std::vector<Index> todo;
  const auto offer = [&](Index p) {
    if (this->points[p].count == 1 && this->points[p].state == State::Free)
    {
      todo.push_back(p);
    }
  };
  std::for_each(this->ownPoints.begin(), this->ownPoints.end(), offer);
  while (!todo.empty())
  {
    const Index point = todo.back();
    todo.pop_back();
    if (this->points[point].count != 1)
    {
      continue; // its last edge was collapsed through the other end
    }
    const Index edge = this->points[point].numbers;
    this->points[point].state = State::Gone;
    this->takeFromPoints(edge);
    const Edge& ends = this->living.edges.points[edge];
    std::for_each(ends.begin(), ends.end(), offer);
  }
  return std::none_of(this->ownEdges.begin(), this->ownEdges.end(),
           [this](Index e) { return this->edges[e].state == State::Free; }) &&
    std::none_of(this->ownPoints.begin(), this->ownPoints.end(),
      [this](Index p) { return this->points[p].state == State::Free; });
}

PartCollapse::Effect PartCollapse::effectOfRemoving(const std::vector<Index>& unit)
{
  this->enter(unit);
  const Index first = this->living.cells.firstTriangle();
  const auto triangleCount =
    std::count_if(unit.begin(), unit.end(), [first](Index c) { return c >= first; });
  Effect effect = Effect::Isolated;
  if (this->hasContact())
  {
    effect = this->collapseTriangles(static_cast<Index>(triangleCount)) && this->collapseEdges()
      ? Effect::None
      : Effect::Changes;
  }
  this->leave();
  return effect;
}
}
