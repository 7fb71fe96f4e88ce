// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/SheetWidths.h"

#include "Measuring/BurnTimes.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace medial
{
namespace
{
/// For each point where the steepest side of a triangle leads up; itself at a summit.
std::vector<Index> steepest(
  const MedialAxis& axis, const AxisEdges& edges, const std::vector<double>& time)
{
  std::vector<Index> result(axis.points.size());
  std::iota(result.begin(), result.end(), 0);
  std::vector<double> slopes(axis.points.size(), 0);
  for (Index e = 0; e < count(edges.points); ++e)
  {
    auto [low, high] = edges.points[e];
    if (edges.triangles[e].size() == 0)
    {
      continue;
    }
    if (time[low] > time[high] || (time[low] == time[high] && low < high))
    {
      std::swap(low, high); // of equal times the lower number is higher up
    }
    const double length = (axis.points[low] - axis.points[high]).norm();
    const double rise = time[high] - time[low];
    const double slope = length > 0 ? rise / length : std::numeric_limits<double>::max();
    const bool first = result[low] == low;
    if (first || slope > slopes[low] || (slope == slopes[low] && high < result[low]))
    {
      result[low] = high;
      slopes[low] = slope;
    }
  }
  return result;
}

/// Follows all chains to their ends, and shortens them on the way.
void climb(std::vector<Index>& next, const Execution& execution)
{
  for (Index p = 0; p < count(next); ++p)
  {
    execution.pollAt(p);
    Index top = p;
    while (next[top] != top)
    {
      top = next[top];
    }
    for (Index i = p; next[i] != top;)
    {
      i = std::exchange(next[i], top);
    }
  }
}
}

SheetWidths sheetWidths(const MedialAxis& axis, const AxisEdges& edges, const Execution& execution)
{
  const std::vector<double> time = burnTimes(axis);
  SheetWidths result;
  result.summit = steepest(axis, edges, time);
  climb(result.summit, execution);
  for (const Index top : result.summit)
  {
    const double radius = axis.radii[top];
    result.width.push_back(2 * time[top]);
    result.thickness.push_back(2 * radius);
    result.ratio.push_back(radius > 0 ? time[top] / radius : 1);
  }
  return result;
}
}
