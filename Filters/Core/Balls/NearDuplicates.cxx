// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/NearDuplicates.h"

#include "Base/Frame.h"

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <iterator>
#include <limits>

// Each point asks a k-d tree for those near it, unless it has been decided with an earlier one. With it
// all that lie within the tolerance are decided: as its copies, or as a sampling that is dense. So
// points that are asked about are more than the tolerance apart, and each finds few others that were:
// O(n log n) for n points.

namespace medial
{
namespace
{
using Kernel = CGAL::Simple_cartesian<double>;
using Places = CGAL::Pointer_property_map<Kernel::Point_3>::const_type;
using Traits = CGAL::Search_traits_adapter<Index, Places, CGAL::Search_traits_3<Kernel>>;
using Sphere = CGAL::Fuzzy_sphere<Traits>;

/// How far copies stand apart from other points, in tolerances.
constexpr double separation = 10;
}

std::vector<Index> nearDuplicates(const std::vector<Point>& points, double tolerance)
{
  std::vector<Index> result(points.size(), None);
  if (!(tolerance > 0))
  {
    return result;
  }
  std::vector<Kernel::Point_3> places;
  std::vector<Index> numbers;
  for (const Point& p : points)
  {
    numbers.push_back(count(places));
    places.emplace_back(p.x(), p.y(), p.z());
  }
  const Traits traits{ Places(places.data()) };
  const CGAL::Kd_tree<Traits> tree(
    numbers.begin(), numbers.end(), CGAL::Kd_tree<Traits>::Splitter(), traits);
  std::vector<char> decided(points.size(), 0);
  std::vector<Index> near;
  for (Index p = 0; p < count(points); ++p)
  {
    if (decided[p])
    {
      continue;
    }
    near.clear();
    tree.search(std::back_inserter(near), Sphere(p, separation * tolerance, 0, traits));
    const auto within = std::partition(near.begin(), near.end(),
      [&](Index q) { return (points[q] - points[p]).norm() <= tolerance; });
    const bool standApart = within == near.end() && near.size() < points.size();
    std::for_each(near.begin(), within, [&](Index q) {
      decided[q] = 1;
      result[q] = standApart && q != p ? p : None;
    });
  }
  return result;
}

double defaultTolerance(const std::vector<Point>& points, double unit)
{
  const Eigen::AlignedBox3d box = boundingBox(points);
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const double rounded = std::max(unit, std::numeric_limits<double>::epsilon() * largest);
  return std::max(2 * rounded, 1e-7 * box.diagonal().norm());
}
}
