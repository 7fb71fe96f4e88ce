// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/ShapeCollapse.h"

#include "Axis/FacePolygon.h"
#include "Axis/GuidedCollapse.h"
#include "Axis/ShapeComplex.h"
#include "Axis/Trimming.h"
#include "Balls/MarkedBetti.h"
#include "Base/Frame.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace medial
{
namespace
{
/// Adds the two points where the spheres of three balls meet: the sites of the triangle of their centres.
/// @return  the number of the new site edge; None where the spheres don't meet
Index addSites(const Ball& a, const Ball& b, const Ball& c, FaceGeometry& geometry)
{
  const Point u = b.center - a.center, v = c.center - a.center;
  const Point normal = u.cross(v);
  const double area = normal.squaredNorm();
  const auto half = [&a](const Ball& ball, const Point& edge) {
    return 0.5 * (a.radius * a.radius - ball.radius * ball.radius + edge.squaredNorm());
  };
  // The point of the plane with equal power to all three, then up and down along the normal.
  const Point base = (half(b, u) * v.cross(normal) + half(c, v) * normal.cross(u)) / area;
  const double height = a.radius * a.radius - base.squaredNorm();
  if (!(area > 0) || !(height > 0))
  {
    return None;
  }
  const Point along = normal * std::sqrt(height / area);
  const Index first = count(geometry.sites);
  geometry.sites.push_back(a.center + base + along);
  geometry.sites.push_back(a.center + base - along);
  geometry.siteEdges.push_back({ first, first + 1 });
  return count(geometry.siteEdges) - 1;
}

/// What is left of the shape, as triangles and as polygons of two corners.
std::vector<FacePolygon> facePolygons(
  const ShapeComplex& shape, const std::vector<Ball>& balls, FaceGeometry& geometry)
{
  std::vector<FacePolygon> result;
  for (Index t = 0; t < count(shape.triangles); ++t)
  {
    if (shape.hasTriangle(t))
    {
      const Triangle& corners = shape.triangles[t];
      result.push_back({ { corners.begin(), corners.end() },
        addSites(balls[corners[0]], balls[corners[1]], balls[corners[2]], geometry) });
    }
  }
  for (Index e = 0; e < count(shape.edges); ++e)
  {
    if (shape.hasEdge(e) && shape.triangleCount(e) == 0)
    {
      result.push_back({ { shape.edges[e].begin(), shape.edges[e].end() }, None });
    }
  }
  return result;
}

/// Makes the poles that are left points of the axis, and polygons and single poles its cells.
AxisComplex axisOf(const PolarBalls& polarBalls, const std::vector<char>& isLeft,
  const std::vector<FacePolygon>& polygons)
{
  AxisComplex axis{};
  std::vector<Index> pointOfBall(polarBalls.balls.size(), None);
  for (Index b = 0; b < count(polarBalls.balls); ++b)
  {
    if (isLeft[b])
    {
      pointOfBall[b] = count(axis.points);
      axis.points.push_back(polarBalls.balls[b].center);
      axis.radii.push_back(polarBalls.balls[b].radius);
      axis.ballOfPoint.push_back(b);
    }
  }
  std::vector<char> isUsed(axis.points.size(), 0);
  for (const FacePolygon& polygon : polygons)
  {
    const auto point = [&](int k) { return pointOfBall[polygon.corners[k]]; };
    if (polygon.corners.size() == 3)
    {
      axis.cells.triangles.push_back({ point(0), point(1), point(2) });
    }
    else
    {
      axis.cells.edges.push_back({ point(0), point(1) });
    }
    for (const Index b : polygon.corners)
    {
      isUsed[pointOfBall[b]] = 1;
    }
  }
  for (Index p = 0; p < count(isUsed); ++p)
  {
    if (!isUsed[p])
    {
      axis.cells.vertices.push_back(p);
    }
  }
  return axis;
}

/// Each triangle is a polygon of its own; its sites are no samples.
void describeCells(AxisComplex& axis)
{
  const Index lower = axis.cells.firstTriangle();
  axis.polygonOfCell.assign(lower, None);
  axis.polygonOfCell.resize(axis.cells.size());
  std::iota(axis.polygonOfCell.begin() + lower, axis.polygonOfCell.end(), 0);
  axis.samplesOfCell.assign(axis.cells.size(), { None, None });
  for (Index cell = 0; cell < axis.cells.size(); ++cell)
  {
    axis.siteViews.push_back(siteView(cornerBalls(axis, cell)));
  }
}
}

AxisComplex collapsedShape(
  const PolarBalls& polarBalls, const PowerShape& shape, const Execution& execution)
{
  const Frame frame = frameOf(polarBalls.samples);
  std::vector<Ball> balls;
  FaceGeometry geometry;
  for (Index b = 0; b < count(polarBalls.balls); ++b)
  {
    balls.push_back(frame.toLocal(polarBalls.balls[b]));
    geometry.points.push_back(balls.back().center);
    geometry.ball.push_back(b);
  }
  std::vector<char> isLeft = innerBalls(polarBalls.sides);
  ShapeComplex complex(shape.triangulation, isLeft);
  execution.poll();
  collapseToSheets(complex, geometry.points, execution);
  std::vector<FacePolygon> polygons = facePolygons(complex, balls, geometry);
  const std::vector<char> gone = trimSheets(geometry, polygons, execution);
  for (std::size_t b = 0; b < gone.size(); ++b)
  {
    isLeft[b] = isLeft[b] && !gone[b];
  }
  AxisComplex axis = axisOf(polarBalls, isLeft, polygons);
  describeCells(axis);
  return axis;
}
}
