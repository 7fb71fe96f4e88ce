// SPDX-License-Identifier: BSD-3-Clause
#include "Base/SolidMeasures.h"

#include "Base/DisjointSets.h"
#include "Base/Lists.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace medial
{
namespace
{
/// For each edge, the one between the same points in the opposite direction; None where there is none, or
/// another edge has it. Edge 3 * triangle + k begins at corner k.
std::vector<Index> oppositeEdges(const std::vector<Triangle>& triangles, Index pointCount)
{
  const auto begin = [&](Index edge) { return triangles[edge / 3][edge % 3]; };
  const auto end = [&](Index edge) { return triangles[edge / 3][(edge + 1) % 3]; };
  const IndexLists atLowerEnd = listsByKey(pointCount, [&](const auto& add) {
    for (Index t = 0; t < count(triangles); ++t)
    {
      const auto [a, b, c] = triangles[t];
      add(std::min(a, b), 3 * t);
      add(std::min(b, c), 3 * t + 1);
      add(std::min(c, a), 3 * t + 2);
    }
  });
  std::vector<Index> result(3 * triangles.size(), None);
  std::vector<Index> lower(pointCount, None), first(pointCount); // by the upper end
  for (Index p = 0; p < pointCount; ++p)
  {
    for (const Index edge : atLowerEnd[p])
    {
      const Index upper = std::max(begin(edge), end(edge));
      if (lower[upper] != p)
      {
        lower[upper] = p;
        first[upper] = edge;
      }
      else if (result[first[upper]] == None && begin(first[upper]) == end(edge))
      {
        result[edge] = first[upper];
        result[first[upper]] = edge;
      }
    }
  }
  return result;
}

/// How often triangles at one point form a fan around it, in a closed surface.
Index fanCount(const std::vector<Index>& opposite)
{
  std::vector<char> met(opposite.size(), 0); // edges, as corners where they begin
  Index result = 0;
  for (Index start = 0; start < count(met); ++start)
  {
    result += !met[start];
    for (Index corner = start; !met[corner];)
    {
      met[corner] = 1;
      corner = opposite[corner % 3 == 0 ? corner + 2 : corner - 1];
    }
  }
  return result;
}

/// Fills closed and manifold. A manifold has one fan at each point.
void checkSurface(const std::vector<Triangle>& triangles, Index pointCount, SolidMeasures& result,
  const Execution& execution)
{
  const std::vector<Index> opposite = oppositeEdges(triangles, pointCount);
  execution.poll();
  result.closed = std::find(opposite.begin(), opposite.end(), None) == opposite.end();
  std::vector<char> used(pointCount, 0);
  for (const Triangle& t : triangles)
  {
    used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  result.manifold = result.closed && fanCount(opposite) == std::count(used.begin(), used.end(), 1);
  execution.poll();
}

/// Fills volume and Betti numbers.
void measureSolid(
  const std::vector<Point>& points, const std::vector<Triangle>& triangles, SolidMeasures& result)
{
  const Index n = count(points);
  DisjointSets pieces(n);
  std::vector<Index> euler(n, 0); // of each piece, doubled
  // Volumes seen from the origin, and from a point of the piece: the sign of a tiny one that is far from
  // the origin would be up to rounding.
  std::vector<double> volume(n, 0), ownVolume(n, 0);
  std::vector<char> used(n, 0);
  for (const Triangle& t : triangles)
  {
    pieces.unite(t[0], t[1]);
    pieces.unite(t[0], t[2]);
    used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  for (const Triangle& t : triangles)
  {
    const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const Index piece = pieces.find(t[0]);
    const Point& o = points[piece];
    volume[piece] += a.cross(b).dot(c) / 6;
    ownVolume[piece] += (a - o).cross(b - o).dot(c - o) / 6;
    euler[piece] -= 1; // one triangle less three halves of an edge, doubled
  }
  for (Index p = 0; p < n; ++p)
  {
    euler[pieces.find(p)] += used[p] ? 2 : 0;
  }
  result.betti = { 0, 0, 0 };
  result.volume = std::accumulate(volume.begin(), volume.end(), 0.0);
  for (Index p = 0; p < n; ++p)
  {
    if (used[p] && pieces.find(p) == p)
    {
      ++result.betti[ownVolume[p] > 0 ? 0 : 2];
      result.betti[1] += (4 - euler[p]) / 4;
    }
  }
}
}

SolidMeasures solidMeasures(const std::vector<Point>& points,
  const std::vector<Triangle>& triangles, const Execution& execution)
{
  SolidMeasures result{};
  checkSurface(triangles, count(points), result, execution);
  measureSolid(points, triangles, result);
  return result;
}
}
