// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/PowerLocator.h"

#include "Base/Predicates.h"

#include <algorithm>

namespace medial
{
PowerLocator::PowerLocator(
  const Tetrahedra& cells, const std::vector<Ball>& balls, const Frame& frame)
  : mesh(cells)
  , localBalls(balls.size())
  , starts(mesh, localBalls)
{
  std::transform(balls.begin(), balls.end(), this->localBalls.begin(),
    [&frame](const Ball& ball) { return frame.toLocal(ball); });
}

bool PowerLocator::isBeyond(const Point& p, Index cell, int side) const
{
  const Triangle t = facet(this->mesh.cells[cell], side);
  const auto center = [&](int k) -> const Point& { return this->localBalls[t[k]].center; };
  return orientation(center(0), center(1), center(2), p) < 0;
}

Index PowerLocator::locate(const Point& p, Index start) const
{
  // A visibility walk ends in a regular triangulation; the limit is for cells that rounding turned.
  constexpr int stepLimit = 100000;
  Index cell = start, from = None;
  for (int step = 0; step < stepLimit && cell != None; ++step)
  {
    int k = 0;
    for (; k < 4; ++k)
    {
      const int i = (step + k) % 4;
      const Index next = this->mesh.neighbors[cell][i];
      if ((next == None || next != from) && this->isBeyond(p, cell, i))
      {
        from = cell;
        cell = next;
        break;
      }
    }
    if (k == 4)
    {
      return cell;
    }
  }
  return None;
}

Index PowerLocator::nearestBall(const Point& p, Index cell) const
{
  const auto power = [&](Index b) {
    const Ball& ball = this->localBalls[b];
    return (ball.center - p).squaredNorm() - ball.radius * ball.radius;
  };
  const Tetrahedron& corners = this->mesh.cells[cell];
  return *std::min_element(
    corners.begin(), corners.end(), [&](Index a, Index b) { return power(a) < power(b); });
}
}
