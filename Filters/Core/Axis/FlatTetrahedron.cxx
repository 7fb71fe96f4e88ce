// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/FlatTetrahedron.h"

#include <Eigen/Geometry>

#include <cmath>

namespace medial
{
FlatTetrahedron flatTetrahedron(const std::array<Point, 4>& corners)
{
  const Point u = corners[1] - corners[0], v = corners[2] - corners[0], w = corners[3] - corners[0];
  // The area vectors of the triangles sum to zero. Those of the triangles seen from one direction sum to
  // the shadow's area times the direction, at most: the longest sum tells the direction.
  const std::array<Point, 4> areas{ (v - u).cross(w - u), w.cross(v), u.cross(w), v.cross(u) };
  double largest = 0;
  FlatTetrahedron result{ 1, 0 };
  for (const FacetSet side :
    { FacetSet(3), FacetSet(5), FacetSet(9), FacetSet(1), FacetSet(2), FacetSet(4), FacetSet(8) })
  {
    Point sum = Point::Zero();
    for (int i = 0; i < 4; ++i)
    {
      sum += holds(side, i) ? areas[i] : Point::Zero();
    }
    if (sum.squaredNorm() > largest)
    {
      largest = sum.squaredNorm();
      result.side = side;
    }
  }
  const double volume = std::abs(u.dot(v.cross(w)));
  result.flatness = largest > 0 ? volume / std::pow(largest, 0.75) : 0;
  return result;
}
}
