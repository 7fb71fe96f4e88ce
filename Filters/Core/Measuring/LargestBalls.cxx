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

std::vector<Index> largestBallsAt(const PolarBalls& balls, Side side,
  const std::vector<Point>& places, double tolerance, const Execution& execution)
{
  std::vector<Index> order =
    numbersOf(balls, side, [&balls](Index b) { return !balls.touchesGuard[b]; });
  std::stable_sort(order.begin(), order.end(),
    [&balls](Index a, Index b) { return balls.balls[a].radius > balls.balls[b].radius; });
  std::vector<Index> result(places.size(), None);
  const Index atOnce = std::max(count(order), Index(1) << 16); // an image has very many
  for (Index begin = 0; begin < count(places); begin += std::min(atOnce, count(places) - begin))
  {
    const Index size = std::min(atOnce, count(places) - begin);
    const std::vector<Point> some(places.begin() + begin, places.begin() + begin + size);
    const Neighbors neighbors(some);
    Neighbors::Left left = neighbors.all();
    for (Index i = 0; i < count(order); ++i)
    {
      execution.pollAt(i);
      const Ball& ball = balls.balls[order[i]];
      neighbors.takeEachWithin(ball.center, ball.radius + tolerance, left,
        [&](Index place) { result[begin + place] = order[i]; });
    }
    execution.report((begin + size) / double(count(places)));
  }
  return result;
}
}
