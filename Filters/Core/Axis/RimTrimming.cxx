// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/RimTrimming.h"

#include "Axis/AxisEdges.h"
#include "Axis/RimTips.h"
#include "Base/Lists.h"

#include <algorithm>
#include <array>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{
template <typename Entry>
using Queue = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

/// What is left at a point.
struct Uses
{
  Index edges = 0, triangles = 0;
  Index numbers = 0; ///< of the edges; the number where there is one
};

double largestRadius(const AxisComplex& axis, const Triangle& corners)
{
  const auto& [a, b, c] = corners;
  return std::max({ axis.radii[a], axis.radii[b], axis.radii[c] });
}

/// Triangles go with a free edge each, as the fire comes: so what is left of a narrow sheet is in its middle. An edge
/// that is left of one at a tip goes at once.
class TriangleTrimming
{
public:
  TriangleTrimming(const AxisComplex& theAxis, const Erosion& theErosion,
    const std::vector<double>& theSpacings, double theTrim, RimTips& theTips)
    : axis(theAxis)
    , erosion(theErosion)
    , spacings(theSpacings)
    , trim(theTrim)
    , tips(theTips)
    , edges(axisEdges(theAxis.cells))
    , isLeft(theAxis.cells.triangles.size(), 1)
    , isThere(this->edges.points.size(), 1)
    , lastAtEdge(this->edges.points.size(), None)
  {
    this->atPoint.resize(theAxis.points.size());
    for (Index e = 0; e < count(this->edges.points); ++e)
    {
      this->atEdge.push_back(this->edges.triangles[e].size());
      this->offer(e);
      for (const Index p : this->edges.points[e])
      {
        ++this->atPoint[p].edges;
        this->atPoint[p].numbers ^= e;
      }
    }
    for (const Triangle& corners : theAxis.cells.triangles)
    {
      for (const Index p : corners)
      {
        ++this->atPoint[p].triangles;
      }
    }
  }

  void run()
  {
    while (!this->queue.empty())
    {
      const Index edge = std::get<Index>(this->queue.top());
      this->queue.pop();
      if (this->atEdge[edge] == 1) // else its last triangle has gone with another edge
      {
        this->take(edge, this->onlyTriangle(edge));
      }
    }
  }

  /// The axis with what is left, on all points, and how thick each of its dangling edges may be that goes.
  std::pair<AxisComplex, std::vector<double>> rest() const
  {
    AxisComplex result;
    result.points = this->axis.points;
    result.radii = this->axis.radii;
    result.ballOfPoint = this->axis.ballOfPoint;
    std::vector<double> mostOfLines;
    const AxisCells& cells = this->axis.cells;
    result.cells.vertices = cells.vertices;
    result.cells.edges = cells.edges;
    for (Index c = 0; c < cells.firstTriangle(); ++c)
    {
      appendCellData(this->axis, c, result);
    }
    for (Index c = cells.firstEdge(); c < cells.firstTriangle(); ++c)
    {
      mostOfLines.push_back(this->trim * this->spacings[c]);
    }
    for (Index e = 0; e < count(this->edges.points); ++e)
    {
      if (this->lastAtEdge[e] != None && this->isThere[e] && this->atEdge[e] == 0)
      {
        const Index line = result.cells.firstTriangle();
        result.cells.edges.push_back(this->edges.points[e]);
        result.polygonOfCell.push_back(None);
        result.samplesOfCell.push_back({ None, None });
        result.siteViews.push_back(siteView(cornerBalls(result, line)));
        mostOfLines.push_back(this->mostOf(this->lastAtEdge[e]));
      }
    }
    for (Index t = 0; t < count(cells.triangles); ++t)
    {
      if (this->isLeft[t])
      {
        result.cells.triangles.push_back(cells.triangles[t]);
        appendCellData(this->axis, cells.firstTriangle() + t, result);
      }
    }
    return { std::move(result), std::move(mostOfLines) };
  }

private:
  Index onlyTriangle(Index edge) const
  {
    const auto at = this->edges.triangles[edge];
    return *std::find_if(at.begin(), at.end(), [&](Index t) { return this->isLeft[t] != 0; });
  }

