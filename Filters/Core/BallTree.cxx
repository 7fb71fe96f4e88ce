// SPDX-License-Identifier: BSD-3-Clause
#include "BallTree.h"

#include <algorithm>
#include <numeric>

namespace medial
{
double boundingDiagonal(const std::vector<Ball>& balls)
{
  Point lower = Point::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
  for (const Ball& ball : balls)
  {
    lower = lower.cwiseMin(ball.center - Point::Constant(ball.radius));
    upper = upper.cwiseMax(ball.center + Point::Constant(ball.radius));
  }
  return balls.empty() ? 0 : (upper - lower).norm();
}

BallTree::BallTree(std::vector<Ball> theBalls, std::vector<Index> theGroups)
  : balls(std::move(theBalls))
  , groups(std::move(theGroups))
  , order(balls.size())
{
  std::iota(this->order.begin(), this->order.end(), 0);
  if (!this->balls.empty())
  {
    this->build(0, count(this->balls));
  }
}

void BallTree::build(Index begin, Index end)
{
  constexpr Index leaf = 8;
  Node node{ this->balls[this->order[begin]].center, this->balls[this->order[begin]].center, 0,
    this->groups[this->order[begin]], begin, end, None };
  for (Index i = begin; i < end; ++i)
  {
    const Ball& ball = this->balls[this->order[i]];
    node.lower = node.lower.cwiseMin(ball.center);
    node.upper = node.upper.cwiseMax(ball.center);
    node.radius = std::max(node.radius, ball.radius);
    node.group = node.group == this->groups[this->order[i]] ? node.group : None;
  }
  const Index number = count(this->nodes);
  this->nodes.push_back(node);
  if (end - begin <= leaf)
  {
    return;
  }
  int axis = 0;
  (node.upper - node.lower).maxCoeff(&axis);
  const Index middle = begin + (end - begin) / 2;
  std::nth_element(this->order.begin() + begin, this->order.begin() + middle,
    this->order.begin() + end, [&](Index a, Index b) {
      const double x = this->balls[a].center[axis], y = this->balls[b].center[axis];
      return x != y ? x < y : a < b;
    });
  this->build(begin, middle);
  this->nodes[number].second = count(this->nodes);
  this->build(middle, end);
}

double BallTree::leastProtrusion(const Node& node, const Ball& ball)
{
  const Point outside =
    (node.lower - ball.center).cwiseMax(ball.center - node.upper).cwiseMax(Point::Zero());
  return outside.norm() + ball.radius - node.radius;
}

double BallTree::protrusion(const Ball& ball, Index group, double enough) const
{
  double least = std::numeric_limits<double>::infinity();
  std::vector<Index> todo;
  if (!this->nodes.empty())
  {
    todo.push_back(0);
  }
  while (!todo.empty() && least > enough)
  {
    const Node& node = this->nodes[todo.back()];
    const Index first = todo.back() + 1;
    todo.pop_back();
    if (node.group == group || leastProtrusion(node, ball) >= least)
    {
      continue;
    }
    if (node.second != None)
    {
      const bool secondIsNearer =
        leastProtrusion(this->nodes[node.second], ball) < leastProtrusion(this->nodes[first], ball);
      todo.push_back(secondIsNearer ? first : node.second);
      todo.push_back(secondIsNearer ? node.second : first);
      continue;
    }
    for (Index i = node.begin; i < node.end; ++i)
    {
      const Ball& other = this->balls[this->order[i]];
      if (this->groups[this->order[i]] != group)
      {
        least = std::min(least, (other.center - ball.center).norm() + ball.radius - other.radius);
      }
    }
  }
  return std::max(0.0, least);
}
}
