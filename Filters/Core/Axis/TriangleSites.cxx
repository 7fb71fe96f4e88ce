// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/TriangleSites.h"

#include "Base/Frame.h"
#include "Base/Lists.h"
#include "Base/Predicates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{
/// The first element that the three ascending lists share and of which `accept` approves, or None.
template <typename Accept>
Index firstShared(IndexLists::View a, IndexLists::View b, IndexLists::View c, const Accept& accept)
{
  const Index *i = a.begin(), *j = b.begin(), *k = c.begin();
  while (i != a.end() && j != b.end() && k != c.end())
  {
    const Index most = std::max({ *i, *j, *k });
    if (*i == most && *j == most && *k == most)
    {
      if (accept(most))
      {
        return most;
      }
      ++i;
    }
    else
    {
      i = std::lower_bound(i, a.end(), most);
      j = std::lower_bound(j, b.end(), most);
      k = std::lower_bound(k, c.end(), most);
    }
  }
  return None;
}
}

Index sharedSample(const PolarBalls& polarBalls, const Triangle& balls)
{
  const auto center = [&](int k) -> const Point& { return polarBalls.balls[balls[k]].center; };
  const IndexLists& lists = polarBalls.ballSamples;
  return firstShared(lists[balls[0]], lists[balls[1]], lists[balls[2]], [&](Index s) {
    return orientation(center(0), center(1), center(2), polarBalls.samples[s]) > 0;
  });
}

std::optional<Point> boundaryIntersection(const Ball& a, const Ball& b, const Ball& c)
{
  const Point u = b.center - a.center, v = c.center - a.center;
  const Point normal = u.cross(v);
  const double area = normal.squaredNorm();
  const auto half = [&a](const Ball& ball, const Point& edge) {
    return 0.5 * (a.radius * a.radius - ball.radius * ball.radius + edge.squaredNorm());
  };
  // The point of the plane with equal power to all three, then up along the normal.
  const Point base = (half(b, u) * v.cross(normal) + half(c, v) * normal.cross(u)) / area;
  const double height = a.radius * a.radius - base.squaredNorm();
  if (!(area > 0) || !(height > 0))
  {
    return std::nullopt;
  }
  const Point p = a.center + base + normal * std::sqrt(height / area);
  for (const Ball& ball : { a, b, c })
  {
    if (!(std::abs((p - ball.center).norm() - ball.radius) < coincident))
    {
      return std::nullopt; // centres so nearly on a line that doubles can't tell where
    }
  }
  return p;
}
}
