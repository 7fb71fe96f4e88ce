// SPDX-License-Identifier: BSD-3-Clause
#include "Base/SurfaceTree.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/version.h>

#include <cmath>
#include <limits>
#if CGAL_VERSION_NR >= 1060000000
#include <variant>
#endif

namespace medial
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
using Segment = Kernel::Segment_3;
using Inside = CGAL::Side_of_triangle_mesh<Mesh, Kernel, CGAL::Default, Tree>;

/// The variant that CGAL's intersections are: Boost's before CGAL 6.
template <typename Shape, typename Variant>
const Shape* ifIs(const Variant& variant)
{
#if CGAL_VERSION_NR >= 1060000000
  return std::get_if<Shape>(&variant);
#else
  return boost::get<Shape>(&variant);
#endif
}

Kernel::Point_3 toKernel(const Point& p)
{
  return { p.x(), p.y(), p.z() };
}

Point fromKernel(const Kernel::Point_3& p)
{
  return { p.x(), p.y(), p.z() };
}

/// Each triangle has its own corners: the searches don't ask how triangles hang together, and so no
/// surface is refused.
Mesh meshOf(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  Mesh mesh;
  mesh.reserve(3 * count(triangles), 3 * count(triangles), count(triangles));
  for (const Triangle& t : triangles)
  {
    mesh.add_face(mesh.add_vertex(toKernel(points[t[0]])), mesh.add_vertex(toKernel(points[t[1]])),
      mesh.add_vertex(toKernel(points[t[2]])));
  }
  return mesh;
}

std::vector<Mesh::Face_index> facesWithArea(
  const std::vector<Point>& points, const std::vector<Triangle>& triangles)
{
  std::vector<Mesh::Face_index> result;
  for (Index t = 0; t < count(triangles); ++t)
  {
    const auto& [a, b, c] = triangles[t];
    if (!CGAL::collinear(toKernel(points[a]), toKernel(points[b]), toKernel(points[c])))
    {
      result.emplace_back(t);
    }
  }
  return result;
}

double distance(const Kernel::Point_3& point, const Kernel::Triangle_3& triangle)
{
  return std::sqrt(CGAL::squared_distance(point, triangle));
}

/// The triangle that a way meets first, for a traversal of the tree. Doubles tell of most boxes and triangles that the
/// way is not next to them, at less cost than whether it meets them. A triangle that is met shortens it.
class FirstMet
{
public:
  FirstMet(const Mesh& theMesh, const Tree& tree, const Segment& theWay, Index theSkipped)
    : mesh(theMesh)
    , traits(tree.traits())
    , way(theWay)
    , skipped(theSkipped)
  {
    this->look(theWay.target());
  }

  // What CGAL's traversal calls. NOLINTBEGIN(readability-identifier-naming)
  static bool go_further() { return true; }
  template <typename Node>
  bool do_intersect(const Segment&, const Node& node) const
  {
    return this->isNextTo(node.bbox());
  }
  // NOLINTEND(readability-identifier-naming)
  void intersection(const Segment&, const Primitive& primitive)
  {
    const auto triangle = static_cast<Index>(primitive.id().idx());
    if (triangle == this->skipped || !this->isNextTo(this->boxOf(triangle)))
    {
      return;
    }
    const auto met = this->traits.intersection_object()(this->way, primitive);
    if (!met)
    {
      return;
    }
    if (const auto* point = ifIs<Kernel::Point_3>(met->first))
    {
      this->meet(*point, triangle);
    }
    else if (const auto* along = ifIs<Segment>(met->first)) // in the triangle's plane
    {
      this->meet(along->source(), triangle);
      this->meet(along->target(), triangle);
    }
  }

  std::optional<SurfaceTree::Place> result;

private:
  /// Looks for triangles from where the way begins to here.
  void look(const Kernel::Point_3& to)
  {
    const Point begin = fromKernel(this->way.source()), end = fromKernel(to);
    this->middle = (begin + end) / 2;
    this->half = (end - begin).cwiseAbs() / 2;
    this->along = (end - begin) / 2;
    constexpr double rounding = 1e-14; // of coordinates; more than what the sums below lose
    this->slack = rounding * (begin.cwiseAbs() + end.cwiseAbs()).sum();
  }

