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
/// Fills closed and manifold. Corner 3 * triangle + k is where a triangle has a point. Corners at one
/// point are joined across the edges there; a manifold has one group of corners at each point.
void checkSurface(const std::vector<Triangle>& triangles, std::size_t pointCount,
  SolidMeasures& result, const Execution& execution)
{
  EdgeTable triangleAt(3 * triangles.size());
  result.closed = true;
  for (Index t = 0; t < count(triangles); ++t)
  {
    execution.pollAt(t);
    for (int k = 0; k < 3; ++k)
    {
      const Index a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      result.closed = triangleAt.insert(a, b, t) && result.closed;
    }
  }
  DisjointSets fans(3 * count(triangles));
  for (Index t = 0; t < count(triangles); ++t)
  {
    execution.pollAt(t);
    for (int k = 0; k < 3; ++k)
    {
      const Index a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      const Index opposite = triangleAt.find(b, a);
      if (opposite == None)
      {
        result.closed = false;
        continue;
      }
      const Triangle& other = triangles[opposite];
      for (int j = 0; j < 3; ++j)
      {
        if (other[j] == a)
        {
          fans.unite(3 * t + k, 3 * opposite + j);
        }
      }
    }
  }
  std::vector<Index> fanAt(pointCount, None);
  result.manifold = result.closed;
  for (Index corner = 0; corner < 3 * count(triangles); ++corner)
  {
    Index& fan = fanAt[triangles[corner / 3][corner % 3]];
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
