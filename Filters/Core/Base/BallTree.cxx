// SPDX-License-Identifier: BSD-3-Clause
#include "Base/BallTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
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

BallTree::BallTree(const std::vector<Ball>& balls)
  : BallTree(balls, std::vector<Index>(balls.size(), 0))
{
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
    node.group = node.group == member.group ? node.group : Mixed;
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

// At most what the loop in `least` computes for any ball of the node, in spite of rounding: a search
// that skips a node never misses a smaller value.
//
// Let v be the vector from the node's box to the query's centre and w the one from a member's centre.
// - No coordinate of w is smaller in size than that of v, as computed: both are rounded differences,
//   the exact one of w isn't smaller in size, and rounding is monotone.
// - A computed norm has a relative error below 4 u, u = epsilon / 2: less than 3 u for the sum of
//   squares, half of which is left by the root, and u for the root itself. So norm(w) is at least
//   norm(v) (1 - 4 u) / (1 + 4 u), which is more than norm(v) (1 - 8 epsilon) is after its rounding.
// - Squares that underflow add an absolute error, below `underflow`.
// - Adding one radius and subtracting another is monotone too, and node.radius is the largest.
double BallTree::lowerBound(const Node& node, const Ball& ball)
{
  constexpr double shrink = 1 - 8 * std::numeric_limits<double>::epsilon();
  constexpr double underflow = 1e-150;
  const Point outside =
    (node.lower - ball.center).cwiseMax(ball.center - node.upper).cwiseMax(Point::Zero());
  const double distance = std::max(0.0, outside.norm() * shrink - underflow);
  return distance + ball.radius - node.radius;
}

double BallTree::distance(const Point& x, double enough) const
{
  return this->least({ x, 0 }, Nothing, enough);
}

double BallTree::protrusion(const Ball& ball, Index group, double enough) const
{
  return std::max(0.0, this->least(ball, group, enough));
}

// Depth first, the nearer child first; a node is skipped where its lower bound can't improve on the
// least value found so far.
double BallTree::least(const Ball& ball, Index leftOut, double enough) const
{
  struct Step
  {
    Index node;
    double bound;
  };
  double least = std::numeric_limits<double>::infinity();
  std::array<Step, 64> todo; // nodes are halved: each of at most 31 levels adds one
  std::size_t size = 0;
  const auto add = [&](Index number) {
    const Node& node = this->nodes[number];
    if (node.group != leftOut)
    {
      todo[size++] = { number, lowerBound(node, ball) };
    }
  };
  if (!this->nodes.empty())
  {
    add(0);
  }
  while (size > 0 && least > enough)
  {
    const Step step = todo[--size];
    if (step.bound >= least)
    {
      continue;
    }
    const Node& node = this->nodes[step.node];
    if (node.second != None)
    {
      const std::size_t before = size;
      add(step.node + 1);
      add(node.second);
      if (size == before + 2 && todo[before].bound < todo[before + 1].bound)
      {
        std::swap(todo[before], todo[before + 1]); // the nearer one next
      }
      continue;
    }
    for (Index i = node.begin; i < node.end; ++i)
    {
      const Member& other = this->members[i];
      if (other.group != leftOut)
      {
        least = std::min(
          least, (other.ball.center - ball.center).norm() + ball.radius - other.ball.radius);
      }
    }
  }
  return least;
}
}
