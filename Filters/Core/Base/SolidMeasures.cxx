// SPDX-License-Identifier: BSD-3-Clause
#include "Base/SolidMeasures.h"

#include "Base/DisjointSets.h"
#include "Base/EdgeTable.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace medial
{
namespace
{
/// Fills closed and manifold. Corner 3 * triangle + k is where a triangle has a point; edge 3 * triangle + k
/// begins there. Corners at one point are joined across the edges there; a manifold has one group of corners at
/// each point.
void checkSurface(const std::vector<Triangle>& triangles, std::size_t pointCount,
  SolidMeasures& result, const Execution& execution)
{
  const Index cornerCount = 3 * count(triangles), joined = cornerCount;
  const auto next = [](Index corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
  const auto pointAt = [&](Index corner) { return triangles[corner / 3][corner % 3]; };
  EdgeTable edges(cornerCount / 2); // the edge that is met first; `joined` after the second one
  DisjointSets fans(cornerCount);
  Index pairs = 0;
  for (Index corner = 0; corner < cornerCount; ++corner)
  {
    execution.pollAt(corner);
    const Index a = pointAt(corner), b = pointAt(next(corner));
    Index& first = edges.numberOf(std::min(a, b), std::max(a, b), corner);
    if (first != corner && first != joined && pointAt(first) == b)
    {
      fans.unite(corner, next(first));
      fans.unite(next(corner), first);
      first = joined;
      ++pairs;
    }
  }
  result.closed = 2 * pairs == cornerCount;
  std::vector<Index> fanAt(pointCount, None);
  result.manifold = result.closed;
  for (Index corner = 0; corner < cornerCount; ++corner)
  {
    Index& fan = fanAt[pointAt(corner)];
    fan = fan == None ? fans.find(corner) : fan;
    result.manifold = result.manifold && fan == fans.find(corner);
  }
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
  checkSurface(triangles, points.size(), result, execution);
  measureSolid(points, triangles, result);
  return result;
}
}
