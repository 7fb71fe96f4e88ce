// SPDX-License-Identifier: BSD-3-Clause
#include "Base/BallTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace medial
{
double boundingDiagonal(const std::vector<Ball>& balls)
{
  Eigen::AlignedBox3d box;
  for (const Ball& ball : balls)
  {
    box.extend(ball.center - Point::Constant(ball.radius));
    box.extend(ball.center + Point::Constant(ball.radius));
  }
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

BallTree::BallTree(const std::vector<Ball>& balls, const std::vector<Index>& groups)
{
  for (Index i = 0; i < count(balls); ++i)
  {
    this->members.push_back({ balls[i], groups[i], i });
  }
  if (!balls.empty())
  {
    this->build(0, count(balls));
  }
}

void BallTree::build(Index begin, Index end)
{
  constexpr Index leaf = 8;
  const Member& any = this->members[begin];
  Node node{ any.ball.center, any.ball.center, 0, any.group, begin, end, None };
  for (Index i = begin; i < end; ++i)
  {
    const Member& member = this->members[i];
    node.lower = node.lower.cwiseMin(member.ball.center);
    node.upper = node.upper.cwiseMax(member.ball.center);
    node.radius = std::max(node.radius, member.ball.radius);
    node.group = node.group == member.group ? node.group : None;
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
  const auto at = this->members.begin();
  std::nth_element(at + begin, at + middle, at + end, [axis](const Member& a, const Member& b) {
    const double x = a.ball.center[axis], y = b.ball.center[axis];
    return x != y ? x < y : a.number < b.number;
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
  struct Step
  {
    Index node;
    double bound;
  };
  double least = std::numeric_limits<double>::infinity();
  std::vector<Step> todo;
  const auto add = [&](Index number) {
    const Node& node = this->nodes[number];
    if (node.group != group)
    {
      todo.push_back({ number, leastProtrusion(node, ball) });
    }
  };
  if (!this->nodes.empty())
  {
    add(0);
  }
  while (!todo.empty() && least > enough)
  {
    const Step step = todo.back();
    todo.pop_back();
    if (step.bound >= least)
    {
      continue;
    }
    const Node& node = this->nodes[step.node];
    if (node.second != None)
    {
      const std::size_t before = todo.size();
      add(step.node + 1);
      add(node.second);
      if (todo.size() == before + 2 && todo[before].bound < todo[before + 1].bound)
      {
        std::swap(todo[before], todo[before + 1]); // the nearer one next
      }
      continue;
    }
    for (Index i = node.begin; i < node.end; ++i)
    {
      const Member& other = this->members[i];
      if (other.group != group)
      {
        least = std::min(
          least, (other.ball.center - ball.center).norm() + ball.radius - other.ball.radius);
      }
    }
  }
  return std::max(0.0, least);
}
}
