// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/RimTips.h"

#include <algorithm>
#include <numeric>

namespace medial
{
RimTips::RimTips(const AxisComplex& axis)
  : axis(axis)
  , begins(axis.points.size())
  , pieces(count(axis.points))
  , ballsLeft(axis.points.size(), 0)
{
  std::iota(this->begins.begin(), this->begins.end(), 0);
  for (Index c = 0; c < axis.cells.size(); ++c)
  {
    Index last = None;
    forPoints(axis.cells, c, [&](Index p) {
      this->pieces.unite(last == None ? p : last, p);
      last = p;
    });
  }
  for (Index p = 0; p < count(axis.points); ++p)
  {
    this->ballsLeft[this->pieces.find(p)] += axis.ballOfPoint[p] != None;
  }
}

double RimTips::thickness(Index end, Index to) const
{
  const Index from = this->begins[end];
  return this->axis.radii[from] + (this->axis.points[to] - this->axis.points[from]).norm() -
    this->axis.radii[to];
}

bool RimTips::mayGo(Index end, Index to, double most) const
{
  return !this->isLastBall(end) && this->thickness(end, to) <= most;
}

bool RimTips::mayGoFromSheet(Index end, Index to, double most) const
{
  constexpr double crooked = 2, inBall = 0.5;
  return this->mayGo(end, to, std::max(crooked * most, inBall * this->axis.radii[to]));
}

void RimTips::go(Index end, Index to)
{
  this->ballsLeft[this->pieces.find(end)] -= this->axis.ballOfPoint[end] != None;
  if (this->thickness(end, to) > this->thickness(to, to))
  {
    this->begins[to] = this->begins[end]; // the last one to arrive
  }
}

bool RimTips::isLastBall(Index point) const
{
  return this->axis.ballOfPoint[point] != None && this->ballsLeft[this->pieces.find(point)] == 1;
}
}
