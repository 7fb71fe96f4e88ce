// SPDX-License-Identifier: BSD-3-Clause
#include "Base/SurfaceTree.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <limits>

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

/// The triangle that a way meets first, for a traversal of the tree. Most boxes and triangles are not even next to
/// the box of a short way; that is told at less cost than whether the way meets them.
class FirstMet
{
public:
  FirstMet(const Mesh& theMesh, const Tree& tree, const Segment& theWay, Index theSkipped)
    : mesh(theMesh)
    , traits(tree.traits())
    , way(theWay)
    , around(theWay.bbox())
    , skipped(theSkipped)
  {
  }

  // What CGAL's traversal calls. NOLINTBEGIN(readability-identifier-naming)
  static bool go_further() { return true; }
  template <typename Node>
  bool do_intersect(const Segment&, const Node& node) const
  {
    return CGAL::do_overlap(this->around, node.bbox()) &&
      this->traits.do_intersect_object()(this->way, node.bbox());
  }
  // NOLINTEND(readability-identifier-naming)
  void intersection(const Segment&, const Primitive& primitive)
  {
    const auto triangle = static_cast<Index>(primitive.id().idx());
    if (triangle == this->skipped || !this->isNextTo(triangle))
    {
      return;
    }
    const auto met = this->traits.intersection_object()(this->way, primitive);
    if (!met)
    {
      return;
    }
    if (const auto* point = boost::get<Kernel::Point_3>(&met->first))
    {
      this->meet(*point, triangle);
    }
    else if (const auto* along = boost::get<Segment>(&met->first)) // in the triangle's plane
    {
      this->meet(along->source(), triangle);
      this->meet(along->target(), triangle);
    }
  }

  std::optional<SurfaceTree::Place> result;

private:
  bool isNextTo(Index triangle) const
  {
    const auto corner = [&](int k) {
      return this->mesh.point(Mesh::Vertex_index(3 * triangle + k)).bbox();
    };
    return CGAL::do_overlap(this->around, corner(0) + corner(1) + corner(2));
  }

  void meet(const Kernel::Point_3& point, Index triangle)
  {
    const double squared = CGAL::squared_distance(this->way.source(), point);
    if (squared < this->least || (squared == this->least && triangle < this->result->triangle))
    {
      this->least = squared;
      this->result = SurfaceTree::Place{ fromKernel(point), triangle };
    }
  }

  const Mesh& mesh;
  const Tree::AABB_traits& traits;
  Segment way;
  CGAL::Bbox_3 around;
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

  Mesh mesh;
  std::vector<Mesh::Face_index> faces;
  Tree tree;
  Inside inside;
};

double distanceToTriangle(const Point& point, const Point& a, const Point& b, const Point& c)
{
  const Kernel::Triangle_3 triangle(toKernel(a), toKernel(b), toKernel(c));
  return std::sqrt(CGAL::squared_distance(toKernel(point), triangle));
}

SurfaceTree::SurfaceTree(const std::vector<Point>& points, const std::vector<Triangle>& triangles)
  : implementation(new Implementation(points, triangles))
{
}

SurfaceTree::SurfaceTree(SurfaceTree&& other) noexcept = default;
SurfaceTree::~SurfaceTree() = default;

SurfaceTree::Place SurfaceTree::nearest(const Point& point) const
{
  const auto found = this->implementation->tree.closest_point_and_primitive(toKernel(point));
  return { fromKernel(found.first), static_cast<Index>(found.second.idx()) };
}

double SurfaceTree::distance(const Point& point, Index triangle) const
{
  const Mesh& mesh = this->implementation->mesh;
  const auto corner = [&](int k) {
    return fromKernel(mesh.point(Mesh::Vertex_index(3 * triangle + k)));
  };
  return distanceToTriangle(point, corner(0), corner(1), corner(2));
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
