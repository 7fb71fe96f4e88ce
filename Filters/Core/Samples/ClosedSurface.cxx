// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/ClosedSurface.h"

#include "Base/DisjointSets.h"
#include "Base/Frame.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

// Steps: a soup of distinct points and triangles, each with the polygon that it comes from; its
// orientation, as a mesh; its borders; which side is outside; intersections. CGAL keeps the order of the
// triangles from the soup to the mesh, so that the polygons stay known.
namespace medial
{
namespace
{
namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Halfedge = Mesh::Halfedge_index;

Kernel::Point_3 toKernel(const Point& p)
{
  return { p.x(), p.y(), p.z() };
}

Point fromKernel(const Kernel::Point_3& p)
{
  return { p.x(), p.y(), p.z() };
}

struct Soup
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  std::vector<Index> polygons; ///< for each triangle
};

/// Fills the points, each place once. @return  for each given point its place
std::vector<Index> distinctPlaces(const std::vector<Point>& points, Soup& soup)
{
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&points](Index i) {
    return std::make_tuple(points[i].x(), points[i].y(), points[i].z());
  };
  std::sort(order.begin(), order.end(),
    [&key](Index a, Index b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<Index> first(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const bool repeated = i > 0 && key(order[i]) == key(order[i - 1]);
    first[order[i]] = repeated ? first[order[i - 1]] : order[i];
  }
  std::vector<Index> place(points.size(), None);
  for (Index i = 0; i < count(points); ++i)
  {
    if (first[i] == i)
    {
      place[i] = count(soup.points);
      soup.points.push_back(toKernel(points[i]));
    }
  }
  for (Index i = 0; i < count(points); ++i)
  {
    place[i] = place[first[i]];
  }
  return place;
}

/// The corners of a polygon without repeats of neighbours.
std::vector<Index> corners(const IndexLists::View& polygon, const std::vector<Index>& place)
{
  std::vector<Index> result;
  for (const Index p : polygon)
  {
    if (result.empty() || result.back() != place[p])
    {
      result.push_back(place[p]);
    }
  }
  while (result.size() > 1 && result.front() == result.back())
  {
    result.pop_back();
  }
  return result;
}

/// Triangles of a polygon, which need be neither flat nor convex.
std::vector<Triangle> triangulated(const std::vector<Index>& polygon, const Soup& soup)
{
  std::vector<Kernel::Point_3> line;
  line.reserve(polygon.size());
  for (const Index p : polygon)
  {
    line.push_back(soup.points[p]);
  }
  std::vector<CGAL::Triple<int, int, int>> found;
  if (polygon.size() > 3)
  {
    pmp::triangulate_hole_polyline(line, std::back_inserter(found));
  }
  std::vector<Triangle> result;
  result.reserve(polygon.size());
  for (const auto& t : found)
  {
    result.push_back({ polygon[t.first], polygon[t.second], polygon[t.third] });
  }
  for (std::size_t i = 2; found.empty() && i < polygon.size(); ++i)
  {
    result.push_back({ polygon[0], polygon[i - 1], polygon[i] });
  }
  return result;
}

/// Drops all but the first of triangles with the same corners.
void addDistinct(
  const std::vector<std::pair<Triangle, Index>>& triangles, Soup& soup, SurfaceRepairs& repairs)
{
  std::vector<std::pair<Triangle, Index>> sorted;
  for (Index i = 0; i < count(triangles); ++i)
  {
    Triangle t = triangles[i].first;
    std::sort(t.begin(), t.end());
    sorted.emplace_back(t, i);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<char> repeated(triangles.size(), 0);
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    repeated[sorted[i].second] = sorted[i].first == sorted[i - 1].first;
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const auto& [t, polygon] = triangles[i];
    if (repeated[i] || t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      ++repairs.droppedPolygons;
      continue;
    }
    soup.triangles.push_back({ std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2]) });
    soup.polygons.push_back(polygon);
  }
}

Soup soupOf(const std::vector<Point>& points, const IndexLists& polygons, SurfaceRepairs& repairs)
{
  Soup soup;
  const std::vector<Index> place = distinctPlaces(points, soup);
  repairs.mergedPoints = count(points) - count(soup.points);
  std::vector<std::pair<Triangle, Index>> triangles;
  for (Index i = 0; i < polygons.size(); ++i)
  {
    const std::vector<Index> polygon = corners(polygons[i], place);
    repairs.droppedPolygons += polygon.size() < 3;
    if (polygon.size() >= 3)
    {
      for (const Triangle& t : triangulated(polygon, soup))
      {
        triangles.emplace_back(t, i);
      }
    }
  }
  addDistinct(triangles, soup, repairs);
  return soup;
}

/// "(1, 2, 3)"
std::string placeText(const Kernel::Point_3& p)
{
  return text('(', p.x(), ", ", p.y(), ", ", p.z(), ')');
}