  CGAL::Bbox_3 boxOf(Index triangle) const
  {
    const auto corner = [&](int k) {
      return this->mesh.point(Mesh::Vertex_index(3 * triangle + k)).bbox();
    };
    return corner(0) + corner(1) + corner(2);
  }

  /// Is there no axis, of the box or across it and the way, that separates them? Yes in doubt.
  bool isNextTo(const CGAL::Bbox_3& box) const
  {
    const Point low(box.xmin(), box.ymin(), box.zmin()), high(box.xmax(), box.ymax(), box.zmax());
    const Point size = (high - low) / 2, between = (high + low) / 2 - this->middle;
    constexpr double rounding = 1e-14;
    const double lost = this->slack + rounding * (low.cwiseAbs() + high.cwiseAbs()).sum();
    const Point reach = size + Point::Constant(lost);
    if ((between.cwiseAbs().array() > (reach + this->half).array()).any())
    {
      return false;
    }
    const auto separates = [&](int i, int k) {
      return std::abs(between[i] * this->along[k] - between[k] * this->along[i]) >
        reach[i] * this->half[k] + reach[k] * this->half[i];
    };
    return !separates(0, 1) && !separates(1, 2) && !separates(2, 0);
  }

  void meet(const Kernel::Point_3& point, Index triangle)
  {
    const double squared = CGAL::squared_distance(this->way.source(), point);
    if (squared < this->least || (squared == this->least && triangle < this->result->triangle))
    {
      this->least = squared;
      this->result = SurfaceTree::Place{ fromKernel(point), triangle };
      this->look(point);
    }
  }

  const Mesh& mesh;
  const Tree::AABB_traits& traits;
  Segment way;
  Point middle, half, along; ///< of the way up to the nearest triangle so far; `half` without signs
  double slack;              ///< what rounding may hide
  Index skipped;
  double least =
    std::numeric_limits<double>::infinity(); ///< squared distance from where the way begins
};
}

struct SurfaceTree::Implementation
{
  Implementation(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
    : mesh(meshOf(points, triangles))
    , faces(facesWithArea(points, triangles))
    , tree(faces.begin(), faces.end(), mesh)
    , inside(tree)
  {
    this->tree.build(); // else the first search would build it, on each thread
    this->tree.accelerate_distance_queries();
  }

  Kernel::Triangle_3 triangle(Index number) const
  {
    const auto corner = [&](int k) { return this->mesh.point(Mesh::Vertex_index(3 * number + k)); };
    return { corner(0), corner(1), corner(2) };
  }

  Mesh mesh;
  std::vector<Mesh::Face_index> faces;
  Tree tree;
  Inside inside;
};

double distanceToTriangle(const Point& point, const Point& a, const Point& b, const Point& c)
{
  return distance(toKernel(point), { toKernel(a), toKernel(b), toKernel(c) });
}

SurfaceTree::SurfaceTree(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
  : implementation(new Implementation(points, triangles))
{
}

SurfaceTree::SurfaceTree(SurfaceTree&& other) noexcept = default;
SurfaceTree::~SurfaceTree() = default;

SurfaceTree::Place SurfaceTree::nearest(const Point& point, const std::optional<Place>& near) const
{
  const Tree& tree = this->implementation->tree;
  const auto found = near ? tree.closest_point_and_primitive(toKernel(point),
                              { toKernel(near->point), Mesh::Face_index(near->triangle) })
                          : tree.closest_point_and_primitive(toKernel(point));
  return { fromKernel(found.first), static_cast<Index>(found.second.idx()) };
}

double SurfaceTree::distance(const Point& point, Index triangle) const
{
  return medial::distance(toKernel(point), this->implementation->triangle(triangle));
}

std::optional<SurfaceTree::Place> SurfaceTree::firstMet(
  const Point& from, const Point& to, Index skipped) const
{
  if (from == to) // no segment, for CGAL
  {
    return {};
  }
  const Segment way(toKernel(from), toKernel(to));
  FirstMet search(this->implementation->mesh, this->implementation->tree, way, skipped);
  this->implementation->tree.traversal(way, search);
  return search.result;
}

bool SurfaceTree::encloses(const Point& point) const
{
  return this->implementation->inside(toKernel(point)) == CGAL::ON_BOUNDED_SIDE;
}
}
