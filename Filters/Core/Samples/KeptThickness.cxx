// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/KeptThickness.h"

#include "Samples/BlueNoise.h"
#include "Samples/LocalThickness.h"

#include <algorithm>

namespace medial
{
namespace
{
/// The middles of triangles.
std::vector<SurfacePoint> middles(const TriangleSet& surface)
{
  std::vector<SurfacePoint> result;
  result.reserve(surface.triangles.size());
  for (Index t = 0; t < count(surface.triangles); ++t)
  {
    result.push_back(middleOf(surface, t));
  }
  return result;
}
}

std::vector<Point> withThicknessKept(const std::vector<Point>& before,
  const std::vector<Point>& smoothed, const std::vector<Triangle>& triangles, double most,
  const Execution& execution)
{
  if (triangles.empty())
  {
    return smoothed; // nothing is near to anything
  }
  const TriangleSet surface = triangleSet(before, triangles);
  const SurfaceTree tree(before, triangles);
  const std::vector<double> ofTriangle =
    localThickness(middles(surface), tree, surface.normals, most, {}, execution);
  std::vector<double> thickness(before.size(), most);
  for (Index t = 0; t < count(triangles); ++t)
  {
    for (const Index corner : triangles[t])
    {
      thickness[corner] = std::min(thickness[corner], ofTriangle[t]);
    }
  }
  std::vector<Point> result = smoothed;
  for (Index i = 0; i < count(result); ++i)
  {
    const Point move = smoothed[i] - before[i];
    const double allowed = thickness[i] / 4, length = move.norm();
    if (thickness[i] < most && length > allowed)
    {
      result[i] = before[i] + allowed / length * move;
    }
  }
  return result;
}
}
