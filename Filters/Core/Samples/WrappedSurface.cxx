// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/WrappedSurface.h"

#include "Base/Frame.h"
#include "Base/SurfaceTree.h"
#include "Samples/PolygonSoup.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace medial
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// Lets the wrapping be stopped.
struct Visitor : CGAL::Alpha_wraps_3::internal::Wrapping_default_visitor
{
  const Execution* execution = nullptr;
  Index turns = 0;

  template <typename Wrapper, typename Gate>
  void before_facet_treatment(const Wrapper&, const Gate&)
  {
    this->execution->pollAt(this->turns = (this->turns + 1) % 4096);
  }
};

void check(const char* what, double length)
{
  if (!(length >= 0) || !std::isfinite(length))
  {
    throw InvalidInput("the ", what, " of a wrap is a length from 0 on, not ", length);
  }
}

/// @param alpha  radius of the empty balls that carve the wrap
Mesh wrapped(const PolygonSoup& soup, double alpha, double offset, const Execution& execution)
{
  std::vector<Kernel::Point_3> points;
  for (const Point& p : soup.points)
  {
    points.emplace_back(p.x(), p.y(), p.z());
  }
  Visitor visitor;
  visitor.execution = &execution;
  Mesh result;
  CGAL::alpha_wrap_3(points, soup.triangles, alpha, offset, result,
    CGAL::parameters::default_values(), CGAL::parameters::visitor(std::ref(visitor)));
  return result;
}

/// Both sides of a sheet are wrapped: as much volume for its area as the offset.
void checkIsNoShell(const ClosedSurface& wrap, double width, double offset)
{
  constexpr double thin = 2; // times a shell
  if (wrap.measures.volume < thin * offset * wrap.area)
  {
    throw InvalidInput("a wrap of the polygons is only a shell about them, since it goes inside "
                       "through a hole that is wider than ",
      width, ": take a larger wrap width, or close the hole");
  }
}

/// The points and triangles of a mesh.
std::pair<std::vector<Point>, IndexLists> listed(const Mesh& mesh)
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> triangles;
  CGAL::Polygon_mesh_processing::polygon_mesh_to_polygon_soup(mesh, points, triangles);
  std::pair<std::vector<Point>, IndexLists> result;
  for (const Kernel::Point_3& p : points)
  {
    result.first.emplace_back(p.x(), p.y(), p.z());
  }
  for (const std::vector<std::size_t>& t : triangles)
  {
    result.second.append(std::vector<Index>(t.begin(), t.end()));
  }
  return result;
}
}

ClosedSurface wrappedSurface(const std::vector<Point>& points, const IndexLists& polygons,
  const WrapOptions& options, const Execution& execution)
{
  check("width", options.width);
  check("offset", options.offset);
  const PolygonSoup soup = polygonSoup(points, polygons);
  const double diagonal = boundingBox(soup.points).diagonal().norm();
  const double width = options.width > 0 ? options.width : diagonal / 25;
  const double offset = options.offset > 0 ? options.offset : width / 60;
  if (soup.triangles.empty())
  {
    throw InvalidInput("there are no polygons to wrap");
  }
  execution.report(0.1);
  const auto [places, faces] = listed(wrapped(soup, width / 2, offset, execution));
  execution.report(0.6);
  ClosedSurface result = closedSurface(places, faces, execution.between(0.6, 0.9));
  checkIsNoShell(result, width, offset);
  const SurfaceTree tree(soup.points, soup.triangles);
  execution.between(0.9, 1).forEach(count(result.triangles), [&](Index i) {
    const Triangle& t = result.triangles[i];
    const Point middle = (result.points[t[0]] + result.points[t[1]] + result.points[t[2]]) / 3;
    result.polygons[i] = soup.polygons[tree.nearest(middle).triangle];
  });
  result.repairs.mergedPoints = soup.mergedPoints;
  result.repairs.droppedPolygons = soup.droppedPolygons;
  const std::string what = text(
    "The polygons don't bound a solid, so the inside of a surface around them is taken: about ",
    offset, " outside them, and across gaps and holes narrower than ", width, ".");
  result.warnings.push_back(Warning{ "wrapped", what, polygons.size(), {}, false });
  return result;
}
}