  /// How thick a line may be that is left of a cell.
  double mostOf(Index cell) const { return std::max(this->trim, 1.0) * this->spacings[cell]; }

  void offer(Index edge)
  {
    if (this->atEdge[edge] == 1)
    {
      const Index cell = this->axis.cells.firstTriangle() + this->onlyTriangle(edge);
      const double burnt = this->erosion.ofCell[cell];
      if (burnt <= this->trim * this->spacings[cell])
      {
        const Index triangle = cell - this->axis.cells.firstTriangle();
        this->queue.push({ burnt + largestRadius(this->axis, this->axis.cells.triangles[triangle]),
          this->timeOf(this->edges.points[edge]), edge });
      }
    }
  }

  /// Of several free edges of a triangle the one that burns first goes.
  double timeOf(const Edge& ends) const
  {
    const auto time = [this](Index p) { return this->erosion.ofPoint[p] + this->axis.radii[p]; };
    return std::max(time(ends[0]), time(ends[1]));
  }

  void take(Index edge, Index triangle)
  {
    const Triangle& corners = this->axis.cells.triangles[triangle];
    this->isLeft[triangle] = 0;
    this->takeEdge(edge);
    for (const Index e : this->edges.ofTriangle[triangle])
    {
      --this->atEdge[e];
      this->lastAtEdge[e] = this->axis.cells.firstTriangle() + triangle;
      this->offer(e);
    }
    for (const Index p : corners)
    {
      --this->atPoint[p].triangles;
    }
    std::for_each(corners.begin(), corners.end(), [&](Index p) { this->takeTip(p); });
  }

  void takeEdge(Index edge)
  {
    this->isThere[edge] = 0;
    for (const Index p : this->edges.points[edge])
    {
      --this->atPoint[p].edges;
      this->atPoint[p].numbers ^= edge;
    }
  }

  void takeTip(Index point)
  {
    const Uses& tip = this->atPoint[point];
    if (tip.edges != 1 || tip.triangles > 0 || this->lastAtEdge[tip.numbers] == None)
    {
      return;
    }
    const auto [a, b] = this->edges.points[tip.numbers];
    const Index to = a == point ? b : a;
    if (this->atPoint[to].triangles > 0 &&
      this->tips.mayGoFromSheet(point, to, this->mostOf(this->lastAtEdge[tip.numbers])))
    {
      this->tips.go(point, to);
      this->takeEdge(tip.numbers);
    }
  }

  const AxisComplex& axis;
  const Erosion& erosion;
  const std::vector<double>& spacings;
  double trim;
  RimTips& tips;
  AxisEdges edges;
  std::vector<char> isLeft;      ///< for each triangle
  std::vector<char> isThere;     ///< for each edge
  std::vector<Index> atEdge;     ///< triangles that are left
  std::vector<Index> lastAtEdge; ///< the last cell that has gone there
  std::vector<Uses> atPoint;
  Queue<std::tuple<double, double, Index>>
    queue; ///< of free edges: when their triangle has burnt, and they
};

/// Dangling edges go with a free end each, as the fire comes.
class LineTrimming
{
public:
  /// @param mostOfLines  for each dangling edge how thick it may be
  /// @param uses         for each point how many cells have it; those of what goes are taken off
  LineTrimming(const AxisComplex& theAxis, const std::vector<double>& mostOfLines, RimTips& theTips,
    std::vector<Index>& uses)
    : axis(theAxis)
    , most(mostOfLines)
    , tips(theTips)
    , usesOfPoint(uses)
    , linesAtPoint(listsByKey(count(uses),
        [&](const auto& add) {
          for (Index i = 0; i < count(theAxis.cells.edges); ++i)
          {
            add(theAxis.cells.edges[i][0], i);
            add(theAxis.cells.edges[i][1], i);
          }
        }))
    , isLeft(theAxis.cells.edges.size(), 1)
  {
  }

