// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/Elements.h"

#include "Measuring/PointVolumes.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <limits>

namespace medial
{
namespace
{
/// Sums of a set of segments and triangles.
struct Moments
{
  double size = 0;
  Point first = Point::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

  /// A simplex's corners stand for it: its second moments are those of its corners and its centroid, with
  /// these weights.
  template <std::size_t Corners>
  void add(const MedialAxis& axis, const std::array<Index, Corners>& corners, double newSize,
    const Point& origin)
  {
    constexpr double n = Corners;
    Point sum = Point::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const Index p : corners)
    {
      const Point x = axis.points[p] - origin;
      sum += x;
      squares += x * x.transpose();
    }
    this->size += newSize;
    this->first += newSize / n * sum;
    this->second += newSize / (n * (n + 1)) * (squares + sum * sum.transpose());
  }
};

/// The direction with the least (plate) or largest (rod) spread, in the sense of Element::direction.
Point direction(const Moments& moments, bool least)
{
  const Point mean = moments.first / moments.size;
  const Eigen::Matrix3d spread = moments.second / moments.size - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Point axis = solver.eigenvectors().col(least ? 0 : 2);
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  return axis[largest] < 0 ? Point(-axis) : axis;
}

void addThickness(
  const MedialAxis& axis, const IndexLists& elementsOfPoint, std::vector<Element>& elements)
{
  const std::vector<double> volumes = pointVolumes(axis);
  std::vector<double> plain(elements.size(), 0), number(elements.size(), 0);
  for (Element& element : elements)
  {
    element.volume = element.meanThickness = element.largestThickness = 0;
    element.leastThickness = std::numeric_limits<double>::max();
  }
  for (Index p = 0; p < elementsOfPoint.size(); ++p)
  {
    const double diameter = 2 * axis.radii[p];
    for (const Index e : elementsOfPoint[p])
    {
      Element& element = elements[e];
      const double volume = volumes[p] / elementsOfPoint[p].size();
      element.volume += volume;
      element.meanThickness += volume * diameter;
      element.leastThickness = std::min(element.leastThickness, diameter);
      element.largestThickness = std::max(element.largestThickness, diameter);
      plain[e] += diameter;
      number[e] += 1;
    }
  }
  for (Index e = 0; e < count(elements); ++e)
  {
    Element& element = elements[e];
    element.meanThickness = element.volume > 0 ? element.meanThickness / element.volume
                                               : plain[e] / std::max(1., number[e]);
    element.leastThickness = std::min(element.leastThickness, element.largestThickness);
  }
}
}

void measure(const MedialAxis& axis, const IndexLists& elementsOfPoint,
  const std::vector<Index>& elementOfCell, const std::vector<char>& isFin,
  std::vector<Element>& elements)
{
  addThickness(axis, elementsOfPoint, elements);
  const Index none = None;
  std::vector<Index> start(elements.size(), none); // a point of each, so that sums stay exact
  std::vector<Moments> lines(elements.size()), sheets(elements.size());
  const AxisCells& cells = axis.cells;
  for (Index cell = 0; cell < cells.size(); ++cell)
  {
    const Index e = elementOfCell[cell];
    if (e == None)
    {
      continue;
    }
    forPoints(cells, cell, [&](Index p) { start[e] = start[e] == None ? p : start[e]; });
    const Point& origin = axis.points[start[e]];
    if (cell >= cells.firstTriangle())
    {
      const Index t = cell - cells.firstTriangle();
      const double area = triangleArea(axis, cells.triangles[t]);
      elements[e].area += elements[e].isPlate && !isFin[t] ? area : 0;
      // A rod's sheets count as strips as wide as the rod is thick.
      const double width = elements[e].isPlate ? 1 : elements[e].meanThickness;
      sheets[e].add(axis, cells.triangles[t], width > 0 ? area / width : 0, origin);
    }
    else if (cell >= cells.firstEdge())
    {
      const Edge& ends = cells.edges[cell - cells.firstEdge()];
      lines[e].add(axis, ends, (axis.points[ends[0]] - axis.points[ends[1]]).norm(), origin);
    }
  }
  for (Index e = 0; e < count(elements); ++e)
  {
    Moments& moments = sheets[e];
    if (!elements[e].isPlate)
    {
      moments.size += lines[e].size;
      moments.first += lines[e].first;
      moments.second += lines[e].second;
    }
    elements[e].centroid = start[e] == None ? Point(Point::Zero()) : axis.points[start[e]];
    if (moments.size > 0)
    {
      elements[e].centroid += moments.first / moments.size;
      elements[e].direction = direction(moments, elements[e].isPlate);
    }
  }
}
}
