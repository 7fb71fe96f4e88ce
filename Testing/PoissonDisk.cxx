// SPDX-License-Identifier: BSD-3-Clause
#include "PoissonDisk.h"

#include <array>
#include <cmath>
#include <map>

namespace shapes
{
namespace
{
/// Accepted points in cubes as wide as the spacing.
class Darts
{
public:
  explicit Darts(double theSpacing)
    : spacing(theSpacing)
  {
  }

  bool isFree(const Point& point) const
  {
    const Cube centre = this->cube(point);
    for (int i = 0; i < 27; ++i)
    {
      const auto found = this->cubes.find(
        { centre[0] + i % 3 - 1, centre[1] + i / 3 % 3 - 1, centre[2] + i / 9 - 1 });
      if (found == this->cubes.end())
      {
        continue;
      }
      for (const std::size_t other : found->second)
      {
        if (length(this->points[other] - point) < this->spacing)
        {
          return false;
        }
      }
    }
    return true;
  }

  void add(const Point& point)
  {
    this->cubes[this->cube(point)].push_back(this->points.size());
    this->points.push_back(point);
  }

  std::vector<Point> points;

private:
  using Cube = std::array<int, 3>;

  Cube cube(const Point& point) const
  {
    Cube result;
    for (int k = 0; k < 3; ++k)
    {
      result[k] = static_cast<int>(std::floor(point[k] / this->spacing));
    }
    return result;
  }

  double spacing;
  std::map<Cube, std::vector<std::size_t>> cubes;
};
}

std::vector<Point> poissonDisk(
  const Draw& draw, double spacing, unsigned seed, const std::vector<Point>& fixed)
{
  Random random(seed);
  Darts darts(spacing);
  for (const Point& point : fixed)
  {
    darts.add(point);
  }
  std::size_t misses = 0;
  while (misses < 1000 + 6 * darts.points.size())
  {
    const Point point = draw(random);
    ++misses;
    if (darts.isFree(point))
    {
      darts.add(point);
      misses = 0;
    }
  }
  return darts.points;
}
}
