// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Midpoints.h"

#include "Base/Frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>

// A taken middle is left for the nearest free node of a grid around it, whose step is `coincident`. A
// vertex takes what is nearer than half a step, so it takes one node at most: among n nodes one is free
// unless n vertices are there. The search therefore ends, without a tolerance of its own.
//
// Vertices are looked up in cubes as wide as half a step, so that n vertices and m midpoints need O((n +
// m) log n) time, as long as few nodes are taken.

namespace medial
{
namespace
{
constexpr double apart = 0.5 * coincident;

/// Which places are taken.
class Places
{
public:
  void take(const Point& place) { this->cubes[cube(place)].push_back(place); }

  bool isFree(const Point& place) const
  {
    const Cube center = cube(place);
    for (int i = 0; i < 27; ++i)
    {
      const auto found = this->cubes.find(
        { center[0] + i % 3 - 1, center[1] + i / 3 % 3 - 1, center[2] + i / 9 - 1 });
      if (found != this->cubes.end() &&
        std::any_of(found->second.begin(), found->second.end(),
          [&place](const Point& taken) { return (taken - place).norm() < apart; }))
      {
        return false;
      }
    }
    return true;
  }

private:
  using Cube = std::array<std::int64_t, 3>;

  static Cube cube(const Point& place)
  {
    Cube result;
    for (int k = 0; k < 3; ++k)
    {
      result[k] = static_cast<std::int64_t>(std::floor(place[k] / apart));
    }
    return result;
  }

  std::map<Cube, std::vector<Point>> cubes;
};

/// The first free node of the grid about a place, in growing cubes.
Point freePlaceNear(const Point& middle, const Places& places)
{
  for (int reach = 0;; ++reach)
  {
    for (int i = -reach; i <= reach; ++i)
    {
      for (int j = -reach; j <= reach; ++j)
      {
        const bool onSide = std::abs(i) == reach || std::abs(j) == reach;
        for (int k = -reach; k <= reach; k += onSide ? 1 : 2 * reach)
        {
          const Point node = middle + coincident * Point(i, j, k);
          if (places.isFree(node))
          {
            return node;
          }
        }
      }
    }
  }
}
}

std::vector<Point> midpointPlaces(
  const std::vector<Point>& points, const std::vector<char>& merged, const std::vector<Edge>& sides)
{
  std::vector<Point> result;
  if (sides.empty())
  {
    return result;
  }
  Places places;
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    if (!merged[v])
    {
      places.take(points[v]);
    }
  }
  const auto at = [&](Index v) -> const Point& {
    return v < count(points) ? points[v] : result[v - count(points)];
  };
  for (const Edge& side : sides)
  {
    const Point place = freePlaceNear(0.5 * (at(side[0]) + at(side[1])), places);
    places.take(place);
    result.push_back(place);
  }
  return result;
}
}
