// SPDX-License-Identifier: BSD-3-Clause
#include "Base/EdgeTree.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <limits>

namespace medial
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Segments = std::vector<Kernel::Segment_3>;
using Primitive = CGAL::AABB_segment_primitive<Kernel, Segments::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 toKernel(const Point& p)
{
  return { p.x(), p.y(), p.z() };
}

Segments segmentsOf(const std::vector<Point>& points, const std::vector<Edge>& edges)
{
  Segments result;
  result.reserve(edges.size());
  for (const Edge& edge : edges)
  {
    result.emplace_back(toKernel(points[edge[0]]), toKernel(points[edge[1]]));
  }
  return result;
}
}

struct EdgeTree::Implementation
{
  Implementation(const std::vector<Point>& points, const std::vector<Edge>& edges)
    : segments(segmentsOf(points, edges))
    , tree(segments.cbegin(), segments.cend())
  {
    if (!this->segments.empty())
    {
      this->tree.build(); // else the first search would build it, on each thread
      this->tree.accelerate_distance_queries();
    }
  }

  Segments segments;
  Tree tree;
};

EdgeTree::EdgeTree(const std::vector<Point>& points, const std::vector<Edge>& edges)
  : implementation(new Implementation(points, edges))
{
}

EdgeTree::~EdgeTree() = default;

double EdgeTree::distance(const Point& place) const
{
  return this->implementation->segments.empty()
    ? std::numeric_limits<double>::infinity()
    : std::sqrt(this->implementation->tree.squared_distance(toKernel(place)));
}
}
