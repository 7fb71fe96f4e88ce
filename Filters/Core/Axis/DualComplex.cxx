// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/DualComplex.h"

#include "Axis/AxisVertices.h"
#include "Axis/FacePolygon.h"
#include "Axis/FaceTriangulation.h"
#include "Axis/FreePlaces.h"
#include "Axis/Membranes.h"
#include "Axis/Sheets.h"
#include "Axis/Trimming.h"
#include "Axis/VertexMerging.h"
#include "Axis/VoronoiFaces.h"

#include <utility>
#include <vector>

// In the Voronoi diagram of the sites each cell of their Delaunay triangulation is a vertex, each facet
// an edge, each edge a face. What is dual to an open set of cells is a closed complex with the same
// topology. It becomes the axis in steps that each keep the Betti numbers: faces as polygons
// (VoronoiFaces), vertices at the same place made one (VertexMerging), slivers left out and sheets cut
// apart (Trimming), small tunnels closed (Membranes), polygons cut into triangles (FaceTriangulation).
//
// Decisions are made in the frame, where tolerances hold; points of the result come from the balls in
// world coordinates, so that a pole is the very centre of its ball. For n cells each step takes O(n log
// n) time or less.

namespace medial
{
namespace
{
/// The vertices, those merged into others included, and the midpoints of split sides after them.
struct AllVertices
{
  std::vector<Ball> balls;     ///< maximal balls, in world coordinates
  std::vector<Point> places;   ///< in the frame
  std::vector<Index> pole;     ///< the polar ball that each vertex is the centre of, or None
  std::vector<char> isDropped; ///< merged into another one, or trimmed
};

AllVertices allVertices(const PolarBalls& polarBalls, const SiteTriangulation& sites,
  const Frame& frame, const AxisVertices& vertices)
{
  AllVertices result;
  for (Index v = 0; v < count(vertices.firstCell); ++v)
  {
    const Index pole = vertices.ball[v];
    const Ball& sphere = sites.spheres[vertices.firstCell[v]];
    result.balls.push_back(pole != None ? polarBalls.balls[pole] : frame.toWorld(sphere));
    result.places.push_back(
      pole != None ? frame.toLocal(polarBalls.balls[pole].center) : sphere.center);
  }
  result.pole = vertices.ball;
  result.isDropped.assign(vertices.firstCell.size(), 0);
  return result;
}

void addMidpoints(const std::vector<Edge>& sides, const Frame& frame, AllVertices& vertices)
{
  if (sides.empty())
  {
    return;
  }
  std::vector<Point> taken;
  for (std::size_t v = 0; v < vertices.places.size(); ++v)
  {
    if (!vertices.isDropped[v])
    {
      taken.push_back(vertices.places[v]);
    }
  }
  FreePlaces places(taken);
  for (const Edge& side : sides)
  {
    const Point place =
      places.takeNear(0.5 * (vertices.places[side[0]] + vertices.places[side[1]]));
    const double radius = 0.5 * (vertices.balls[side[0]].radius + vertices.balls[side[1]].radius);
    vertices.balls.push_back({ frame.toWorld(place), radius });
    vertices.places.push_back(place);
    vertices.pole.push_back(None);
    vertices.isDropped.push_back(0);
  }
}

void drop(const std::vector<char>& gone, AllVertices& vertices)
{
  for (std::size_t v = 0; v < gone.size(); ++v)
  {
    vertices.isDropped[v] |= gone[v];
  }
}

FaceGeometry faceGeometry(const AllVertices& vertices, const SingularPoints& singularPoints,
  const SiteTriangulation& sites, const Frame& frame, double spacing)
{
  FaceGeometry result{ vertices.places, vertices.pole, {}, sites.edges.edges,
    spacing * frame.scale };
  for (const Point& site : singularPoints.positions)
  {
    result.sites.push_back(frame.toLocal(site));
  }
  return result;
}

/// Makes the vertices points of the axis, and renumbers the corners of the polygons.
void addPoints(const AllVertices& vertices, std::vector<FacePolygon>& polygons, AxisComplex& axis)
{
  std::vector<Index> number(vertices.balls.size(), None);
  for (std::size_t v = 0; v < number.size(); ++v)
  {
    if (!vertices.isDropped[v])
    {
      number[v] = count(axis.points);
      axis.points.push_back(vertices.balls[v].center);
      axis.radii.push_back(vertices.balls[v].radius);
      axis.ballOfPoint.push_back(vertices.pole[v]);
    }
  }
  for (FacePolygon& polygon : polygons)
  {
    for (Index& v : polygon.corners)
    {
      v = number[v];
    }
  }
}
}

AxisComplex dualComplex(const PolarBalls& polarBalls, const SingularPoints& singularPoints,
  const SiteTriangulation& sites, const OpenSet& set, const Frame& frame,
  const Execution& execution)
{
  const AxisVertices dual = axisVertices(sites, set);
  execution.poll();
  VoronoiFaces faces = voronoiFaces(sites, set, dual, execution);
  std::vector<FacePolygon>& polygons = faces.polygons;
  execution.poll();
  AllVertices vertices = allVertices(polarBalls, sites, frame, dual);
  addMidpoints(faces.midpoints, frame, vertices);
  execution.poll();
  const MergedVertices merging = mergeVertices(vertices.places, vertices.pole, polygons);
  execution.poll();
  drop(merging.merged, vertices);
  addMidpoints(merging.midpoints, frame, vertices);
  const FaceGeometry geometry =
    faceGeometry(vertices, singularPoints, sites, frame, polarBalls.spacing);
  execution.poll();
  drop(trimSheets(geometry, polygons, execution), vertices);
  execution.poll();
  drop(closeMembranes(geometry, polygons), vertices);
  execution.poll();
  AxisComplex axis;
  addPoints(vertices, polygons, axis);
  execution.poll();
  addCells(polygons, sites, singularPoints, frame, axis, execution);
  execution.poll();
  return axis;
}
}
