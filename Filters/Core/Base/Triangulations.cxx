// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Triangulations.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>

namespace medial
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// On which side of the sphere through p, q, r, s is t? Nothing where rounding could decide. With the bound of
/// Shewchuk's insphere(), which is the smaller the nearer some of the points are to t.
template <typename Float>
std::optional<CGAL::Oriented_side> roundedSide(const Kernel::Point_3& p, const Kernel::Point_3& q,
  const Kernel::Point_3& r, const Kernel::Point_3& s, const Kernel::Point_3& t)
{
  const Kernel::Point_3* const corners[4] = { &p, &q, &r, &s };
  Float d[4][3], square[4];
  for (int i = 0; i < 4; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      d[i][k] = Float((*corners[i])[k]) - Float(t[k]);
    }
    square[i] = d[i][0] * d[i][0] + d[i][1] * d[i][1] + d[i][2] * d[i][2];
  }
  Float minor[4][4], minorSize[4][4]; // of the first two columns
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      const Float a = d[i][0] * d[j][1], b = d[j][0] * d[i][1];
      minor[i][j] = a - b;
      minorSize[i][j] = std::abs(a) + std::abs(b);
    }
  }
  Float det = 0, size = 0;
  for (int i = 0; i < 4; ++i) // expanded by the squares, then by the third column
  {
    const int j = (i + 1) % 4, k = (i + 2) % 4, l = (i + 3) % 4;
    const Float rest = d[j][2] * minor[k][l] + d[k][2] * minor[l][j] + d[l][2] * minor[j][k];
    const Float restSize = std::abs(d[j][2]) * minorSize[k][l] +
      std::abs(d[k][2]) * minorSize[l][j] + std::abs(d[l][2]) * minorSize[j][k];
    det += i % 2 == 0 ? square[i] * rest : -square[i] * rest;
    size += square[i] * restSize;
  }
  const Float error = 16 * std::numeric_limits<Float>::epsilon() * size + 1e-200; // may underflow
  if (!(std::abs(det) > error))
  {
    return std::nullopt;
  }
  return det > 0 ? CGAL::ON_POSITIVE_SIDE : CGAL::ON_NEGATIVE_SIDE;
}

/// Singular points lie on spheres up to rounding, many on each. Doubles leave up to a tenth of the decisions open,
/// and exact numbers would take a third of the time for these; long doubles decide nine of ten of them.
struct DelaunayKernel : Kernel
{
  struct Side_of_oriented_sphere_3 // NOLINT(readability-identifier-naming): CGAL's name
  {
    using result_type = CGAL::Oriented_side;
    result_type operator()(const Point_3& p, const Point_3& q, const Point_3& r, const Point_3& s,
      const Point_3& t) const
    {
      auto side = roundedSide<double>(p, q, r, s, t);
      if (!side && std::numeric_limits<long double>::is_iec559)
      {
        side = roundedSide<long double>(p, q, r, s, t);
      }
      return side ? *side : Kernel::Side_of_oriented_sphere_3()(p, q, r, s, t);
    }
  };
  Side_of_oriented_sphere_3 side_of_oriented_sphere_3_object() const { return {}; }
};
}
}

/// A search for a place begins with a walk in doubles, as with Kernel.
template <>
struct CGAL::Triangulation_structural_filtering_traits<medial::DelaunayKernel>
{
  using Use_structural_filtering_tag = CGAL::Tag_true;
};

