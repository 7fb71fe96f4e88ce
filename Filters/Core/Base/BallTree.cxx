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

// At most the distance of any centre in the node, as computed, in spite of rounding: a search that skips a node never
// misses a smaller value.
//
// Let v be the vector from the node's box to the point and w the one from a member's centre.
// - No coordinate of w is smaller in size than that of v, as computed: both are rounded differences,
//   the exact one of w isn't smaller in size, and rounding is monotone.
// - A computed norm has a relative error below 4 u, u = epsilon / 2: less than 3 u for the sum of
//   squares, half of which is left by the root, and u for the root itself. So norm(w) is at least
//   norm(v) (1 - 4 u) / (1 + 4 u), which is more than norm(v) (1 - 8 epsilon) is after its rounding.
// - Squares that underflow add an absolute error, below `underflow`.
double BallTree::lowerBound(const Node& node, const Point& x)
{
  constexpr double shrink = 1 - 8 * std::numeric_limits<double>::epsilon();
  constexpr double underflow = 1e-150;
  const Point outside = (node.lower - x).cwiseMax(x - node.upper).cwiseMax(Point::Zero());
  return std::max(0.0, outside.norm() * shrink - underflow);
}

double BallTree::distance(const Point& x, double enough) const
{
  return this->least({ x, 0 }, Nothing, enough);
}

bool BallTree::isWithin(const Point& x, double distance) const
{
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  const auto near = [&](double outside) { return outside <= distance ? outside : nowhere; };
  const auto bound = [&](const Node& node) { return near(lowerBound(node, x) - node.radius); };
  const auto value = [&](const Member& member) {
    return near((member.ball.center - x).norm() - member.ball.radius);
  };
  return this->search(bound, value, distance).number != None;
}

double BallTree::protrusion(const Ball& ball, Index group, double enough) const
{
  return std::max(0.0, this->least(ball, group, enough));
}

// Adding one radius and subtracting another is monotone, and node.radius is the largest.
double BallTree::least(const Ball& ball, Index leftOut, double enough) const
{
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  const auto bound = [&](const Node& node) {
    return node.group == leftOut ? nowhere
                                 : lowerBound(node, ball.center) + ball.radius - node.radius;
  };
  const auto value = [&](const Member& other) {
    return other.group == leftOut
      ? nowhere
      : (other.ball.center - ball.center).norm() + ball.radius - other.ball.radius;
  };
  return this->search(bound, value, enough).value;
}

Index BallTree::largestAround(const Point& x, double tolerance) const
{
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  const auto bound = [&](const Node& node) {
    return lowerBound(node, x) <= node.radius + tolerance ? -node.radius : nowhere;
  };
  const auto value = [&](const Member& member) {
    const Ball& ball = member.ball;
    return (ball.center - x).norm() <= ball.radius + tolerance ? -ball.radius : nowhere;
  };
  return this->search(bound, value, -nowhere).number;
}

Index BallTree::leastPower(const Point& x) const
{
  const auto power = [](double distance, double radius) {
    return (distance - radius) * (distance + radius);
  };
  const auto bound = [&](const Node& node) { return power(lowerBound(node, x), node.radius); };
  const auto value = [&](const Member& member) {
    return power((member.ball.center - x).norm(), member.ball.radius);
  };
  return this->search(bound, value, -std::numeric_limits<double>::infinity()).number;
}

// Depth first, the child with the smaller bound first; a node is skipped where it can't hold anything less than what
// was found so far.
template <typename Bound, typename Value>
BallTree::Least BallTree::search(const Bound& bound, const Value& value, double enough) const
{
  struct Step
  {
    Index node;
    double bound;
  };
  Least least;
  std::array<Step, 64> todo; // nodes are halved: each of at most 31 levels adds one
  std::size_t size = 0;
  const auto add = [&](Index number) {
    const double atLeast = bound(this->nodes[number]);
    if (atLeast < std::numeric_limits<double>::infinity())
    {
      todo[size++] = { number, atLeast };
    }
  };
  if (!this->nodes.empty())
  {
    add(0);
  }
  while (size > 0 && least.value > enough)
  {
    const Step step = todo[--size];
    if (step.bound > least.value)
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
        std::swap(todo[before], todo[before + 1]); // the one with the smaller bound next
      }
      continue;
    }
    for (Index i = node.begin; i < node.end; ++i)
    {
      const Member& member = this->members[i];
      const double its = value(member);
      if (its < least.value || (its == least.value && member.number < least.number))
      {
        least = { its, member.number };
      }
    }
  }
  return least;
}
}
