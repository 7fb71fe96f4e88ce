// SPDX-License-Identifier: BSD-3-Clause
#include "Numbers.h"
#include "Shapes.h"

#include <Eigen/Geometry> // cross()

#include <numeric>
#include <utility>

namespace shapes
{
std::vector<Point> scaled(std::vector<Point> points, double factor)
{
  for (Point& point : points)
  {
    point *= factor;
  }
  return points;
}

std::vector<Point> roundedToFloats(std::vector<Point> points)
{
  for (Point& point : points)
  {
    for (double& coordinate : point)
    {
      // Volatile, because GCC 12 at -O3 leaves the last coordinates of the vector as they are.
      const volatile auto rounded = static_cast<float>(coordinate);
      coordinate = rounded;
    }
  }
  return points;
}

std::vector<Point> moved(std::vector<Point> points, const Point& by)
{
  for (Point& point : points)
  {
    point += by;
  }
  return points;
}

std::vector<Point> rotated(std::vector<Point> points, unsigned seed, bool back)
{
  Random random(seed);
  const Point axis = direction(random);
  const double angle = uniform(random, 0.5, 2.5);
  const double along = cosine(angle), across = back ? -sine(angle) : sine(angle);
  for (Point& point : points)
  {
    const Point onAxis = dot(axis, point) * axis;
    point = onAxis + along * (point - onAxis) + across * axis.cross(point);
  }
  return points;
}

std::vector<Index> shuffledOrder(std::size_t size, unsigned seed)
{
  Random random(seed);
  std::vector<Index> order(size);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = size; i > 1; --i)
  {
    std::swap(order[i - 1], order[random() % i]);
  }
  return order;
}

std::vector<Point> reordered(const std::vector<Point>& points, const std::vector<Index>& order)
{
  std::vector<Point> result;
  for (const Index i : order)
  {
    result.push_back(points.at(static_cast<std::size_t>(i)));
  }
  return result;
}
}
