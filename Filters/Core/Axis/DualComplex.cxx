// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/DualComplex.h"

#include "Axis/FacePolygon.h"
#include "Axis/Sheets.h"
#include "Axis/Trimming.h"
#include "Axis/VertexMerging.h"
#include "Base/DisjointSets.h"
#include "Base/Polygons.h"

#include <algorithm>
#include <map>
#include <set>

namespace medial
{
namespace
{
/// For each edge of the triangulation one of its cells in the set, if all of them are and the dual
/// face is kept; else None.
using Faces = std::vector<Index>;

/// Leaves out one face of every Voronoi cell that is there with all its faces: one that no other such
/// cell has, so that cell and face collapse.
void openCells(const SiteTriangulation& sites, const Outside& outside, Faces& faces)
{
  std::vector<std::vector<Index>> around(sites.siteCount); // faces of each closed cell
  for (Index e = 0; e < count(faces); ++e)
  {
    for (const Index v : sites.edges.edges[e])
    {
      if (faces[e] != None && !outside.vertices[v])
      {
        around[v].push_back(e);
      }
    }
  }
  std::vector<char> open(outside.vertices);
  std::vector<Index> todo;
  for (Index v = 0; v < sites.siteCount; ++v)
  {
    todo.push_back(v);
  }
  while (!todo.empty())
  {
    const Index v = todo.back();
    todo.pop_back();
    for (const Index e : around[v])
    {
      const Edge& ends = sites.edges.edges[e];
      const Index other = ends[0] == v ? ends[1] : ends[0];
      if (!open[v] && open[other] && faces[e] != None)
      {
        faces[e] = None;
        open[v] = 1;
        for (const Index f : around[v])
        {
          const Edge& next = sites.edges.edges[f];
          todo.push_back(next[0] == v ? next[1] : next[0]);
        }
      }
    }
  }
}

Faces keptFaces(const SiteTriangulation& sites, const OpenSet& set)
{
  const Outside outside = outsideOf(sites, set);
  Faces faces(sites.edges.edges.size(), None);
  for (Index c = 0; c < count(set.cells); ++c)
  {
    for (const Index e : sites.edges.ofCell[c])
    {
      if (set.cells[c] && !outside.edges[e])
      {
        faces[e] = c;
      }
    }
  }
  openCells(sites, outside, faces);
  return faces;
}

/// The medial point of each cell of the set, and what is known of the points.
struct Vertices
{
  std::vector<Index> ofCell;
  std::vector<Index> firstCell; ///< of each point
  std::vector<Index> ball;      ///< of each point, or None
};

Vertices mergedVertices(const SiteTriangulation& sites, const OpenSet& set)
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
  Vertices result;
  result.ofCell.assign(set.cells.size(), None);
  for (Index c = 0; c < count(set.cells); ++c)
  {
    if (!set.cells[c])
    {
      continue;
    }
    const Index first = classes.find(c);
    if (first == c)
    {
      result.firstCell.push_back(c);
      result.ball.push_back(None);
    }
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

std::vector<FacePolygon> facePolygons(
  const SiteTriangulation& sites, const Faces& faces, const Vertices& vertices)
{
  std::vector<FacePolygon> polygons;
  for (Index e = 0; e < count(faces); ++e)
  {
    if (faces[e] == None)
    {
      continue;
    }
    const Edge& edge = sites.edges.edges[e];
    const Tetrahedron& corners = sites.mesh.cells[faces[e]];
    int leave = 0; // any corner that is not on the edge
    while (corners[leave] == edge[0] || corners[leave] == edge[1])
    {
      ++leave;
    }
    std::vector<Index> walk;
    for (const Index c : cellsAround(sites.mesh, edge, faces[e], leave))
    {
      if (walk.empty() || walk.back() != vertices.ofCell[c])
      {
        walk.push_back(vertices.ofCell[c]);
      }
    }
    appendSimplePolygons(walk, e, polygons);
  }
  return polygons;
}

/// Appends the Voronoi edges in the set that are in no face.
void appendEdgesWithoutFace(const SiteTriangulation& sites, const OpenSet& set, const Faces& faces,
  const Vertices& vertices, std::vector<FacePolygon>& polygons)
{
  for (Index c = 0; c < count(set.cells); ++c)
  {
    for (int i = 0; i < 4 && set.cells[c]; ++i)
    {
      const Index n = sites.mesh.neighbors[c][i];
      if (n < c || !set.cells[n])
      {
        continue;
      }
      bool inFace = false;
      for (int k = 0; k < 6; ++k)
      {
        const bool inFacet = cellEdges[k][0] != i && cellEdges[k][1] != i;
        inFace = inFace || (inFacet && faces[sites.edges.ofCell[c][k]] != None);
      }
      if (!inFace && vertices.ofCell[c] != vertices.ofCell[n])
      {
        polygons.push_back(
          { { vertices.ofCell[c], vertices.ofCell[n] }, None, facet(sites.mesh.cells[c], i) });
      }
    }
  }
}

/// What is to be trimmed: the vertices and the midpoints with their places.
FaceGeometry faceGeometry(const SingularPoints& singularPoints, const SiteTriangulation& sites,
  const Frame& frame, const Vertices& vertices, const MergedVertices& merging,
  std::vector<Point> places)
{
  for (const Edge& side : merging.midpoints)
  {
    places.push_back(0.5 * (places[side[0]] + places[side[1]]));
  }
  FaceGeometry result{ std::move(places), vertices.ball, {}, sites.edges.edges };
  result.ball.resize(result.points.size(), None);
  for (const Point& site : singularPoints.positions)
  {
    result.sites.push_back(frame.toLocal(site));
  }
  return result;
}

/// Adds the vertices as points of the axis, but for merged and trimmed ones, and the midpoints; renumbers
/// the corners of the polygons.
void addPoints(const PolarBalls& polarBalls, const SiteTriangulation& sites, const Frame& frame,
  const Vertices& vertices, const MergedVertices& merging, const std::vector<char>& trimmed,
  std::vector<FacePolygon>& polygons, AxisComplex& axis)
{
  std::vector<Ball> spheres;
  std::vector<Index> number;
  const auto add = [&](const Ball& sphere, Index ball) {
    if (trimmed[number.size()])
    {
      number.push_back(None);
      return;
    }
    number.push_back(count(axis.points));
    axis.points.push_back(sphere.center);
    axis.radii.push_back(sphere.radius);
    axis.ballOfPoint.push_back(ball);
  };
  for (Index v = 0; v < count(vertices.firstCell); ++v)
  {
    const Index ball = vertices.ball[v];
    spheres.push_back(
      ball != None ? polarBalls.balls[ball] : frame.toWorld(sites.spheres[vertices.firstCell[v]]));
    if (merging.merged[v])
    {
      number.push_back(None);
      continue;
    }
    add(spheres.back(), ball);
  }
  for (const Edge& side : merging.midpoints)
  {
    const Ball &a = spheres[side[0]], &b = spheres[side[1]];
    spheres.push_back({ 0.5 * (a.center + b.center), 0.5 * (a.radius + b.radius) });
    add(spheres.back(), None);
  }
  for (FacePolygon& polygon : polygons)
  {
    for (Index& v : polygon.corners)
    {
      v = number[v];
    }
  }
}

/// Where the sites are that a polygon is equally far from; none for one that was filled in.
std::vector<Point> sitesOf(
  const FacePolygon& polygon, const SiteTriangulation& sites, const std::vector<Point>& positions)
{
  std::vector<Point> result;
  const auto add = [&](const auto& some) {
    for (const Index site : some)
    {
      result.push_back(positions[site]);
    }
  };
  if (polygon.siteEdge != None)
  {
    add(sites.edges.edges[polygon.siteEdge]);
  }
  else if (polygon.siteFacet[0] != None)
  {
    add(polygon.siteFacet);
  }
  return result;
}

SiteView viewOf(const std::vector<Ball>& corners, const std::vector<Point>& sites)
{
  Point centroid = Point::Zero();
  for (const Ball& corner : corners)
  {
    centroid += corner.center / static_cast<double>(corners.size());
  }
  return sites.empty() ? siteView(corners) : siteView(centroid, sites);
}

/// Triangulates polygons into cells of the axis.
void addTriangles(const std::vector<FacePolygon>& polygons, const SiteTriangulation& sites,
  const SingularPoints& singularPoints, EdgeSet& edges, AxisComplex& axis)
{
  std::set<Triangle> known;
  Index number = 0;
  for (const FacePolygon& polygon : polygons)
  {
    if (polygon.corners.size() < 3)
    {
      continue;
    }
    const Edge ends =
      polygon.siteEdge == None ? Edge{ None, None } : sites.edges.edges[polygon.siteEdge];
    const auto sampleOf = [&](int k) {
      return ends[k] == None ? None : singularPoints.samples[ends[k]];
    };
    const std::vector<Point> positions = sitesOf(polygon, sites, singularPoints.positions);
    const Index firstOfPolygon = count(axis.cells.triangles);
    double radius = 0;
    for (const Index p : polygon.corners)
    {
      radius += axis.radii[p] / static_cast<double>(polygon.corners.size());
    }
    for (const Triangle& triangle : triangulate(polygon.corners, axis.points, edges))
    {
      Triangle sorted = triangle;
      std::sort(sorted.begin(), sorted.end());
      if (known.insert(sorted).second)
      {
        axis.cells.triangles.push_back(triangle);
        axis.polygonOfCell.push_back(number);
        axis.samplesOfCell.push_back({ sampleOf(0), sampleOf(1) });
      }
    }
    if (axis.points.size() > axis.radii.size())
    {
      axis.radii.push_back(radius); // of the centroid that was added
      axis.ballOfPoint.push_back(None);
    }
    for (Index t = firstOfPolygon; t < count(axis.cells.triangles); ++t)
    {
      axis.siteViews.push_back(viewOf(cornerBalls(axis, t), positions));
    }
    ++number;
  }
}

/// Adds the edges that are sides of no triangle and the points that are in no cell.
/// @param dangling  edges, ascending, with their sites
void addLowerCells(const std::map<Edge, std::vector<Point>>& dangling, const EdgeSet& sidesOfFaces,
  AxisComplex& axis)
{
  std::vector<SiteView> views;
  const auto ballAt = [&axis](Index p) { return Ball{ axis.points[p], axis.radii[p] }; };
  for (const auto& [edge, sites] : dangling)
  {
    if (!sidesOfFaces.contains(edge[0], edge[1]))
    {
      axis.cells.edges.push_back(edge);
      views.push_back(viewOf({ ballAt(edge[0]), ballAt(edge[1]) }, sites));
    }
  }
  std::vector<char> used(axis.points.size(), 0);
  const auto use = [&used](const auto& cells) {
    for (const auto& cell : cells)
    {
      for (const Index p : cell)
      {
        used[p] = 1;
      }
    }
  };
  use(axis.cells.edges);
  use(axis.cells.triangles);
  for (Index p = 0; p < count(axis.points); ++p)
  {
    if (!used[p])
    {
      views.insert(views.begin() + count(axis.cells.vertices), siteView({ ballAt(p) }));
      axis.cells.vertices.push_back(p);
    }
  }
  axis.siteViews.insert(axis.siteViews.begin(), views.begin(), views.end());
  const std::size_t lower = axis.cells.firstTriangle();
  axis.polygonOfCell.insert(axis.polygonOfCell.begin(), lower, None);
  axis.samplesOfCell.insert(axis.samplesOfCell.begin(), lower, Edge{ None, None });
}
}

AxisComplex dualComplex(const PolarBalls& polarBalls, const SingularPoints& singularPoints,
  const SiteTriangulation& sites, const OpenSet& set, const Frame& frame)
{
  const Faces faces = keptFaces(sites, set);
  const Vertices vertices = mergedVertices(sites, set);
  std::vector<FacePolygon> polygons = facePolygons(sites, faces, vertices);
  appendEdgesWithoutFace(sites, set, faces, vertices, polygons);
  std::vector<Point> places;
  for (Index v = 0; v < count(vertices.firstCell); ++v)
  {
    const Index ball = vertices.ball[v];
    places.push_back(ball != None ? frame.toLocal(polarBalls.balls[ball].center)
                                  : sites.spheres[vertices.firstCell[v]].center);
  }
  const MergedVertices merging = mergeVertices(places, vertices.ball, polygons);
  const std::vector<char> trimmed = trimSheets(
    faceGeometry(singularPoints, sites, frame, vertices, merging, std::move(places)), polygons);

  AxisComplex axis{};
  addPoints(polarBalls, sites, frame, vertices, merging, trimmed, polygons, axis);
  std::map<Edge, std::vector<Point>> dangling;
  EdgeSet sides, all;
  for (const FacePolygon& polygon : polygons)
  {
    const std::vector<Index>& corners = polygon.corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      const Index a = corners[k], b = corners[(k + 1) % corners.size()];
      all.insert(a, b);
      if (corners.size() > 2)
      {
        sides.insert(a, b);
      }
    }
    if (corners.size() == 2)
    {
      dangling.emplace(Edge{ std::min(corners[0], corners[1]), std::max(corners[0], corners[1]) },
        sitesOf(polygon, sites, singularPoints.positions));
    }
  }
  addTriangles(polygons, sites, singularPoints, all, axis);
  addLowerCells(dangling, sides, axis);
  return axis;
}
}
