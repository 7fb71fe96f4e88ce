// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/LargestBalls.h"

#include "Base/Neighbors.h"

#include <algorithm>

namespace medial
{
namespace
{
std::vector<Index> numbersOf(
  const PolarBalls& balls, Side side, const std::function<bool(Index)>& counts)
{
  std::vector<Index> result;
  for (Index b = 0; b < count(balls.balls); ++b)
  {
    if (balls.sides[b] == side && (!counts || counts(b)))
    {
      result.push_back(b);
    }
  }
  return result;
}

std::vector<Ball> some(const PolarBalls& balls, const std::vector<Index>& numbers)
{
  std::vector<Ball> result;
  result.reserve(numbers.size());
  for (const Index b : numbers)
  {
    result.push_back(balls.balls[b]);
  }
  return result;
}
}

LargestBalls::LargestBalls(
  const PolarBalls& balls, Side side, const std::function<bool(Index)>& counts)
  : numbers(numbersOf(balls, side, counts))
  , tree(some(balls, this->numbers))
{
}

Index LargestBalls::around(const Point& place, double tolerance) const
{
  const Index found = this->tree.largestAround(place, tolerance);
  return found == None ? None : this->numbers[found];
}

Index LargestBalls::leastPower(const Point& place) const
{
  const Index found = this->tree.leastPower(place);
  return found == None ? None : this->numbers[found];
}

std::vector<Index> largestBallsAtSamples(
  const PolarBalls& balls, Side side, double tolerance, const Execution& execution)
{
  std::vector<Index> order =
    numbersOf(balls, side, [&balls](Index b) { return !balls.touchesGuard[b]; });
  std::stable_sort(order.begin(), order.end(),
    [&balls](Index a, Index b) { return balls.balls[a].radius > balls.balls[b].radius; });
  const Neighbors neighbors(balls.samples);
  Neighbors::Left left = neighbors.all();
  std::vector<Index> result(balls.samples.size(), None);
  for (Index i = 0; i < count(order); ++i)
  {
    execution.pollAt(i);
    const Ball& ball = balls.balls[order[i]];
    neighbors.takeEachWithin(
      ball.center, ball.radius + tolerance, left, [&](Index sample) { result[sample] = order[i]; });
  }
  return result;
}
}