  /// @return  for each dangling edge: does it stay?
  std::vector<char> run()
  {
    for (Index p = 0; p < count(this->usesOfPoint); ++p)
    {
      this->offer(p);
    }
    while (!this->queue.empty())
    {
      const Index from = this->queue.top().second, line = this->onlyLine(from);
      this->queue.pop();
      if (line != None && this->mayGo(line, from))
      {
        this->take(line, from);
      }
    }
    return this->isLeft;
  }

private:
  /// The line at a free end, unless it is the last of its piece.
  Index onlyLine(Index point) const
  {
    if (this->usesOfPoint[point] != 1)
    {
      return None;
    }
    const auto at = this->linesAtPoint[point];
    const auto line =
      std::find_if(at.begin(), at.end(), [&](Index i) { return this->isLeft[i] != 0; });
    return line == at.end() || this->usesOfPoint[this->other(*line, point)] == 1 ? None : *line;
  }

  Index other(Index line, Index end) const
  {
    const Edge& ends = this->axis.cells.edges[line];
    return ends[0] == end ? ends[1] : ends[0];
  }

  bool mayGo(Index line, Index from) const
  {
    return this->tips.mayGo(from, this->other(line, from), this->most[line]);
  }

  void offer(Index point)
  {
    const Index line = this->onlyLine(point);
    if (line != None && this->mayGo(line, point))
    {
      this->queue.push({ this->tips.thickness(point, this->other(line, point)), point });
    }
  }

  void take(Index line, Index from)
  {
    const Index to = this->other(line, from);
    this->isLeft[line] = 0;
    --this->usesOfPoint[from];
    --this->usesOfPoint[to];
    this->tips.go(from, to);
    this->offer(to);
  }

  const AxisComplex& axis;
  const std::vector<double>& most;
  RimTips& tips;
  std::vector<Index>& usesOfPoint;
  IndexLists linesAtPoint;
  std::vector<char> isLeft;
  Queue<std::pair<double, Index>> queue; ///< of free ends: the thickness at the other end
};

/// The axis without some lines, and without the points that no cell has.
AxisComplex compact(const AxisComplex& axis, const std::vector<char>& isLineLeft,
  const std::vector<Index>& usesOfPoint)
{
  AxisComplex result;
  std::vector<Index> number(axis.points.size(), None);
  for (Index p = 0; p < count(axis.points); ++p)
  {
    if (usesOfPoint[p] > 0)
    {
      number[p] = count(result.points);
      result.points.push_back(axis.points[p]);
      result.radii.push_back(axis.radii[p]);
      result.ballOfPoint.push_back(axis.ballOfPoint[p]);
    }
  }
  const AxisCells& cells = axis.cells;
  for (Index v = 0; v < count(cells.vertices); ++v)
  {
    result.cells.vertices.push_back(number[cells.vertices[v]]);
    appendCellData(axis, v, result);
  }
  for (Index i = 0; i < count(cells.edges); ++i)
  {
    if (isLineLeft[i])
    {
      result.cells.edges.push_back({ number[cells.edges[i][0]], number[cells.edges[i][1]] });
      appendCellData(axis, cells.firstEdge() + i, result);
    }
  }
  for (Index t = 0; t < count(cells.triangles); ++t)
  {
    const auto& [a, b, c] = cells.triangles[t];
    result.cells.triangles.push_back({ number[a], number[b], number[c] });
    appendCellData(axis, cells.firstTriangle() + t, result);
  }
  return result;
}
}

AxisComplex trimmedRims(const AxisComplex& axis, const Erosion& erosion,
  const std::vector<double>& spacings, double trim, const Execution& execution)
{
  RimTips tips(axis);
  TriangleTrimming triangles(axis, erosion, spacings, trim, tips);
  triangles.run();
  execution.poll();
  const auto [rest, mostOfLines] = triangles.rest();
  std::vector<Index> usesOfPoint(rest.points.size(), 0);
  for (Index c = 0; c < rest.cells.size(); ++c)
  {
    forPoints(rest.cells, c, [&uses = usesOfPoint](Index p) { ++uses[p]; });
  }
  const std::vector<char> isLineLeft = LineTrimming(rest, mostOfLines, tips, usesOfPoint).run();
  return compact(rest, isLineLeft, usesOfPoint);
}
}
