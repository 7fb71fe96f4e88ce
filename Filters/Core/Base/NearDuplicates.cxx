// SPDX-License-Identifier: BSD-3-Clause
#include "Base/NearDuplicates.h"

#include "Base/Frame.h"
#include "Base/Neighbors.h"

#include <algorithm>
#include <iterator>
#include <limits>

// nearDuplicates: each point asks a k-d tree for those near it, unless it has been decided with an
// earlier one. With it all that lie within the tolerance are decided: as its copies, or as a sampling
// that is dense. So points that are asked about are more than the tolerance apart, and each finds few
// others that were: O(n log n) for n points.
//
// clusteredDuplicates: a point asks for as many neighbors as a cluster may have. If they show no gap, many
// points are as near to each of these neighbors. So most of them can't be in a cluster, either, and
// needn't ask. Only the distance to the nearest other point is found for all: O(n log n).

namespace medial
{
namespace
{
/// How far copies stand apart from other points, in tolerances.
constexpr double separation = 10;

/// How far a cluster stands apart from other points, in units of its size. Samples that are independent of
/// each other are so near to each other once in 40,000 times. Then one of the two is enough, too.
constexpr double gap = 200;

/// A cluster has fewer points than this. So many might be an object of its own: fewer than 50 samples are
/// too few for a solid, see SampleDoubts.h.
constexpr Index clusterLimit = 50;

/// How many of the neighbors, nearest first, are in a cluster with the point: all before the last gap; 0
/// if there is none.
Index clusterSize(const std::vector<double>& distances)
{
  Index size = count(distances) - 1;
  while (size > 0 && distances[size] < gap * distances[size - 1])
  {
    --size;
  }
  return std::max<Index>(size, 0);
}
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

std::vector<Index> clusteredDuplicates(const std::vector<Point>& points)
{
  const Neighbors neighbors(points);
  std::vector<Index> result(points.size(), None);
  std::vector<char> decided(points.size(), 0);
  const auto distance = [&points](Index p, Index q) { return (points[q] - points[p]).norm(); };
  const auto isCrowded = [&](Index p, double radius) { // by that many points that near
    return radius < gap * distance(p, neighbors.nearest(p, 1).front());
  };
  for (Index p = 0; p < count(points); ++p)
  {
    if (decided[p])
    {
      continue;
    }
    const std::vector<Index> near = neighbors.nearest(p, clusterLimit - 1);
    std::vector<double> distances;
    std::transform(near.begin(), near.end(), std::back_inserter(distances),
      [&](Index q) { return distance(p, q); });
    const Index size = clusterSize(distances);
    const auto end = near.begin() + size;
    if (size > 0 && std::none_of(near.begin(), end, [&](Index q) { return decided[q]; }))
    {
      std::for_each(near.begin(), end, [&](Index q) {
        decided[q] = 1;
        result[q] = p;
      });
    }
    else if (count(near) == clusterLimit - 1)
    {
      std::for_each(near.begin(), near.end(),
        [&](Index q) { decided[q] = decided[q] || isCrowded(q, 2 * distances.back()); });
    }
    decided[p] = 1;
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
