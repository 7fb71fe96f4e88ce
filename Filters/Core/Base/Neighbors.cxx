// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Neighbors.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace medial
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Numbered = std::pair<Kernel::Point_3, Index>;
using Traits = CGAL::Search_traits_adapter<Numbered, CGAL::First_of_pair_property_map<Numbered>,
  CGAL::Search_traits_3<Kernel>>;
using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;

Kernel::Point_3 toKernel(const Point& p)
{
  return { p.x(), p.y(), p.z() };
}
}

struct Neighbors::Implementation
{
  const std::vector<Point>& points;
  Search::Tree tree;
};

Neighbors::Neighbors(const std::vector<Point>& points)
  : implementation(new Implementation{ points, {} })
{
  for (Index i = 0; i < count(points); ++i)
  {
    this->implementation->tree.insert({ toKernel(points[i]), i });
  }
  if (!points.empty()) // CGAL has no empty trees
  {
    this->implementation->tree.build(); // else the first search would build it, on each thread
  }
}

Neighbors::~Neighbors() = default;

std::vector<Index> Neighbors::nearest(const Point& place, Index howMany) const
{
  if (this->implementation->points.empty())
  {
    return {};
  }
  const Search search(this->implementation->tree, toKernel(place), static_cast<unsigned>(howMany));
  std::vector<std::pair<double, Index>> found;
  for (const auto& [numbered, squaredDistance] : search)
  {
    found.emplace_back(squaredDistance, numbered.second);
  }
  std::sort(found.begin(), found.end()); // the lowest number first among equals
  std::vector<Index> result;
  result.reserve(found.size());
  for (const auto& entry : found)
  {
    result.push_back(entry.second);
  }
  return result;
}

std::vector<Index> Neighbors::nearest(Index point, Index howMany) const
{
  std::vector<Index> result = this->nearest(this->implementation->points[point], howMany + 1);
  const auto self = std::find(result.begin(), result.end(), point);
  result.erase(self == result.end() ? result.end() - 1 : self);
  return result;
}

std::vector<Index> Neighbors::within(Index point, double distance) const
{
  return this->within(this->implementation->points[point], distance);
}

std::vector<Index> Neighbors::within(const Point& place, double distance) const
{
  if (this->implementation->points.empty())
  {
    return {};
  }
  const Numbered center{ toKernel(place), None };
  std::vector<Numbered> found;
  this->implementation->tree.search(
    std::back_inserter(found), CGAL::Fuzzy_sphere<Traits>(center, distance));
  std::vector<Index> result;
  result.reserve(found.size());
  for (const Numbered& near : found)
  {
    result.push_back(near.second);
  }
  return result;
}

std::vector<double> meanDistances(
  const std::vector<Point>& points, const Neighbors& neighbors, const Execution& execution)
{
  std::vector<double> result(points.size(), 0);
  execution.forEach(count(points), [&](Index i) {
    const std::vector<Index> near = neighbors.nearest(i, 6);
    for (const Index other : near)
    {
      result[i] += (points[other] - points[i]).norm() / count(near);
    }
  });
  return result;
}
}
