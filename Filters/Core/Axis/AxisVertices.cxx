// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/AxisVertices.h"

#include "Axis/OutsideCounts.h"
#include "Base/DisjointSets.h"
#include "Base/Frame.h"

#include <utility>

// To make one vertex of several cells contracts what is dual to them. That keeps the topology if the cells
// are an open ball together. Cells on one ball may close a ring around others: samples are on balls up to
// their precision only, so a site that is nobody's sample may be as near. If such a ring were contracted,
// the axis would have a void there.
//
// So a vertex grows from its first cell over cells across facets, as long as what a cell shares with the
// outside of those before it is a disc (the test of Carving.h, the other way round). Cells that are left
// over give further vertices at the same place. VertexMerging joins them and fills the ring.
//
// Each cell is tested once, and again when others around it have joined, in passes; few passes do.
namespace medial
{
namespace
{
/// Cells that are to have one vertex: connected ones on the same ball, or with the same centre.
DisjointSets sameVertex(const SiteTriangulation& sites, const OpenSet& set)
{
  DisjointSets classes(count(set.cells));
  for (Index c = 0; c < count(set.cells); ++c)
  {
    for (const Index n : sites.mesh.neighbors[c])
    {
      if (set.cells[c] && n > c && set.cells[n] &&
        ((sites.onBall[c] != None && sites.onBall[c] == sites.onBall[n]) ||
          (sites.spheres[c].center - sites.spheres[n].center).norm() < coincident))
      {
        classes.unite(c, n);
      }
    }
  }
  return classes;
}

/// Grows one open ball of cells after the other.
class BallGrowth
{
public:
  /// @param classOfCell  cells of different classes are never in one ball
  BallGrowth(const SiteTriangulation& triangulation, DisjointSets& classOfCell)
    : sites(triangulation)
    , classes(classOfCell)
    , firstCell(triangulation.mesh.cells.size(), None)
    , outside(triangulation)
  {
  }

  /// Gives all cells of an open ball that holds `first` their first cell.
  void grow(Index first)
  {
    std::vector<Index>&todo = this->candidates, &later = this->refused;
    this->ball.clear();
    todo.clear();
    later.clear();
    const auto join = [&](Index c) {
      this->firstCell[c] = first;
      this->outside.takeIn(c);
      this->ball.push_back(c);
      for (const Index n : this->sites.mesh.neighbors[c])
      {
        if (n != None && this->firstCell[n] == None &&
          this->classes.find(n) == this->classes.find(c))
        {
          todo.push_back(n);
        }
      }
    };
    join(first);
    for (bool changed = true; changed; std::swap(todo, later))
    {
      changed = false;
      for (std::size_t i = 0; i < todo.size(); ++i)
      {
        const Index c = todo[i];
        if (this->firstCell[c] == None && this->staysBall(c, first))
        {
          join(c);
          changed = true;
        }
        else if (this->firstCell[c] == None)
        {
          later.push_back(c);
        }
      }
      todo.clear();
    }
    for (const Index c : this->ball)
    {
      this->outside.putOut(c);
    }
  }

  Index firstCellOf(Index c) const { return this->firstCell[c]; }

private:
  /// Is the ball that begins with `first` still one with this cell? What the cell shares with the outside
  /// of both must be contractible.
  bool staysBall(Index cell, Index first) const
  {
    int facets = 0;
    for (const Index n : this->sites.mesh.neighbors[cell])
    {
      facets += n == None || this->firstCell[n] != first;
    }
    return this->outside.sharedWithOthers(cell, facets).isContractible();
  }

  const SiteTriangulation& sites;
  DisjointSets& classes;
  std::vector<Index> firstCell;           ///< for each cell that of its ball, or None
  OutsideCounts outside;                  ///< of the ball that grows
  std::vector<Index> ball;                ///< its cells
  std::vector<Index> candidates, refused; ///< cells next to it
};
}

AxisVertices axisVertices(const SiteTriangulation& sites, const OpenSet& set)
{
  DisjointSets classes = sameVertex(sites, set);
  BallGrowth balls(sites, classes);
  AxisVertices result;
  result.ofCell.assign(set.cells.size(), None);
  for (Index c = 0; c < count(set.cells); ++c)
  {
    if (!set.cells[c])
    {
      continue;
    }
    if (balls.firstCellOf(c) == None)
    {
      balls.grow(c);
      result.firstCell.push_back(c);
      result.ball.push_back(None);
    }
    const Index first = balls.firstCellOf(c);
    const Index vertex = first == c ? count(result.firstCell) - 1 : result.ofCell[first];
    result.ofCell[c] = vertex;
    const Index ball = sites.onBall[c];
    if (ball != None && (result.ball[vertex] == None || ball < result.ball[vertex]))
    {
      result.ball[vertex] = ball;
    }
  }
  return result;
}
}
