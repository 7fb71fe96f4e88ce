// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/DistinctSamples.h"

#include "Base/Errors.h"
#include "Base/NearDuplicates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace medial
{
namespace
{
bool lexicographicallyLess(const Point& a, const Point& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/// The samples without those at the very same place.
DistinctSamples distinctPlaces(const std::vector<Point>& samples)
{
  DistinctSamples result;
  result.frame = frameOf(samples);
  std::vector<Point> local(samples.size());
  std::transform(samples.begin(), samples.end(), local.begin(),
    [&](const Point& p) -> Point { return result.frame.toLocal(p); });
  std::vector<Index> order(samples.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return local[a] == local[b] ? a < b : lexicographicallyLess(local[a], local[b]);
  });
  result.duplicateOf.assign(samples.size(), None);
  for (const Index i : order)
  {
    if (!result.points.empty() && result.points.back() == local[i])
    {
      result.duplicateOf[i] = result.ids.back();
      continue;
    }
    result.points.push_back(local[i]);
    result.ids.push_back(i);
  }
  return result;
}

/// Takes points out that are copies of others.
/// @param original  for each point the one that it is a copy of, or None
void takeOut(DistinctSamples& distinct, const std::vector<Index>& original)
{
  std::vector<Index> standsFor(distinct.duplicateOf.size(), None); // for samples that are copies
  std::vector<Point> points;
  std::vector<Index> ids;
  for (Index p = 0; p < count(original); ++p)
  {
    if (original[p] == None)
    {
      points.push_back(distinct.points[p]);
      ids.push_back(distinct.ids[p]);
    }
    else
    {
      standsFor[distinct.ids[p]] = distinct.ids[original[p]];
    }
  }
  for (Index i = 0; i < count(standsFor); ++i)
  {
    Index& duplicateOf = distinct.duplicateOf[i];
    const Index place = duplicateOf == None ? i : duplicateOf;
    duplicateOf = standsFor[place] == None ? duplicateOf : standsFor[place];
  }
  distinct.points = std::move(points);
  distinct.ids = std::move(ids);
}

/// How far a sample is from the one that it counts as.
double distance(const std::vector<Point>& samples, const DistinctSamples& distinct, Index i)
{
  const Index original = distinct.duplicateOf[i];
  return original == None ? 0 : (samples[i] - samples[original]).norm();
}

void mergeNearDuplicates(
  const std::vector<Point>& samples, const MergeOptions& options, DistinctSamples& distinct)
{
  const double rounding = defaultTolerance(samples, options.unit);
  distinct.tolerance = options.tolerance < 0 ? rounding : options.tolerance;
  distinct.precision = std::min(rounding, distinct.tolerance);
  takeOut(distinct, nearDuplicates(distinct.points, distinct.tolerance * distinct.frame.scale));
  if (options.tolerance < 0 && options.clusters)
  {
    takeOut(distinct, clusteredDuplicates(distinct.points));
  }
  for (Index i = 0; i < count(samples); ++i)
  {
    const double moved = distance(samples, distinct, i);
    distinct.nearDuplicates += moved > 0 ? 1 : 0;
    distinct.tolerance = std::max(distinct.tolerance, moved);
  }
}

/// How samples lie that enclose no volume, in words, and what to do. Empty where they may enclose one.
struct Flatness
{
  std::string shape, remedy;
};

/// @param points  at least three, in local units
Flatness flatness(const std::vector<Point>& points, const Frame& frame)
{
  const std::string surfaceIsNeeded = "; points of a closed surface are needed";
  const auto farthest = [&points](const auto& distance) {
    return *std::max_element(points.begin(), points.end(),
      [&](const Point& p, const Point& q) { return distance(p) < distance(q); });
  };
  // Greedily, the largest tetrahedron from the first point: the farthest point b, then c farthest from
  // the line ab, then the point farthest from the plane abc.
  const Point a = points.front();
  const Point b = farthest([&](const Point& p) { return (p - a).norm(); });
  const Point direction = (b - a).normalized();
  const auto fromLine = [&](const Point& p) { return (p - a).cross(direction).norm(); };
  const Point c = farthest(fromLine);
  // Each coordinate is known to half a unit in the last place, given ones and local ones.
  const double rounding = 8 * std::numeric_limits<double>::epsilon() *
    (1 + frame.center.cwiseAbs().maxCoeff() * frame.scale);
  if (fromLine(c) <= rounding)
  {
    return { "on one line", surfaceIsNeeded };
  }
  const Point normal = (b - a).cross(c - a).normalized();
  const auto fromPlane = [&](const Point& p) { return std::abs((p - a).dot(normal)); };
  const double length = (b - a).norm(), width = fromLine(c);
  // Rounding tilts the plane through a, b, c by this much.
  if (fromPlane(farthest(fromPlane)) > rounding * std::max(1.0, length / width))
  {
    return {};
  }
  const double thin =
    1e-3; // only words depend on it: thinner samples are a line with some rounding
  if (width < thin * length)
  {
    return { text("within ", width / frame.scale, " of one line, which is ", length / frame.scale,
               " long: too near to it to tell whether they enclose a volume"),
      "; give tiny objects that are far from each other one by one, and remove points that are far "
      "from all others" };
  }
  return { "in one plane", surfaceIsNeeded };
}
}

DistinctSamples distinctSamples(const std::vector<Point>& samples, const MergeOptions& options)
{
  if (!std::isfinite(options.tolerance) || !std::isfinite(options.unit))
  {
    throw InvalidInput("the merge tolerance and the resolution of samples are lengths, not ",
      options.tolerance, " and ", options.unit);
  }
  DistinctSamples result = distinctPlaces(samples);
  mergeNearDuplicates(samples, options, result);
  return result;
}

Warnings mergeWarnings(const std::vector<Point>& samples, const DistinctSamples& distinct)
{
  if (100 * distinct.nearDuplicates <= count(samples))
  {
    return {};
  }
  Index first = 0;
  while (
    distinct.duplicateOf[first] == None || samples[distinct.duplicateOf[first]] == samples[first])
  {
    ++first;
  }
  return { { "merged_duplicates",
    text(distinct.nearDuplicates, " of ", samples.size(), " samples lie within ",
      distinct.tolerance,
      " of another one and count as that one. If they are different places, set the merge "
      "tolerance to 0."),
    distinct.nearDuplicates, samples[first], false } };
}

void requireVolume(const std::vector<Point>& samples, const DistinctSamples& distinct)
{
  const std::string merged = distinct.nearDuplicates == 0
    ? ""
    : text(", because ", distinct.nearDuplicates, " lie within the merge tolerance of others");
  if (distinct.points.size() < 4)
  {
    throw InvalidInput("there are only ", distinct.points.size(), " distinct samples", merged,
      "; at least 4 points of a closed surface are needed");
  }
  const Flatness flat = flatness(distinct.points, distinct.frame);
  if (flat.shape.empty())
  {
    return;
  }
  const bool isByMerging = distinct.nearDuplicates > 0 &&
    flatness(distinctPlaces(samples).points, distinct.frame).shape.empty();
  throw InvalidInput("all samples are ", flat.shape, isByMerging ? merged : "",
    isByMerging ? "; set a smaller merge tolerance" : flat.remedy);
}

std::array<Point, 8> guards(const std::vector<Point>& points)
{
  const Eigen::AlignedBox3d box = boundingBox(points);
  const double half = 2.5 * box.diagonal().norm();
  std::array<Point, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[i] = box.center() + half * Point(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  return corners;
}
}
