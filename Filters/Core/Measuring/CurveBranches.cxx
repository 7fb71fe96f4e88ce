// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/CurveBranches.h"

#include "Base/EdgeTable.h"
#include "Base/Lists.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace medial
{
namespace
{
/// Walks along the edges of a graph, each once.
class Walk
{
public:
  Walk(Index pointCount, const std::vector<Edge>& edges)
    : edges(edges)
    , edgesOf(listsByKey(pointCount,
        [&edges](const auto& add) {
          for (Index edge = 0; edge < count(edges); ++edge)
          {
            add(edges[edge][0], edge);
            add(edges[edge][1], edge);
          }
        }))
    , isWalked(edges.size(), 0)
  {
  }

  std::vector<CurveBranch> branches()
  {
    for (const bool fromNodes : { true, false })
    {
      for (Index point = 0; point < this->edgesOf.size(); ++point)
      {
        if (this->isNode(point) == fromNodes)
        {
          this->walkFrom(point);
        }
      }
    }
    return std::move(this->result);
  }

private:
  bool isNode(Index point) const { return this->edgesOf[point].size() != 2; }

  void walkFrom(Index point)
  {
    for (const Index edge : this->edgesOf[point])
    {
      if (!this->isWalked[edge])
      {
        this->result.push_back(this->walked(point, edge));
      }
    }
  }

  CurveBranch walked(Index from, Index edge)
  {
    CurveBranch branch{ { from }, { None, None } };
    while (edge != None)
    {
      this->isWalked[edge] = 1;
      const auto [a, b] = this->edges[edge];
      const Index point = a == branch.points.back() ? b : a;
      branch.points.push_back(point);
      edge = this->isNode(point) ? None : this->nextEdge(point);
    }
    if (this->isNode(from))
    {
      branch.nodes = { from, branch.points.back() };
    }
    return branch;
  }

  Index nextEdge(Index point) const
  {
    for (const Index edge : this->edgesOf[point])
    {
      if (!this->isWalked[edge])
      {
        return edge;
      }
    }
    return None;
  }

  const std::vector<Edge>& edges;
  IndexLists edgesOf; ///< for each point
  std::vector<char> isWalked;
  std::vector<CurveBranch> result;
};

/// The branches at each point that is a node of three or more of their ends.
IndexLists branchesAtForks(Index pointCount, const std::vector<CurveBranch>& branches)
{
  std::vector<Index> degree(pointCount, 0);
  const auto forEnds = [&branches](const auto& body) {
    for (Index branch = 0; branch < count(branches); ++branch)
    {
      for (const Index node : branches[branch].nodes)
      {
        if (node != None)
        {
          body(node, branch);
        }
      }
    }
  };
  forEnds([&degree](Index node, Index) { ++degree[node]; });
  return listsByKey(pointCount, [&](const auto& add) {
    forEnds([&](Index node, Index branch) {
      if (degree[node] > 2)
      {
        add(node, branch);
      }
    });
  });
}

/// How far a branch goes from a fork at most.
double extentFrom(const MedialAxis& axis, Index fork, const CurveBranch& branch)
{
  double result = 0;
  for (const Index point : branch.points)
  {
    result = std::max(result, (axis.points[point] - axis.points[fork]).norm());
  }
  return result;
}

/// The radius of the largest ball of a fork. The fork itself may be in a web between rods, where balls are
/// small and become larger towards the rods; a few rounds come there.
double radiusOf(const MedialAxis& axis, Index fork, const IndexLists::View& at,
  const std::vector<CurveBranch>& branches)
{
  double result = axis.radii[fork];
  for (int round = 0; round < 3; ++round)
  {
    const double reach = 2 * result;
    for (const Index branch : at)
    {
      std::vector<Index> points = branches[branch].points;
      if (branches[branch].nodes[0] != fork)
      {
        std::reverse(points.begin(), points.end());
      }
      for (const Index point : points)
      {
        if ((axis.points[point] - axis.points[fork]).norm() > reach)
        {
          break;
        }
        result = std::max(result, axis.radii[point]);
      }
    }
  }
  return result;
}

/// For each point that is a fork how far what is no rod of its own reaches at most: half the width of the
/// sheet and a radius.
std::vector<double> reaches(const MedialAxis& axis, const std::vector<double>& times,
  const IndexLists& forks, const std::vector<CurveBranch>& branches)
{
  std::vector<double> result(axis.points.size(), 0);
  for (Index fork = 0; fork < forks.size(); ++fork)
  {
    if (forks[fork].size() > 0)
    {
      const double radius = radiusOf(axis, fork, forks[fork], branches);
      result[fork] = std::max(times[fork], radius) + radius;
    }
  }
  return result;
}

/// Makes near forks one, see curveBranches().
class ForkMerging
{
public:
  ForkMerging(
    const MedialAxis& axis, const std::vector<double>& times, std::vector<CurveBranch>& branches)
    : axis(axis)
    , branches(branches)
    , forks(branchesAtForks(count(axis.points), branches))
    , reach(reaches(axis, times, forks, branches))
    , standsFor(axis.points.size(), None)
    , way(axis.points.size(), None)
    , isGone(branches.size(), 0)
  {
  }

  /// @param extends  lets the branches of a fork that was taken in begin at the one that took it, along
  ///                 the line between them
  void merge(bool extends)
  {
    for (const Index fork : this->largestFirst())
    {
      if (this->standsFor[fork] == None)
      {
        this->takeInNeighbors(fork);
      }
    }
    std::vector<CurveBranch> left;
    for (Index branch = 0; branch < count(this->branches); ++branch)
    {
      if (!this->isGone[branch])
      {
        left.push_back(this->renamed(this->branches[branch], extends));
      }
    }
    this->branches = std::move(left);
  }

private:
  CurveBranch renamed(CurveBranch branch, bool extends) const
  {
    for (Index& node : branch.nodes)
    {
      std::reverse(branch.points.begin(), branch.points.end()); // twice: as it was
      if (extends && node != None && this->way[node] != None)
      {
        const std::vector<Index> points = this->wayFrom(node);
        branch.points.insert(branch.points.end(), points.begin(), points.end());
      }
      node = node == None || this->standsFor[node] == None ? node : this->standsFor[node];
    }
    return branch;
  }

  /// The points after a fork on its way to the one that stands for it; few, because each of its branches gets
  /// them.
  std::vector<Index> wayFrom(Index fork) const
  {
    std::vector<Index> points = this->branches[this->way[fork]].points;
    if (points.front() != fork)
    {
      std::reverse(points.begin(), points.end());
    }
    constexpr std::size_t most = 32;
    const std::size_t step = points.size() / most + 1;
    std::vector<Index> result;
    for (std::size_t i = step; i + 1 < points.size(); i += step)
    {
      result.push_back(points[i]);
    }
    result.push_back(points.back());
    return result;
  }

  std::vector<Index> largestFirst() const
  {
    std::vector<Index> order;
    for (Index point = 0; point < this->forks.size(); ++point)
    {
      if (this->forks[point].size() > 0)
      {
        order.push_back(point);
      }
    }
    std::stable_sort(order.begin(), order.end(),
      [&](Index a, Index b) { return this->reach[a] > this->reach[b]; });
    return order;
  }

  void takeInNeighbors(Index fork)
  {
    this->standsFor[fork] = fork;
    for (const Index branch : this->forks[fork])
    {
      const auto [first, last] = this->branches[branch].nodes;
      const Index other = first == fork ? last : first;
      if (this->forks[other].size() > 0 && this->standsFor[other] == None &&
        extentFrom(this->axis, fork, this->branches[branch]) <= this->reach[fork])
      {
        this->standsFor[other] = fork;
        this->way[other] = branch;
        this->isGone[branch] = 1;
      }
    }
  }

  const MedialAxis& axis;
  std::vector<CurveBranch>& branches;
  IndexLists forks;             ///< for each point that is one its branches
  std::vector<double> reach;    ///< for each fork
  std::vector<Index> standsFor; ///< for each fork that is done the one it is now
  std::vector<Index> way;       ///< for each fork that is another one now the branch to it
  std::vector<char> isGone;     ///< for each branch
};

/// The branches between a fork and a free end that the fork reaches to the end. Where it has no others,
/// the two longest are none of them.
std::vector<Index> stubs(const MedialAxis& axis, const std::vector<double>& times,
  const std::vector<CurveBranch>& branches)
{
  std::vector<Index> result;
  const IndexLists forks = branchesAtForks(count(axis.points), branches);
  const std::vector<double> reachOf = reaches(axis, times, forks, branches);
  for (Index fork = 0; fork < forks.size(); ++fork)
  {
    std::vector<std::pair<double, Index>> found; // the longest first, then the lowest
    for (const Index branch : forks[fork])
    {
      const auto [first, last] = branches[branch].nodes;
      const double extent = extentFrom(axis, fork, branches[branch]);
      if (forks[first == fork ? last : first].size() == 0 && extent <= reachOf[fork])
      {
        found.push_back({ -extent, branch });
      }
    }
    std::sort(found.begin(), found.end());
    const bool areAll = count(found) == forks[fork].size() && !found.empty();
    for (std::size_t i = areAll ? 2 : 0; i < found.size(); ++i)
    {
      result.push_back(found[i].second);
    }
  }
  return result;
}

std::vector<Edge> without(const std::vector<CurveBranch>& gone, const std::vector<Edge>& edges)
{
  EdgeSet goneEdges;
  for (const CurveBranch& branch : gone)
  {
    for (std::size_t i = 1; i < branch.points.size(); ++i)
    {
      goneEdges.insert(branch.points[i - 1], branch.points[i]);
    }
  }
  std::vector<Edge> result;
  std::copy_if(edges.begin(), edges.end(), std::back_inserter(result),
    [&goneEdges](const Edge& edge) { return !goneEdges.contains(edge[0], edge[1]); });
  return result;
}
}

std::vector<CurveBranch> curveBranches(
  const MedialAxis& axis, const std::vector<double>& times, std::vector<Edge> edges)
{
  constexpr int rounds = 4; // without a stub, a fork may be none, and two branches one
  for (int round = 1;; ++round)
  {
    std::vector<CurveBranch> result = Walk(count(axis.points), edges).branches();
    std::vector<CurveBranch> merged = result;
    ForkMerging(axis, times, merged).merge(false);
    std::vector<CurveBranch> gone;
    for (const Index branch : stubs(axis, times, merged))
    {
      gone.push_back(merged[branch]);
    }
    if (gone.empty() || round == rounds)
    {
      ForkMerging(axis, times, result).merge(true);
      return result;
    }
    edges = without(gone, edges);
  }
}
}
