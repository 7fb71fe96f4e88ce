// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/FreePlaces.h"

#include "Base/Frame.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

// A place that is taken is left for the nearest free node of a grid around it, whose step is
// `coincident`. A vertex takes what is nearer than half a step, so it takes one node at most: of n + 1
// nodes one is free where n vertices are near. So the search ends, without a tolerance of its own.
//
// Vertices are looked up in cubes as wide as half a step. With n vertices and m places to find this
// takes O((n + m) log n) time, as long as few nodes are taken.

namespace medial
{
namespace
{
constexpr double apart = 0.5 * coincident;
}

FreePlaces::FreePlaces(const std::vector<Point>& taken)
{
  for (const Point& place : taken)
  {
    this->cubes[cube(place)].push_back(place);
  }
}

Point FreePlaces::takeNear(const Point& place)
{
  Point result = this->freeNear(place);
  this->cubes[cube(result)].push_back(result);
  return result;
}

FreePlaces::Cube FreePlaces::cube(const Point& place)
{
  Cube result;
  for (int k = 0; k < 3; ++k)
  {
    result[k] = static_cast<std::int64_t>(std::floor(place[k] / apart));
  }
  return result;
}

bool FreePlaces::isFree(const Point& place) const
{
  const Cube center = cube(place);
  for (int i = 0; i < 27; ++i)
  {
    const auto found =
      this->cubes.find({ center[0] + i % 3 - 1, center[1] + i / 3 % 3 - 1, center[2] + i / 9 - 1 });
    if (found != this->cubes.end() &&
      std::any_of(found->second.begin(), found->second.end(),
        [&place](const Point& taken) { return (taken - place).norm() < apart; }))
    {
      return false;
    }
  }
  return true;
}

/// The nodes around the place in growing cubes, itself first.
Point FreePlaces::freeNear(const Point& place) const
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
          Point node = place + coincident * Point(i, j, k);
          if (this->isFree(node))
          {
            return node;
          }
        }
      }
    }
  }
}
}
