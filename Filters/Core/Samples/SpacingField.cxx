// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/SpacingField.h"

#include "Base/Lists.h"

#include <algorithm>
#include <array>
#include <functional>
#include <queue>
#include <utility>

// The given spacings are made to fit one another first: a small one spreads to the neighbours, and from
// them on, as in Dijkstra's algorithm. Then a place asks only the few points next to it. O(n log n).
namespace medial
{
namespace
{
constexpr Index asked = 8; // neighbours of a point of a surface, all around it

/// For each point its neighbours, and those that it is a neighbour of; some of them twice.
IndexLists links(const Neighbors& neighbors, Index pointCount, const Execution& execution)
{
  std::vector<std::array<Index, asked>> near(pointCount);
  execution.forEach(pointCount, [&](Index i) {
    const std::vector<Index> found = neighbors.nearest(i, asked);
    near[i].fill(None); // where there are fewer
    std::copy(found.begin(), found.end(), near[i].begin());
  });
  return listsByKey(pointCount, [&near](const auto& add) {
    for (Index i = 0; i < count(near); ++i)
    {
      for (const Index other : near[i])
      {
        if (other != None)
        {
          add(i, other);
          add(other, i);
        }
      }
    }
  });
}
}

SpacingField::SpacingField(double largest, std::vector<Point> points, std::vector<double> spacings,
  const Execution& execution)
  : largest(largest)
  , points(std::make_shared<const std::vector<Point>>(std::move(points)))
  , spacings(std::move(spacings))
  , neighbors(std::make_shared<const Neighbors>(*this->points))
{
  const IndexLists near = links(*this->neighbors, count(*this->points), execution);
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (Index i = 0; i < count(this->spacings); ++i)
  {
    this->spacings[i] = std::min(this->spacings[i], this->largest);
    if (this->spacings[i] < this->largest)
    {
      queue.push({ this->spacings[i], i });
    }
  }
  while (!queue.empty())
  {
    const auto [spacing, i] = queue.top();
    queue.pop();
    if (spacing > this->spacings[i])
    {
      continue;
    }
    for (const Index other : near[i])
    {
      const double most = spacing + grading * ((*this->points)[i] - (*this->points)[other]).norm();
      if (most < this->spacings[other])
      {
        this->spacings[other] = most;
        queue.push({ most, other });
      }
    }
  }
}

double SpacingField::at(const Point& point) const
{
  double result = this->largest;
  if (this->neighbors)
  {
    for (const Index i : this->neighbors->nearest(point, asked))
    {
      result = std::min(result, this->spacings[i] + grading * ((*this->points)[i] - point).norm());
    }
  }
  return std::max(result, this->least);
}

SpacingField SpacingField::atLeast(double spacing) const
{
  SpacingField result = *this;
  result.least = spacing;
  return result;
}

std::optional<Point> SpacingField::tightest() const
{
  if (!this->points || this->points->empty())
  {
    return {};
  }
  const auto least = std::min_element(this->spacings.begin(), this->spacings.end());
  return (*this->points)[least - this->spacings.begin()];
}
}
