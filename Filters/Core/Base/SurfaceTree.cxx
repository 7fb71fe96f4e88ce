// SPDX-License-Identifier: BSD-3-Clause
#include "Base/SurfaceTree.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iterator>
#include <limits>

namespace medial
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
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
  const auto corner = [&](int k) { return mesh.point(Mesh::Vertex_index(3 * triangle + k)); };
  const Kernel::Triangle_3 whole(corner(0), corner(1), corner(2));
  return std::sqrt(CGAL::squared_distance(toKernel(point), whole));
}

std::optional<SurfaceTree::Place> SurfaceTree::firstMet(
  const Point& from, const Point& to, Index skipped) const
{
  if (from == to) // no segment, for CGAL
  {
    return {};
  }
  const Kernel::Segment_3 way(toKernel(from), toKernel(to));
  std::vector<Tree::Intersection_and_primitive_id<Kernel::Segment_3>::Type> met;
  this->implementation->tree.all_intersections(way, std::back_inserter(met));
  std::optional<Place> result;
  double least = std::numeric_limits<double>::infinity();
  const auto meet = [&](const Kernel::Point_3& point, Index triangle) {
    const double squared = CGAL::squared_distance(way.source(), point);
    if (squared < least || (squared == least && triangle < result->triangle))
    {
      least = squared;
      result = Place{ fromKernel(point), triangle };
    }
  };
  for (const auto& [where, face] : met)
  {
    const auto triangle = static_cast<Index>(face.idx());
    if (triangle == skipped)
    {
      continue;
    }
    if (const auto* point = boost::get<Kernel::Point_3>(&where))
    {
      meet(*point, triangle);
    }
    else if (const auto* along = boost::get<Kernel::Segment_3>(&where)) // in the triangle's plane
    {
      meet(along->source(), triangle);
      meet(along->target(), triangle);
    }
  }
  return result;
}

bool SurfaceTree::encloses(const Point& point) const
{
  return this->implementation->inside(toKernel(point)) == CGAL::ON_BOUNDED_SIDE;
}
}
