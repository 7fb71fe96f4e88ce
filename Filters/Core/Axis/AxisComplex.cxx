// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/AxisComplex.h"

#include <Eigen/Geometry>

namespace medial
{
double triangleArea(const AxisComplex& axis, const Triangle& corners)
{
  const Point& a = axis.points[corners[0]];
  return 0.5 * (axis.points[corners[1]] - a).cross(axis.points[corners[2]] - a).norm();
}

void appendCellData(const AxisComplex& from, Index cell, AxisComplex& to)
{
  to.polygonOfCell.push_back(from.polygonOfCell[cell]);
  to.samplesOfCell.push_back(from.samplesOfCell[cell]);
  to.siteViews.push_back(from.siteViews[cell]);
}

std::vector<Ball> maximalBalls(const AxisComplex& axis)
{
  std::vector<Ball> result;
  result.reserve(axis.points.size());
  for (std::size_t p = 0; p < axis.points.size(); ++p)
  {
    result.push_back({ axis.points[p], axis.radii[p] });
  }
  return result;
}

std::vector<Ball> cornerBalls(const AxisComplex& axis, Index cell)
{
  std::vector<Ball> result;
  forPoints(axis.cells, cell, [&](Index p) {
    result.push_back({ axis.points[p], axis.radii[p] });
  });
  return result;
}
}
