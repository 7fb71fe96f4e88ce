// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/ClosedSurface.h"

#include "Base/Frame.h"
#include "Samples/MissedDetails.h"
#include "Samples/PolygonSoup.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
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

/// A halfedge of each border.
std::vector<Halfedge> bordersOf(const Mesh& mesh)
{
  std::vector<Halfedge> result;
  pmp::extract_boundary_cycles(mesh, std::back_inserter(result));
  return result;
}

/// The oriented surface; a face for each triangle, in order.
Mesh meshOf(const PolygonSoup& soup)
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::transform(soup.points.begin(), soup.points.end(), std::back_inserter(points), toKernel);
  for (const Triangle& t : soup.triangles)
  {
    triangles.push_back({ std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2]) });
  }
  pmp::orient_polygon_soup(points, triangles);
  Mesh mesh;
  pmp::polygon_soup_to_polygon_mesh(points, triangles, mesh);
  pmp::stitch_borders(bordersOf(mesh), mesh); // without borders, CGAL 6.2 doesn't compile it
  return mesh;
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
  constexpr double small = 0.05; // of the diagonal: what a scanner or a modeller missed; not a cut
  const std::vector<Halfedge> cycles = bordersOf(mesh);
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
        " triangles. Close the surface yourself where that is wrong."),
      holes, firstFilled, false });
  }
}

/// May a volume differ from 0 by rounding only?
/// @param diagonal  of the surface
bool isFlat(double volume, double area, double diagonal)
{
  constexpr double rounding = 1e-14; // of coordinates as large as the surface, and some more
  return !(volume > rounding * area * diagonal);
}

/// Does none of the connected pieces of an oriented surface enclose a volume?
bool isFlat(Mesh& mesh)
{
  std::vector<Point> points;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    points.push_back(fromKernel(mesh.point(v)));
  }
  const double diagonal = boundingBox(points).diagonal().norm();
  const auto pieceOf = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:piece", 0).first;
  std::vector<double> volumes(pmp::connected_components(mesh, pieceOf)), areas(volumes.size());
  for (const Mesh::Face_index f : mesh.faces())
  {
    std::array<Point, 3> corners;
    int k = 0;
    for (const Mesh::Vertex_index v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
    {
      corners[k++] = fromKernel(mesh.point(v)) - points.front();
    }
    const auto& [a, b, c] = corners;
    volumes[pieceOf[f]] += a.dot(b.cross(c)) / 6;
    areas[pieceOf[f]] += (b - a).cross(c - a).norm() / 2;
  }
  bool result = true;
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    result = result && isFlat(std::abs(volumes[i]), areas[i], diagonal);
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
  const std::vector<Index> piece = pieceOfTriangle(result.triangles, count(result.points));
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
      ". Mend the surface there if the result is wrong near them."),
    count(found), place, false });
}

/// Copies the mesh into the result.
void take(const Mesh& mesh, const PolygonSoup& soup, ClosedSurface& result)
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
  PolygonSoup soup = polygonSoup(points, polygons);
  if (soup.triangles.empty())
  {
    throw InvalidInput("there are no polygons to make a surface of");
  }
  execution.report(0.2);
  Mesh mesh = meshOf(soup);
  if (!CGAL::is_closed(mesh))
  {
    soup = polygonSoup(points, polygons, Weld::Rounding);
    dropHangingPatches(soup);
    mesh = meshOf(soup);
  }
  result.repairs.mergedPoints = soup.mergedPoints;
  result.repairs.droppedPolygons = soup.droppedPolygons;
  execution.report(0.4);
  closeBorders(mesh, boundingBox(points).diagonal().norm(), result);
  pmp::remove_isolated_vertices(mesh);
  pmp::remove_degenerate_faces(mesh);
  if (mesh.number_of_faces() == 0)
  {
    throw InvalidInput("the polygons have no area");
  }
  const std::string flat = "the surface is flat: it encloses no volume";
  if (isFlat(mesh)) // then it has no outside that CGAL could find
  {
    throw InvalidInput(flat);
  }
  pmp::orient_to_bound_a_volume(mesh);
  execution.report(0.6);
  take(mesh, soup, result);
  checkIntersections(mesh, result);
  result.measures = solidMeasures(result.points, result.triangles, execution.between(0.8, 1));
  if (!result.measures.closed || !result.measures.manifold)
  {
    throw InvalidInput("the polygons can't be oriented as the surface of a solid");
  }
  if (isFlat(result.measures.volume, result.area, boundingBox(result.points).diagonal().norm()))
  {
    throw InvalidInput(flat);
  }
  execution.report(1);
  return result;
}

Warning notASolid(const std::string& reason, Index polygonCount)
{
  return { "not_a_solid",
    "The polygons don't bound a solid, so only their points are used: " + reason + ".",
    polygonCount, {}, false };
}
}
