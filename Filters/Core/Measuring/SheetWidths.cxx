// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/SheetWidths.h"

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

/// For each point the largest distance of two samples that a triangle there is equally far from; 0 without a triangle.
std::vector<double> sampleDistances(const MedialAxis& axis)
{
  std::vector<double> result(axis.points.size(), 0);
  const Index first = axis.cells.firstTriangle();
  for (Index t = 0; t < count(axis.cells.triangles); ++t)
  {
    for (const Index p : axis.cells.triangles[t])
    {
      result[p] = std::max(result[p], axis.siteViews[first + t].lambda);
    }
  }
  return result;
}

/// How thick the solid is at a point. Between flat walls this is the distance of samples on both sides, and the
/// ball bulges between them; in a rod it is the ball, and both samples may lie on the same side of it. The
/// wider the sheet, the more the samples count.
double thicknessAt(double diameter, double width, double distance)
{
  constexpr double flat = 1.5; // width in diameters from which on a sheet lies between flat walls
  if (!(distance > 0 && distance < diameter))
  {
    return diameter;
  }
  const double share = std::clamp((width / diameter - 1) / (flat - 1), 0.0, 1.0);
  return diameter + share * (distance - diameter);
}
}

SheetWidths sheetWidths(const MedialAxis& axis, const AxisEdges& edges,
  const std::vector<double>& times, const Execution& execution)
{
  const std::vector<double> distance = sampleDistances(axis);
  SheetWidths result;
  result.summit = steepest(axis, edges, times);
  climb(result.summit, execution);
  for (const Index top : result.summit)
  {
    const double width = 2 * times[top];
    const double thickness = thicknessAt(2 * axis.radii[top], width, distance[top]);
    result.width.push_back(width);
    result.thickness.push_back(thickness);
    result.ratio.push_back(thickness > 0 ? width / thickness : 1);
  }
  return result;
}
}