/// Fills holes that are small against the surface. @throw InvalidInput  others remain
/// @param diagonal  of the surface
void closeBorders(Mesh& mesh, double diagonal, ClosedSurface& result)
{
  pmp::stitch_borders(mesh);
  constexpr double small = 0.05; // of the diagonal: what a scanner or a modeller missed; not a cut
  std::vector<Halfedge> cycles;
  pmp::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  Index open = 0;
  Kernel::Point_3 somewhere;
  std::optional<Point> firstFilled;
  for (const Halfedge cycle : cycles)
  {
    std::vector<Point> loop;
    for (const Halfedge h : CGAL::halfedges_around_face(cycle, mesh))
    {
      loop.push_back(fromKernel(mesh.point(mesh.target(h))));
    }
    std::vector<Mesh::Face_index> filled;
    if (boundingBox(loop).diagonal().norm() <= small * diagonal)
    {
      pmp::triangulate_hole(mesh, cycle, std::back_inserter(filled));
    }
    result.repairs.filledHoles += filled.empty() ? 0 : 1;
    result.repairs.filledTriangles += count(filled);
    if (filled.empty())
    {
      ++open;
      somewhere = mesh.point(mesh.target(cycle));
    }
    else if (!firstFilled)
    {
      firstFilled = loop.front();
    }
  }
  if (open > 0)
  {
    throw InvalidInput("the surface is not closed: it has ", open, open == 1 ? " hole" : " holes",
      ", one of them at ", placeText(somewhere), "; close it");
  }
  if (const Index holes = result.repairs.filledHoles; holes > 0)
  {
    result.warnings.push_back({ "filled_holes",
      text(holes,
        holes == 1 ? " small hole of the surface was" : " small holes of the surface were",
        " filled with ", result.repairs.filledTriangles,
        " triangles; close the surface yourself where that is wrong"),
      holes, firstFilled, false });
  }
}

/// The piece of the surface that each triangle belongs to.
std::vector<Index> pieceOfTriangle(const ClosedSurface& surface)
{
  DisjointSets pieces(count(surface.points));
  for (const Triangle& t : surface.triangles)
  {
    pieces.unite(t[0], t[1]);
    pieces.unite(t[0], t[2]);
  }
  std::vector<Index> result;
  for (const Triangle& t : surface.triangles)
  {
    result.push_back(pieces.find(t[0]));
  }
  return result;
}

/// Warns of triangles that intersect. @throw InvalidInput  if which points are inside is not clear
void checkIntersections(const Mesh& mesh, ClosedSurface& result)
{
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
  pmp::self_intersections(mesh, std::back_inserter(found));
  if (found.empty())
  {
    return;
  }
  const std::vector<Index> piece = pieceOfTriangle(result);
  Index between = 0;
  std::vector<Index> touched;
  for (const auto& [a, b] : found)
  {
    between += piece[a.idx()] != piece[b.idx()];
    touched.push_back(static_cast<Index>(a.idx()));
    touched.push_back(static_cast<Index>(b.idx()));
  }
  sortUnique(touched);
  const Triangle& t = result.triangles[touched.front()];
  const Point place = result.points[t[0]];
  constexpr double tooMany = 0.01; // of the triangles: more are no single folds
  if (between > 0 || count(touched) > tooMany * count(result.triangles))
  {
    throw InvalidInput(found.size(), " pairs of triangles intersect, ", between,
      " of them of separate pieces, the first at ", placeText(toKernel(place)),
      ": what is inside is not clear; unite the pieces, or mend the surface");
  }
  result.warnings.push_back({ "self_intersections",
    text(found.size(),
      found.size() == 1 ? " pair of triangles intersects" : " pairs of triangles intersect",
      "; mend the surface there if the result is wrong near them"),
    count(found), place, false });
}

/// Copies the mesh into the result.
void take(const Mesh& mesh, const Soup& soup, ClosedSurface& result)
{
  std::vector<Index> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), None);
  result.points.clear();
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    number[v.idx()] = count(result.points);
    result.points.push_back(fromKernel(mesh.point(v)));
  }
  for (const Mesh::Face_index f : mesh.faces())
  {
    Triangle t;
    int k = 0;
    for (const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    {
      t[k++] = number[v.idx()];
    }
    result.triangles.push_back(t);
    result.polygons.push_back(f.idx() < soup.polygons.size() ? soup.polygons[f.idx()] : None);
    const Point &a = result.points[t[0]], &b = result.points[t[1]], &c = result.points[t[2]];
    result.area += (b - a).cross(c - a).norm() / 2;
  }
}
}

ClosedSurface closedSurface(
  const std::vector<Point>& points, const IndexLists& polygons, const Execution& execution)
{
  ClosedSurface result;
  Soup soup = soupOf(points, polygons, result.repairs);
  if (soup.triangles.empty())
  {
    throw InvalidInput("there are no polygons to make a surface of");
  }
  execution.report(0.2);
  pmp::orient_polygon_soup(soup.points, soup.triangles);
  Mesh mesh;
  pmp::polygon_soup_to_polygon_mesh(soup.points, soup.triangles, mesh);
  execution.report(0.4);
  closeBorders(mesh, boundingBox(points).diagonal().norm(), result);
  pmp::remove_degenerate_faces(mesh);
  pmp::orient_to_bound_a_volume(mesh);
  execution.report(0.6);
  take(mesh, soup, result);
  checkIntersections(mesh, result);
  result.measures = solidMeasures(result.points, result.triangles, execution.between(0.8, 1));
  if (!result.measures.closed || !result.measures.manifold)
  {
    throw InvalidInput("the polygons can't be oriented as the surface of a solid");
  }
  execution.report(1);
  return result;
}

Warning notASolid(const std::string& reason, Index polygonCount)
{
  return { "not_a_solid",
    "The polygons don't bound a solid, so only their points are used: " + reason, polygonCount, {},
    false };
}
}
