// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/CrustEdits.h"

#include <algorithm>

namespace medial
{
std::vector<char> CrustEdits::usedPoints() const
{
  std::vector<char> used(this->crust.points.size(), 0);
  for (const Triangle& t : this->crust.triangles)
  {
    for (int k = 0; k < 3 && t[0] != None; ++k)
    {
      used[t[k]] = 1;
    }
  }
  return used;
}

Point CrustEdits::towardsNeighbors(Index point)
{
  const std::vector<Index> neighbors = this->edits.neighbors(point);
  Point sum = Point::Zero();
  for (const Index other : neighbors)
  {
    sum += this->at(other) - this->at(point);
  }
  return sum / std::max<double>(1, static_cast<double>(neighbors.size()));
}

bool CrustEdits::contract(const Edge& edge)
{
  const auto [goes, stays] = this->edits.fewerFirst(edge);
  if (!this->edits.contract(goes, stays))
  {
    return false;
  }
  if (this->isSample(goes) && !this->isSample(stays))
  {
    this->crust.points[stays] = this->at(goes);
    this->crust.sampleOfPoint[stays] = this->crust.sampleOfPoint[goes];
  }
  return true;
}

bool CrustEdits::flip(Index triangle, int corner)
{
  const Index other = this->edits.across(triangle, corner);
  if (!this->edits.flip(triangle, corner))
  {
    return false;
  }
  this->crust.innerBall[triangle] = this->crust.innerBall[other];
  this->crust.outerBall[triangle] = this->crust.outerBall[other];
  return true;
}

void CrustEdits::move(Index point, const Point& by)
{
  this->crust.points[point] += by;
  this->crust.sampleOfPoint[point] = None;
}

void CrustEdits::finish()
{
  const std::vector<char> used = this->usedPoints();
  std::vector<Index> number(used.size(), None);
  Index points = 0;
  for (Index p = 0; p < count(used); ++p)
  {
    if (used[p])
    {
      this->crust.points[points] = this->crust.points[p];
      this->crust.sampleOfPoint[points] = this->crust.sampleOfPoint[p];
      number[p] = points++;
    }
  }
  this->crust.points.resize(points);
  this->crust.sampleOfPoint.resize(points);
  Index triangles = 0;
  for (Index t = 0; t < count(this->crust.triangles); ++t)
  {
    const Triangle corners = this->crust.triangles[t];
    if (corners[0] != None)
    {
      this->crust.triangles[triangles] = { number[corners[0]], number[corners[1]],
        number[corners[2]] };
      this->crust.innerBall[triangles] = this->crust.innerBall[t];
      this->crust.outerBall[triangles++] = this->crust.outerBall[t];
    }
  }
  this->crust.triangles.resize(triangles);
  this->crust.innerBall.resize(triangles);
  this->crust.outerBall.resize(triangles);
}
}
