// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/ShapeCollapse.h"

#include "Axis/FacePolygon.h"
#include "Axis/GuidedCollapse.h"
#include "Axis/ShapeComplex.h"
#include "Axis/TriangleSites.h"
#include "Axis/Trimming.h"
#include "Balls/MarkedBetti.h"
#include "Base/Frame.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

namespace medial
{
namespace
{
/// What the triangles of the shape are equally far from.
struct ShapeSites
{
  FaceGeometry geometry;      ///< in the frame
  std::vector<Index> samples; ///< for each site: the sample that it is, or None
};

/// Adds the two points where the spheres of three balls meet.
/// @param balls  all, in the frame
/// @return  the number of the new site edge; None where the spheres don't meet on both sides
Index addSites(const PolarBalls& polarBalls, const std::vector<Ball>& balls, const Frame& frame,
  const Triangle& corners, ShapeSites& sites)
{
  std::array<Point, 2> points;
  Edge samples;
  for (int side = 0; side < 2; ++side)
  {
    const Triangle seen = side == 0 ? corners : Triangle{ corners[0], corners[2], corners[1] };
    samples[side] = sharedSample(polarBalls, seen);
    const auto meeting = samples[side] != None
      ? std::optional<Point>(frame.toLocal(polarBalls.samples[samples[side]]))
      : boundaryIntersection(balls[seen[0]], balls[seen[1]], balls[seen[2]]);
    if (!meeting)
    {
      return None;
    }
    points[side] = *meeting;
  }
  const Index first = count(sites.samples);
  sites.geometry.sites.insert(sites.geometry.sites.end(), points.begin(), points.end());
  sites.samples.insert(sites.samples.end(), samples.begin(), samples.end());
  sites.geometry.siteEdges.push_back({ first, first + 1 });
  return count(sites.geometry.siteEdges) - 1;
}

/// What is left of the shape, as triangles and as polygons of two corners.
std::vector<FacePolygon> facePolygons(const ShapeComplex& shape, const PolarBalls& polarBalls,
  const std::vector<Ball>& balls, const Frame& frame, ShapeSites& sites)
{
  std::vector<FacePolygon> result;
  for (Index t = 0; t < count(shape.triangles); ++t)
  {
    if (shape.hasTriangle(t))
    {
      const Triangle& corners = shape.triangles[t];
      result.push_back(
        { { corners.begin(), corners.end() }, addSites(polarBalls, balls, frame, corners, sites) });
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

void leaveOut(const std::vector<char>& gone, std::vector<char>& isLeft)
{
  std::transform(isLeft.begin(), isLeft.end(), gone.begin(), isLeft.begin(),
    [](char left, char out) { return left && !out; });
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

SiteView viewOf(const AxisComplex& axis, Index cell, const std::vector<Point>& sites)
{
  Point centroid = Point::Zero();
  forPoints(axis.cells, cell, [&](Index p) { centroid += axis.points[p] / 3; });
  return siteView(centroid, sites);
}

/// Each triangle is a polygon of its own.
/// @param polygons  the triangles of the axis, in their order, among others
void describeCells(const std::vector<FacePolygon>& polygons, const ShapeSites& sites,
  const Frame& frame, AxisComplex& axis)
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
  Index cell = lower;
  for (const FacePolygon& polygon : polygons)
  {
    if (polygon.corners.size() == 3 && polygon.siteEdge != None)
    {
      const Edge& ends = sites.geometry.siteEdges[polygon.siteEdge];
      const auto place = [&](
                           int k) -> Point { return frame.toWorld(sites.geometry.sites[ends[k]]); };
      axis.samplesOfCell[cell] = { sites.samples[ends[0]], sites.samples[ends[1]] };
      axis.siteViews[cell] = viewOf(axis, cell, { place(0), place(1) });
    }
    cell += polygon.corners.size() == 3;
  }
}
}

AxisComplex collapsedShape(const PolarBalls& polarBalls, const Execution& execution)
{
  const Frame frame = frameOf(polarBalls.samples);
  std::vector<Ball> balls;
  ShapeSites sites;
  sites.geometry.spacing = polarBalls.spacing * frame.scale;
  for (Index b = 0; b < count(polarBalls.balls); ++b)
  {
    balls.push_back(frame.toLocal(polarBalls.balls[b]));
    sites.geometry.points.push_back(balls.back().center);
    sites.geometry.ball.push_back(b);
  }
  std::vector<char> isLeft = innerBalls(polarBalls.sides);
  ShapeComplex complex(polarBalls.triangulation, isLeft);
  execution.poll();
  collapseToSheets(complex, sites.geometry.points, execution);
  std::vector<FacePolygon> polygons = facePolygons(complex, polarBalls, balls, frame, sites);
  leaveOut(trimFlaps(sites.geometry, polygons, execution), isLeft);
  leaveOut(trimSheets(sites.geometry, polygons, execution), isLeft);
  AxisComplex axis = axisOf(polarBalls, isLeft, polygons);
  describeCells(polygons, sites, frame, axis);
  return axis;
}
}
