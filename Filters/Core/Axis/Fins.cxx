// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Fins.h"

namespace medial
{
namespace
{
/// The longest edge that a triangle alone has, or None.
Index borderOf(
  const ShapeComplex& shape, const std::vector<Point>& centers, Index triangle, Index except)
{
  Index result = None;
  double longest = -1;
  for (const Index e : shape.sides[triangle])
  {
    const Edge& ends = shape.edges[e];
    const double length = (centers[ends[0]] - centers[ends[1]]).squaredNorm();
    if (e != except && shape.triangleCount(e) == 1 && length > longest)
    {
      longest = length;
      result = e;
    }
  }
  return result;
}

/// The only other triangle at an edge, if it is in no tetrahedron, or None.
Index nextTriangle(const ShapeComplex& shape, Index triangle, Index edge)
{
  if (shape.triangleCount(edge) == 2)
  {
    for (const Index t : shape.trianglesAt(edge))
    {
      if (t != triangle && shape.tetrahedronCount(t) == 0)
      {
        return t;
      }
    }
  }
  return None;
}
}

std::vector<TriangleCollapse> finCollapses(
  const ShapeComplex& shape, const std::vector<Point>& centers, Index triangle, Index edge)
{
  if (shape.tetrahedronCount(triangle) > 0)
  {
    return {};
  }
  const Index border = borderOf(shape, centers, triangle, edge);
  if (border != None)
  {
    return { { triangle, border } };
  }
  for (const Index e : shape.sides[triangle])
  {
    const Index next = e != edge ? nextTriangle(shape, triangle, e) : None;
    const Index end = next != None ? borderOf(shape, centers, next, e) : None;
    if (end != None)
    {
      return { { next, end }, { triangle, e } };
    }
  }
  return {};
}
}