namespace medial
{
namespace
{
struct Number
{
  Index value = None;
};

using DelaunayVertex = CGAL::Triangulation_vertex_base_with_info_3<Number, DelaunayKernel>;
using DelaunayCell = CGAL::Triangulation_cell_base_with_info_3<Number, DelaunayKernel,
  CGAL::Delaunay_triangulation_cell_base_3<DelaunayKernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<DelaunayKernel,
  CGAL::Triangulation_data_structure_3<DelaunayVertex, DelaunayCell>>;

using RegularVertex = CGAL::Triangulation_vertex_base_with_info_3<Number, Kernel,
  CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using RegularCell = CGAL::Regular_triangulation_cell_base_3<Kernel,
  CGAL::Triangulation_cell_base_with_info_3<Number, Kernel>, CGAL::Discard_hidden_points>;
using Regular = CGAL::Regular_triangulation_3<Kernel,
  CGAL::Triangulation_data_structure_3<RegularVertex, RegularCell>>;

/// The points' numbers in an order in which neighbours follow each other (along a Hilbert curve). The order
/// depends on the coordinates alone, so that the triangulation is the same in every run.
std::vector<std::size_t> spatialOrder(const std::vector<Kernel::Point_3>& points)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  using Map = CGAL::Pointer_property_map<Kernel::Point_3>::const_type;
  CGAL::spatial_sort(order.begin(), order.end(),
    CGAL::Spatial_sort_traits_adapter_3<Kernel, Map>(CGAL::make_property_map(points)));
  return order;
}

/// Inserts element order[i] for all i; vertices get their number. The search for the place of each begins
/// at the one before: in an order in which neighbours follow each other, it takes constant time on average.
template <typename Triangulation, typename Element>
void insertInOrder(Triangulation& triangulation, const std::vector<std::size_t>& order,
  const Element& element, Index firstNumber, const Execution& execution)
{
  typename Triangulation::Cell_handle hint;
  for (Index i = 0; i < count(order); ++i)
  {
    if (i % 1024 == 0)
    {
      execution.report(static_cast<double>(i) / count(order));
    }
    const auto vertex = triangulation.insert(element(order[i]), hint);
    if (vertex == typename Triangulation::Vertex_handle())
    {
      continue; // hidden
    }
    const Index number = firstNumber + static_cast<Index>(order[i]);
    Index& known = vertex->info().value; // of a point at the very same place
    known = known == None ? number : std::min(number, known);
    hint = vertex->cell();
  }
  execution.report(1);
}

/// The finite cells as arrays. Numbers the cells in passing.
template <typename Triangulation>
Tetrahedra arrays(const Triangulation& triangulation, const Execution& execution)
{
  Tetrahedra result;
  if (triangulation.dimension() < 3)
  {
    return result;
  }
  for (const auto cell : triangulation.all_cell_handles())
  {
    cell->info().value = None;
  }
  Index number = 0;
  for (const auto cell : triangulation.finite_cell_handles())
  {
    cell->info().value = number++;
    execution.pollAt(number);
  }
  result.cells.reserve(number);
  result.neighbors.reserve(number);
  for (const auto cell : triangulation.finite_cell_handles())
  {
    Tetrahedron corners, neighbors;
    for (int i = 0; i < 4; ++i)
    {
      corners[i] = cell->vertex(i)->info().value;
      neighbors[i] = cell->neighbor(i)->info().value;
    }
    result.cells.push_back(corners);
    result.neighbors.push_back(neighbors);
    execution.pollAt(count(result.cells));
  }
  return result;
}

/// A number without pattern for each number.
std::uint32_t scrambled(std::uint32_t x)
{
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

Kernel::Point_3 kernelPoint(const Point& p)
{
  return { p.x(), p.y(), p.z() };
}
}

Ball jittered(const Ball& ball, Index number)
{
  const double change = 1e-9 * (scrambled(number) / 4294967296.0 - 0.5);
  return { ball.center, ball.radius * (1 + change) };
}

Tetrahedra delaunay(const std::vector<Point>& points, const Execution& execution)
{
  std::vector<Kernel::Point_3> kernelPoints;
  kernelPoints.reserve(points.size());
  for (const Point& p : points)
  {
    kernelPoints.push_back(kernelPoint(p));
  }
  Delaunay triangulation;
  insertInOrder(
    triangulation, spatialOrder(kernelPoints), [&](std::size_t i) { return kernelPoints[i]; }, 0,
    execution);
  return arrays(triangulation, execution);
}

struct RegularTriangulation::Implementation
{
  Regular triangulation;
  Index inserted = 0;
};

RegularTriangulation::RegularTriangulation()
  : implementation(std::make_unique<Implementation>())
{
}
RegularTriangulation::~RegularTriangulation() = default;
RegularTriangulation::RegularTriangulation(RegularTriangulation&&) noexcept = default;
RegularTriangulation& RegularTriangulation::operator=(RegularTriangulation&&) noexcept = default;

RegularTriangulation RegularTriangulation::copy() const
{
  RegularTriangulation result;
  *result.implementation = *this->implementation;
  return result;
}

void RegularTriangulation::insert(const std::vector<Ball>& balls, const Execution& execution)
{
  std::vector<Kernel::Point_3> centers;
  centers.reserve(balls.size());
  for (const Ball& ball : balls)
  {
    centers.push_back(kernelPoint(ball.center));
  }
  const auto weighted = [&](std::size_t i) {
    return Regular::Weighted_point(centers[i], balls[i].radius * balls[i].radius);
  };
  insertInOrder(this->implementation->triangulation, spatialOrder(centers), weighted,
    this->implementation->inserted, execution);
  this->implementation->inserted += count(balls);
}

std::vector<Tetrahedron> RegularTriangulation::replacedBy(const Ball& ball) const
{
  const Regular& triangulation = this->implementation->triangulation;
  const Regular::Weighted_point added(kernelPoint(ball.center), ball.radius * ball.radius);
  std::vector<Tetrahedron> result;
  if (triangulation.dimension() < 3)
  {
    return result;
  }
  const Regular::Cell_handle at = triangulation.locate(added);
  if (triangulation.side_of_power_sphere(at, added, true) != CGAL::ON_BOUNDED_SIDE)
  {
    return result;
  }
  std::vector<Regular::Cell_handle> cells;
  triangulation.find_conflicts(
    added, at, CGAL::Emptyset_iterator(), std::back_inserter(cells), CGAL::Emptyset_iterator());
  for (const Regular::Cell_handle cell : cells)
  {
    Tetrahedron& corners = result.emplace_back();
    for (int k = 0; k < 4; ++k)
    {
      corners[k] = cell->vertex(k)->info().value;
    }
  }
  return result;
}

std::vector<Index> RegularTriangulation::numbersBefore() const
{
  std::vector<Index> result;
  if (this->implementation->triangulation.dimension() == 3)
  {
    for (const auto cell : this->implementation->triangulation.finite_cell_handles())
    {
      result.push_back(cell->info().value);
    }
  }
  return result;
}

Tetrahedra RegularTriangulation::tetrahedra(const Execution& execution) const
{
  return arrays(this->implementation->triangulation, execution);
}
}
