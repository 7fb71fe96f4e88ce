// SPDX-License-Identifier: BSD-3-Clause
#include "PartCollapse.h"

#include <algorithm>

namespace medial
{
PartCollapse::PartCollapse(const LivingCells& livingCells)
  : living(livingCells)
  , triangles(livingCells.edges.points.size(), 0)
  , triangleNumbers(livingCells.edges.points.size(), 0)
  , edges(livingCells.cellsOfPoint().size(), 0)
  , edgeNumbers(livingCells.cellsOfPoint().size(), 0)
  , edgeStates(livingCells.edges.points.size(), State::NotHere)
  , pointStates(livingCells.cellsOfPoint().size(), State::NotHere)
{
}

void PartCollapse::enter(const std::vector<Index>& unit)
{
  const AxisCells& cells = this->living.cells;
  for (const Index c : unit)
  {
    const bool isTriangle = c >= cells.firstTriangle();
    const auto onEdge = [&](Index e) {
      if (this->edgeStates[e] == State::NotHere)
      {
        this->edgeStates[e] = State::Free;
        this->ownEdges.push_back(e);
      }
      this->triangles[e] += isTriangle;
      this->triangleNumbers[e] ^= isTriangle ? c - cells.firstTriangle() : 0;
    };
    const auto onPoint = [&](Index p) {
      if (this->pointStates[p] == State::NotHere)
      {
        this->pointStates[p] = State::Free;
        this->ownPoints.push_back(p);
      }
      ++this->edges[p]; // cells, for a start
    };
    forFaces(cells, this->living.edges, c, onEdge, onPoint);
  }
  for (const Index p : this->ownPoints)
  {
    const bool shared = this->living.cellsAtPoint(p) > this->edges[p];
    this->pointStates[p] = shared ? State::Fixed : State::Free;
    this->edges[p] = 0;
  }
  for (const Index e : this->ownEdges)
  {
    const bool shared = this->living.trianglesAtEdge(e) > this->triangles[e];
    this->edgeStates[e] = shared ? State::Fixed : State::Free;
    for (const Index p : this->living.edges.points[e])
    {
      ++this->edges[p];
      this->edgeNumbers[p] ^= e;
    }
  }
}

void PartCollapse::leave()
{
  for (const Index e : this->ownEdges)
  {
    this->edgeStates[e] = State::NotHere;
    this->triangles[e] = this->triangleNumbers[e] = 0;
  }
  for (const Index p : this->ownPoints)
  {
    this->pointStates[p] = State::NotHere;
    this->edges[p] = this->edgeNumbers[p] = 0;
  }
  this->ownEdges.clear();
  this->ownPoints.clear();
}

bool PartCollapse::hasContact() const
{
  return std::any_of(this->ownPoints.begin(), this->ownPoints.end(),
    [this](Index p) { return this->pointStates[p] == State::Fixed; });
}

void PartCollapse::takeFromPoints(Index edge)
{
  this->edgeStates[edge] = State::Gone;
  for (const Index p : this->living.edges.points[edge])
  {
    --this->edges[p];
    this->edgeNumbers[p] ^= edge;
  }
}

bool PartCollapse::collapseTriangles(Index left)
{
  std::vector<Index> todo;
  const auto offer = [&](Index e) {
    if (this->triangles[e] == 1 && this->edgeStates[e] == State::Free)
    {
      todo.push_back(e);
    }
  };
  std::for_each(this->ownEdges.begin(), this->ownEdges.end(), offer);
  while (!todo.empty())
  {
    const Index edge = todo.back();
    todo.pop_back();
    if (this->triangles[edge] != 1)
    {
      continue; // its last triangle went through another edge
    }
    const Index triangle = this->triangleNumbers[edge];
    --left;
    this->takeFromPoints(edge);
    for (const Index e : this->living.edges.ofTriangle[triangle])
    {
      --this->triangles[e];
      this->triangleNumbers[e] ^= triangle;
      offer(e);
    }
  }
  return left == 0;
}

bool PartCollapse::collapseEdges()
{
  std::vector<Index> todo;
  const auto offer = [&](Index p) {
    if (this->edges[p] == 1 && this->pointStates[p] == State::Free)
    {
      todo.push_back(p);
    }
  };
  std::for_each(this->ownPoints.begin(), this->ownPoints.end(), offer);
  while (!todo.empty())
  {
    const Index point = todo.back();
    todo.pop_back();
    if (this->edges[point] != 1)
    {
      continue;
    }
    const Index edge = this->edgeNumbers[point];
    this->pointStates[point] = State::Gone;
    this->takeFromPoints(edge);
    const Edge& ends = this->living.edges.points[edge];
    std::for_each(ends.begin(), ends.end(), offer);
  }
  return std::none_of(this->ownEdges.begin(), this->ownEdges.end(),
           [this](Index e) { return this->edgeStates[e] == State::Free; }) &&
    std::none_of(this->ownPoints.begin(), this->ownPoints.end(),
      [this](Index p) { return this->pointStates[p] == State::Free; });
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
