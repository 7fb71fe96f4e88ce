// SPDX-License-Identifier: BSD-3-Clause
#include "Floor.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>

namespace floors
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 kernelPoint(const medial::Point& p)
{
  return { p.x(), p.y(), p.z() };
}
}

std::size_t delaunay(const std::vector<medial::Point>& points)
{
  std::vector<Kernel::Point_3> all;
  all.reserve(points.size());
  for (const medial::Point& p : points)
  {
    all.push_back(kernelPoint(p));
  }
  return CGAL::Delaunay_triangulation_3<Kernel>(all.begin(), all.end()).number_of_cells();
}

std::size_t regular(const std::vector<medial::Ball>& balls)
{
  using Regular = CGAL::Regular_triangulation_3<Kernel>;
  std::vector<Regular::Weighted_point> all;
  all.reserve(balls.size());
  for (const medial::Ball& ball : balls)
  {
    all.emplace_back(kernelPoint(ball.center), ball.radius * ball.radius);
  }
  return Regular(all.begin(), all.end()).number_of_cells();
}
}
