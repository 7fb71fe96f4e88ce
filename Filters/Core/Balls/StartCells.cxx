// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/StartCells.h"

#include <cmath>
#include <limits>

namespace medial
{
namespace
{
/// A ball with this many cells and more has several in which walks begin.
constexpr Index many = 64;

/// Of how many cells of a ball one is kept. To compare k cells of n in a ring costs k, and then the walk n / k / 4
/// steps, each of which costs about as much as 16 comparisons.
Index stride(Index cellCount)
{
  return cellCount < many ? cellCount
                          : static_cast<Index>(std::sqrt(static_cast<double>(cellCount)) / 2);
}
}

StartCells::StartCells(const Tetrahedra& cells, const std::vector<Ball>& ballsOfCells)
  : mesh(cells)
  , balls(ballsOfCells)
  , cellCounts(ballsOfCells.size(), 0)
{
  for (const Tetrahedron& cell : cells.cells)
  {
    for (const Index ball : cell)
    {
      ++this->cellCounts[ball];
    }
  }
  std::vector<Index> seen;
  this->cellsAt = listsByKey(count(balls), [&](const auto& add) {
    seen.assign(balls.size(), 0);
    for (Index c = 0; c < count(cells.cells); ++c)
    {
      for (const Index ball : cells.cells[c])
      {
        if (seen[ball]++ % stride(this->cellCounts[ball]) == 0)
        {
          add(ball, c);
        }
      }
    }
  });
}

Index StartCells::towards(const Point& p, Index ball) const
{
  const IndexLists::View cells = this->cellsAt[ball];
  if (cells.size() == 1)
  {
    return cells[0];
  }
  const Point& center = this->balls[ball].center;
  Index best = cells[0];
  double largest = -std::numeric_limits<double>::infinity();
  for (const Index cell : cells)
  {
    Point direction = -4 * center;
    for (const Index corner : this->mesh.cells[cell])
    {
      direction += this->balls[corner].center;
    }
    const double cosine = direction.dot(p - center) / direction.norm();
    best = cosine > largest ? cell : best;
    largest = std::max(largest, cosine);
  }
  return best;
}
}
