// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Neighbors.h"

#include <algorithm>
#include <utility>

// Cells are halved along their longest side (the sliding midpoint rule: where all points are on one side of the
// middle, the cut moves to the nearest of them). So cells don't become long and thin, as those of medians do. Points
// that are equally far from a place are met in an order that depends on the points alone.
namespace medial
{
namespace
{
constexpr Index leafSize = 10; ///< points at most

int longestSide(const Eigen::AlignedBox3d& box)
{
  const Point sides = box.sizes();
  const int larger = sides[1] > sides[0] ? 1 : 0;
  return sides[2] > sides[larger] ? 2 : larger;
}
}

Neighbors::Neighbors(const std::vector<Point>& thePoints)
  : points(thePoints)
{
  Eigen::AlignedBox3d box;
  this->sorted.reserve(this->points.size());
  for (const Point& point : this->points)
  {
    this->sorted.push_back({ point, count(this->sorted) });
    box.extend(point);
  }
  if (!this->points.empty())
  {
    this->nodes.reserve(this->points.size() / 2);
    this->build(0, count(this->points), box);
  }
}

void Neighbors::build(Index begin, Index end, Eigen::AlignedBox3d cell)
{
  const Index self = count(this->nodes);
  Node node{ {}, begin, end, None, 0 };
  for (Index i = begin; i < end; ++i)
  {
    node.box.extend(this->sorted[i].place);
  }
  this->nodes.push_back(node);
  if (end - begin <= leafSize || node.box.min() == node.box.max())
  {
    return;
  }
  double cut = 0;
  int axis = 0;
  const Index middle = this->divide(node, cell, cut, axis);
  this->nodes[self].axis = axis;
  Eigen::AlignedBox3d lower = cell;
  lower.max()[axis] = cell.min()[axis] = cut;
  this->build(begin, middle, lower);
  this->nodes[self].upper = count(this->nodes);
  this->build(middle, end, cell);
}

/// Sorts the points of a node, those below a cut first. @return  the first of the others
Index Neighbors::divide(const Node& node, const Eigen::AlignedBox3d& cell, double& cut, int& axis)
{
  axis = longestSide(cell);
  if (node.box.min()[axis] == node.box.max()[axis])
  {
    axis = longestSide(node.box);
    cut = (node.box.max()[axis] + node.box.min()[axis]) / 2;
  }
  else
  {
    cut = (cell.max()[axis] + cell.min()[axis]) / 2;
  }
  cut = std::clamp(cut, node.box.min()[axis], node.box.max()[axis]);
  const auto begin = this->sorted.begin() + node.begin, end = this->sorted.begin() + node.end;
  const auto isLess = [axis](const Numbered& a, const Numbered& b) {
    return a.place[axis] < b.place[axis];
  };
  auto middle = std::partition(begin, end, [&](const Numbered& p) { return p.place[axis] < cut; });
  if (middle == begin)
  {
    std::iter_swap(std::min_element(begin, end, isLess), middle);
    cut = middle->place[axis];
    ++middle;
  }
  return static_cast<Index>(middle - this->sorted.begin());
}

std::vector<Index> Neighbors::nearest(const Point& place, Index howMany) const
{
  if (this->nodes.empty() || howMany < 1)
  {
    return {};
  }
  using Entry = std::pair<double, Index>;
  std::vector<Entry> near(
    howMany, Entry(std::numeric_limits<double>::infinity(), None)); // in order
  Entry* const last = &near.back();
  this->search(
    0, place,
    [last](double squared) { return !(squared >= last->first); }, // NaN are somewhere, too
    [&near, last](double squared, Index point) {
      const Entry added(squared, point);
      Entry* at = last;
      for (; at != near.data() && added < *(at - 1); --at)
      {
        *at = *(at - 1);
      }
      *at = added;
    });
  std::vector<Index> result;
  result.reserve(near.size());
  for (const Entry& entry : near)
  {
    if (entry.second != None)
    {
      result.push_back(entry.second);
    }
  }
  return result;
}

std::vector<Index> Neighbors::nearest(Index point, Index howMany) const
{
  std::vector<Index> result = this->nearest(this->points[point], howMany + 1);
  const auto self = std::find(result.begin(), result.end(), point);
  result.erase(self == result.end() ? result.end() - 1 : self);
  return result;
}

Index Neighbors::nearestOne(const Point& place, double nearerThan) const
{
  Index result = None;
  double least = nearerThan * nearerThan;
  if (!this->nodes.empty())
  {
    this->search(
      0, place, [&least](double squared) { return squared < least; },
      [&](double squared, Index point) {
        least = squared;
        result = point;
      });
  }
  return result;
}

std::vector<Index> Neighbors::within(Index point, double distance) const
{
  return this->within(this->points[point], distance);
}

std::vector<Index> Neighbors::within(const Point& place, double distance) const
{
  std::vector<Index> result;
  this->forEachWithin(place, distance, [&](Index point) { result.push_back(point); });
  return result;
}

std::vector<Index> Neighbors::inOrder() const
{
  std::vector<Index> result;
  result.reserve(this->sorted.size());
  for (const Numbered& point : this->sorted)
  {
    result.push_back(point.number);
  }
  return result;
}

Neighbors::Left Neighbors::all() const
{
  Left result{ std::vector<char>(this->sorted.size(), 1), {} };
  result.inNode.reserve(this->nodes.size());
  for (const Node& node : this->nodes)
  {
    result.inNode.push_back(node.end - node.begin);
  }
  return result;
}

std::vector<double> meanDistances(
  const std::vector<Point>& points, const Neighbors& neighbors, const Execution& execution)
{
  std::vector<double> result(points.size(), 0);
  execution.forEach(count(points), [&](Index i) {
    const std::vector<Index> near = neighbors.nearest(i, 6);
    for (const Index other : near)
    {
      result[i] += (points[other] - points[i]).norm() / count(near);
    }
  });
  return result;
}
}
