// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/ShapeCollapse.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <queue>

// A triangle of one tetrahedron alone is free. Removing it together with the tetrahedron is a collapse,
// which keeps the topology and may free other triangles of the neighbours. A priority queue takes the
// largest free triangle first. Each solid piece has a free triangle as long as it has a tetrahedron, so
// none is left in the end.
//
// For n tetrahedra this takes O(n log n) time: each is offered at most once for each of its triangles and
// neighbours. Entries of the queue may be out of date; the cell is then gone.

namespace medial
{
namespace
{
/// The tetrahedra of the shape that are still there, and the triangles that went with one.
class Collapse
{
public:
  Collapse(const PolarBalls& balls, const PowerShape& powerShape)
    : polarBalls(balls)
    , shape(powerShape)
    , living(powerShape.contains)
    , goneFacets(powerShape.contains.size(), 0)
  {
  }

  void run()
  {
    for (Index c = 0; c < count(this->living); ++c)
    {
      this->offer(c);
    }
    while (!this->queue.empty())
    {
      const Candidate next = this->queue.top();
      this->queue.pop();
      if (this->living[next.cell])
      {
        this->remove(next.cell, next.facet);
      }
    }
  }

  /// The triangles of the shape that are left.
  std::vector<Triangle> triangles() const
  {
    std::vector<Triangle> result;
    const Tetrahedra& mesh = this->shape.triangulation;
    for (Index c = 0; c < count(mesh.cells); ++c)
    {
      for (int i = 0; i < 4; ++i)
      {
        const Triangle t = facet(mesh.cells[c], i);
        const Index n = mesh.neighbors[c][i];
        const bool inner = std::all_of(
          t.begin(), t.end(), [&](Index b) { return this->polarBalls.sides[b] == Side::Inner; });
        if (inner && (n == None || n > c) && !this->isGone(c, i) &&
          (n == None || !this->isGone(n, this->sideTowards(n, c))))
        {
          result.push_back(t);
        }
      }
    }
    return result;
  }

private:
  struct Candidate
  {
    double area; ///< large free triangles go first: thin slivers then leave their long sides
    Index cell;
    int facet;
    bool operator<(const Candidate& other) const
    {
      return this->area != other.area
        ? this->area < other.area
        : std::make_pair(this->cell, this->facet) > std::make_pair(other.cell, other.facet);
    }
  };

  bool isGone(Index cell, int i) const { return this->goneFacets[cell] >> i & 1; }

  int sideTowards(Index cell, Index neighbor) const
  {
    const Tetrahedron& n = this->shape.triangulation.neighbors[cell];
    return static_cast<int>(std::find(n.begin(), n.end(), neighbor) - n.begin());
  }

  /// Offers a cell for removal through each triangle that no other living cell has.
  void offer(Index c)
  {
    for (int i = 0; i < 4 && this->living[c]; ++i)
    {
      const Index n = this->shape.triangulation.neighbors[c][i];
      const bool free = n == None || !this->living[n];
      const bool gone =
        this->isGone(c, i) || (n != None && this->isGone(n, this->sideTowards(n, c)));
      if (free && !gone)
      {
        const Triangle t = facet(this->shape.triangulation.cells[c], i);
        const Point& a = this->polarBalls.balls[t[0]].center;
        const Point u = this->polarBalls.balls[t[1]].center - a;
        const Point v = this->polarBalls.balls[t[2]].center - a;
        this->queue.push({ u.cross(v).squaredNorm(), c, i });
      }
    }
  }

  void remove(Index c, int i)
  {
    this->living[c] = 0;
    this->goneFacets[c] |= 1 << i;
    for (const Index n : this->shape.triangulation.neighbors[c])
    {
      if (n != None)
      {
        this->offer(n);
      }
    }
  }

  const PolarBalls& polarBalls;
  const PowerShape& shape;
  std::vector<char> living;
  std::vector<char> goneFacets; ///< bit i: removed together with this cell, through facet i
  std::priority_queue<Candidate> queue;
};

/// The edges of the shape that are sides of none of the triangles: where the shape is only a curve.
std::vector<Edge> looseEdges(
  const PolarBalls& polarBalls, const PowerShape& shape, const std::vector<Triangle>& triangles)
{
  std::vector<Edge> sides;
  for (const Triangle& t : triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      sides.push_back({ std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]) });
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<Edge> result;
  const auto isInner = [&](Index b) { return polarBalls.sides[b] == Side::Inner; };
  for (const Edge& edge : edgeNumbers(shape.triangulation.cells, count(polarBalls.balls)).edges)
  {
    if (isInner(edge[0]) && isInner(edge[1]) &&
      !std::binary_search(sides.begin(), sides.end(), edge))
    {
      result.push_back(edge);
    }
  }
  return result;
}
}

AxisComplex collapsedShape(const PolarBalls& polarBalls, const PowerShape& shape)
{
  Collapse collapse(polarBalls, shape);
  collapse.run();
  AxisComplex axis{};
  axis.cells.triangles = collapse.triangles();
  axis.cells.edges = looseEdges(polarBalls, shape, axis.cells.triangles);
  std::vector<Index> pointOfBall(polarBalls.balls.size(), None);
  for (Index b = 0; b < count(polarBalls.balls); ++b)
  {
    if (polarBalls.sides[b] == Side::Inner)
    {
      pointOfBall[b] = count(axis.points);
      axis.points.push_back(polarBalls.balls[b].center);
      axis.radii.push_back(polarBalls.balls[b].radius);
      axis.ballOfPoint.push_back(b);
    }
  }
  std::vector<char> used(axis.points.size(), 0);
  const auto renumber = [&](auto& cells) {
    for (auto& cell : cells)
    {
      for (Index& b : cell)
      {
        b = pointOfBall[b];
        used[b] = 1;
      }
    }
  };
  renumber(axis.cells.triangles);
  renumber(axis.cells.edges);
  for (Index p = 0; p < count(used); ++p)
  {
    if (!used[p])
    {
      axis.cells.vertices.push_back(p);
    }
  }
  const Index lower = axis.cells.firstTriangle();
  axis.polygonOfCell.assign(lower, None);
  axis.polygonOfCell.resize(axis.cells.size());
  std::iota(axis.polygonOfCell.begin() + lower, axis.polygonOfCell.end(), 0);
  axis.samplesOfCell.assign(axis.cells.size(), { None, None });
  for (Index cell = 0; cell < axis.cells.size(); ++cell)
  {
    axis.siteViews.push_back(siteView(cornerBalls(axis, cell)));
  }
  return axis;
}
}
