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
constexpr double noSheet = std::numeric_limits<double>::infinity();

/// When the sheets at each point have burnt, infinite where there are none. Where lines end at a sheet
/// the erosion thickness of the point tells of the lines; then that of the triangles counts.
std::vector<double> sheetBurnTimes(const MedialAxis& axis)
{
  std::vector<double> result(axis.points.size(), noSheet);
  const Index first = axis.cells.firstTriangle();
  for (Index t = 0; t < count(axis.cells.triangles); ++t)
  {
    for (const Index p : axis.cells.triangles[t])
    {
      result[p] = std::min(result[p], axis.cellErosion[first + t]);
    }
  }
  std::vector<char> hasLine(axis.points.size(), 0);
  for (const Edge& line : axis.cells.edges)
  {
    hasLine[line[0]] = hasLine[line[1]] = 1;
  }
  for (Index p = 0; p < count(axis.points); ++p)
  {
    const double erosion = hasLine[p] ? std::min(axis.erosion[p], result[p]) : axis.erosion[p];
    result[p] = result[p] < noSheet ? erosion + axis.radii[p] : noSheet;
  }
  return result;
}

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
  const std::vector<double> time = sheetBurnTimes(axis);
  SheetWidths result;
  result.summit = steepest(axis, edges, time);
  climb(result.summit, execution);
  for (const Index top : result.summit)
  {
    const double radius = axis.radii[top];
    const double half = time[top] < noSheet ? time[top] : radius;
    result.width.push_back(2 * half);
    result.thickness.push_back(2 * radius);
    result.ratio.push_back(radius > 0 ? half / radius : 1);
  }
  return result;
}
}
