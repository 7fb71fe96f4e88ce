// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/Twigs.h"

#include "Base/Lists.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

namespace medial
{
namespace
{
/// The neighbours of each point in a graph.
IndexLists neighborLists(Index pointCount, const std::vector<Edge>& edges)
{
  return listsByKey(pointCount, [&edges](const auto& add) {
    for (const auto& [a, b] : edges)
    {
      add(a, b);
      add(b, a);
    }
  });
}

/// How a graph burns from its free ends.
struct GraphFire
{
  std::vector<Index>
    parent; ///< of each point where its fire goes on; None where it ends, or comes never
  std::vector<double> arrival; ///< of each point the time of its last fire
  std::vector<Index> unburnt;  ///< of each point its neighbours whose fire has not come
  IndexLists children;         ///< of each point, whose fire comes last first
};

/// Passes the fire of each point on to the one neighbour that has not burnt, earliest first.
void burn(const MedialAxis& axis, const IndexLists& neighbors, GraphFire& result,
  const Execution& execution)
{
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> fires;
  for (Index point = 0; point < neighbors.size(); ++point)
  {
    if (result.unburnt[point] == 1)
    {
      fires.push({ result.arrival[point], point });
    }
  }
  std::vector<char> isBurnt(axis.points.size(), 0);
  for (Index step = 0; !fires.empty(); ++step)
  {
    execution.pollAt(step);
    const auto [time, point] = fires.top();
    fires.pop();
    if (result.unburnt[point] != 1)
    {
      continue; // the last point of a tree
    }
    const IndexLists::View all = neighbors[point];
    const Index next =
      *std::find_if(all.begin(), all.end(), [&](Index other) { return !isBurnt[other]; });
    isBurnt[point] = 1;
    result.parent[point] = next;
    result.arrival[next] =
      std::max(result.arrival[next], time + (axis.points[point] - axis.points[next]).norm());
    if (--result.unburnt[next] == 1)
    {
      fires.push({ result.arrival[next], next });
    }
  }
}

/// When the fire of a point comes to the next one.
double arrivalFrom(const MedialAxis& axis, const GraphFire& burning, Index child)
{
  return burning.arrival[child] + (axis.points[child] - axis.points[burning.parent[child]]).norm();
}

GraphFire burning(const MedialAxis& axis, const IndexLists& neighbors, const Execution& execution)
{
  GraphFire result;
  result.parent.assign(axis.points.size(), None);
  result.arrival = axis.radii;
  for (Index point = 0; point < neighbors.size(); ++point)
  {
    result.unburnt.push_back(neighbors[point].size());
  }
  burn(axis, neighbors, result, execution);
  result.children = listsByKey(neighbors.size(), [&result](const auto& add) {
    for (Index point = 0; point < count(result.parent); ++point)
    {
      if (result.parent[point] != None)
      {
        add(result.parent[point], point);
      }
    }
  });
  const auto comesLater = [&](Index a, Index b) {
    return arrivalFrom(axis, result, a) > arrivalFrom(axis, result, b);
  };
  IndexLists& children = result.children;
  for (Index point = 0; point < children.size(); ++point)
  {
    std::stable_sort(children.items.begin() + children.offsets[point],
      children.items.begin() + children.offsets[point + 1], comesLater);
  }
  return result;
}

/// Walks from what no fire passes down into the twigs that stay. Each point is on one longest path,
/// so this is linear.
class Keeping
{
public:
  Keeping(const MedialAxis& axis, const std::vector<double>& times, const GraphFire& burning)
    : axis(axis)
    , times(times)
    , burning(burning)
    , isKept(axis.points.size(), 0)
  {
  }

  std::vector<char> keptPoints()
  {
    for (Index point = 0; point < count(this->isKept); ++point)
    {
      if (this->burning.parent[point] == None)
      {
        const bool isOnLoop = this->burning.unburnt[point] > 0;
        this->keep(point, isOnLoop ? 0 : 2);
      }
    }
    while (!this->twigs.empty())
    {
      std::vector<Index> path{ this->twigs.back() };
      this->twigs.pop_back();
      while (this->longest(path.back()) != None)
      {
        path.push_back(this->longest(path.back()));
      }
      for (const Index point : path)
      {
        this->keep(point, 1);
      }
      this->trim(path);
    }
    return std::move(this->isKept);
  }

private:
  /// @param own  how many of its children are not twigs: those that its path goes on to
  void keep(Index point, Index own)
  {
    this->isKept[point] = 1;
    const IndexLists::View children = this->burning.children[point];
    for (Index i = 0; i < children.size(); ++i)
    {
      const bool isPath = this->burning.parent[point] != None && i < own; // walked already
      if (!isPath && (i < own || this->staysOut(point, children[i])))
      {
        this->twigs.push_back(children[i]);
      }
    }
  }

  /// Takes away the end of a path from the point on where it is one twig among others: a path that would go
  /// itself as a twig of this point, where another twig sticks out half as far.
  void trim(const std::vector<Index>& path)
  {
    const Index end = path.back();
    std::size_t length = path.size();
    for (std::size_t i = path.size() - 1; i > 0; --i)
    {
      const Index point = path[i - 1];
      const IndexLists::View children = this->burning.children[point];
      if (!this->isWithin(point, end) ||
        (children.size() > 1 && this->staysOut(point, children[1])))
      {
        break;
      }
      const auto sticksOut = [&](Index child) {
        return arrivalFrom(this->axis, this->burning, child) - this->axis.radii[point];
      };
      if (children.size() > 1 && sticksOut(children[1]) >= sticksOut(children[0]) / 2)
      {
        length = i;
      }
    }
    for (std::size_t i = length; i < path.size(); ++i)
    {
      this->isKept[path[i]] = 0;
    }
  }

  /// Is a ball of the axis within the sheet at a point and a radius more?
  bool isWithin(Index root, Index point) const
  {
    return (this->axis.points[point] - this->axis.points[root]).norm() + this->axis.radii[point] <=
      this->times[root] + this->axis.radii[root];
  }

  bool staysOut(Index root, Index twig) const
  {
    for (Index point = twig; point != None; point = this->longest(point))
    {
      if (!this->isWithin(root, point))
      {
        return true;
      }
    }
    return false;
  }

  /// The child on the longest path down from a point.
  Index longest(Index point) const
  {
    const IndexLists::View children = this->burning.children[point];
    return children.size() == 0 ? None : children[0];
  }

  const MedialAxis& axis;
  const std::vector<double>& times;
  const GraphFire& burning;
  std::vector<char> isKept;
  std::vector<Index> twigs; ///< to be kept, by the point next to the root
};
}

std::vector<Edge> withoutTwigs(const MedialAxis& axis, const std::vector<double>& times,
  const std::vector<Edge>& edges, const Execution& execution)
{
  const IndexLists neighbors = neighborLists(count(axis.points), edges);
  const GraphFire fire = burning(axis, neighbors, execution);
  const std::vector<char> isKept = Keeping(axis, times, fire).keptPoints();
  std::vector<Edge> result;
  for (const Edge& edge : edges)
  {
    if (isKept[edge[0]] && isKept[edge[1]])
    {
      result.push_back(edge);
    }
  }
  return result;
}
}
