// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/NearDuplicates.h"

#include "Base/Frame.h"
#include "Base/Neighbors.h"

#include <algorithm>
#include <limits>

// Each point asks a k-d tree for those near it, unless it has been decided with an earlier one. With it
// all that lie within the tolerance are decided: as its copies, or as a sampling that is dense. So
// points that are asked about are more than the tolerance apart, and each finds few others that were:
// O(n log n) for n points.

namespace medial
{
namespace
{
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
  const Neighbors neighbors(points);
  std::vector<char> decided(points.size(), 0);
  for (Index p = 0; p < count(points); ++p)
  {
    if (decided[p])
    {
      continue;
    }
    std::vector<Index> near = neighbors.within(p, separation * tolerance);
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
