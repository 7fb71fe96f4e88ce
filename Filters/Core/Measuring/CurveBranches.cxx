// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/CurveBranches.h"

#include "Base/Lists.h"

#include <algorithm>
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

bool isWithinBall(const MedialAxis& axis, Index node, const CurveBranch& branch)
{
  return std::all_of(branch.points.begin(), branch.points.end(), [&](Index point) {
    return (axis.points[point] - axis.points[node]).norm() <= axis.radii[node];
  });
}

/// Makes near forks one, see curveBranches().
class ForkMerging
{
public:
  ForkMerging(const MedialAxis& axis, std::vector<CurveBranch>& branches)
    : axis(axis)
    , branches(branches)
    , forks(branchesAtForks(count(axis.points), branches))
    , standsFor(axis.points.size(), None)
    , isGone(branches.size(), 0)
  {
  }

  void merge()
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
        for (Index& node : this->branches[branch].nodes)
        {
          node = node == None || this->standsFor[node] == None ? node : this->standsFor[node];
        }
        left.push_back(std::move(this->branches[branch]));
      }
    }
    this->branches = std::move(left);
  }

private:
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
      [&](Index a, Index b) { return this->axis.radii[a] > this->axis.radii[b]; });
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
        isWithinBall(this->axis, fork, this->branches[branch]))
      {
        this->standsFor[other] = fork;
        this->isGone[branch] = 1;
      }
    }
  }

  const MedialAxis& axis;
  std::vector<CurveBranch>& branches;
  IndexLists forks;             ///< for each point that is one its branches
  std::vector<Index> standsFor; ///< for each fork that is done the one it is now
  std::vector<char> isGone;     ///< for each branch
};
}

std::vector<CurveBranch> curveBranches(const MedialAxis& axis, const std::vector<Edge>& edges)
{
  std::vector<CurveBranch> result = Walk(count(axis.points), edges).branches();
  ForkMerging(axis, result).merge();
  return result;
}
}
