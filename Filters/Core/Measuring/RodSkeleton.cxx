// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/RodSkeleton.h"

#include "Base/Lists.h"
#include "Measuring/CurveSkeleton.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

namespace medial
{
namespace
{
using Event = std::pair<double, Index>;
using Queue = std::priority_queue<Event, std::vector<Event>, std::greater<>>;

/// Takes dead ends away from a graph.
class Shortening
{
public:
  Shortening(const MedialAxis& medialAxis, const std::vector<Edge>& graph,
    const std::vector<char>& anchor, const std::vector<Index>& coveringBalls,
    const Execution& execution)
    : axis(medialAxis)
    , lines(graph)
    , covering(coveringBalls)
    , kept(graph.size(), 1)
    , degree(medialAxis.points.size(), 0)
    , depth(medialAxis.points.size(), 0)
    , tip(medialAxis.points.size())
    , from(medialAxis.points.size(), None)
  {
    std::iota(this->tip.begin(), this->tip.end(), 0);
    const auto forEnds = [this](const auto& add) {
      for (Index i = 0; i < count(this->lines); ++i)
      {
        add(this->lines[i][0], i);
        add(this->lines[i][1], i);
      }
    };
    this->linesAt = listsByKey(count(this->axis.points), forEnds);
    for (Index p = 0; p < count(this->axis.points); ++p)
    {
      this->degree[p] = this->linesAt[p].size() + (anchor[p] ? 2 : 0);
      this->offer(p);
    }
    for (Index turn = 0; !this->tips.empty(); turn = (turn + 1) % 4096)
    {
      execution.pollAt(turn);
      const Index p = this->tips.top().second;
      this->tips.pop();
      this->shorten(p);
    }
    this->restore();
  }

  std::vector<Edge> result() const
  {
    std::vector<Edge> result;
    for (Index i = 0; i < count(this->lines); ++i)
    {
      if (this->kept[i])
      {
        result.push_back(this->lines[i]);
      }
    }
    return result;
  }

private:
  /// The line at a tip, and its other end.
  Edge lineAt(Index tip) const
  {
    for (const Index i : this->linesAt[tip])
    {
      if (this->kept[i])
      {
        return { i, this->lines[i][0] == tip ? this->lines[i][1] : this->lines[i][0] };
      }
    }
    return { None, None };
  }

  void offer(Index p)
  {
    if (this->degree[p] == 1)
    {
      const Index next = this->lineAt(p)[1];
      this->tips.push({ this->depth[p] + this->distance(p, next), p });
    }
  }

  double distance(Index a, Index b) const
  {
    return (this->axis.points[a] - this->axis.points[b]).norm();
  }

  /// Is what ends at a tip too short for a rod, seen from where it meets others? At sharp rims, where the
  /// radius is near 0, the samples tell nothing below their spacing.
  bool isShort(Index tip, Index base) const
  {
    const double least =
      std::max(3 * this->axis.radii[this->covering[base]], this->axis.sampleSpacing);
    return this->distance(tip, base) + this->axis.radii[tip] <= least;
  }

  void shorten(Index p)
  {
    if (this->degree[p] == 0)
    {
      return; // the other end of the last line of a piece
    }
    const auto [line, next] = this->lineAt(p);
    if (this->degree[next] == 1) // the last line of a piece, whose longest way stays
    {
      this->degree[p] = this->degree[next] = 0;
      this->ends.insert(this->ends.end(), { p, next });
      return;
    }
    if (this->degree[next] > 2 && !this->isShort(this->tip[p], next))
    {
      this->ends.push_back(p);
      return;
    }
    const double length = this->depth[p] + this->distance(p, next);
    this->kept[line] = 0;
    this->degree[p] = 0;
    --this->degree[next];
    if (length > this->depth[next])
    {
      this->depth[next] = length;
      this->tip[next] = this->tip[p];
      this->from[next] = line;
    }
    this->offer(next);
  }

  /// Gives the longest way to a tip back to what turned out to be the end of a rod.
  void restore()
  {
    for (Index p : this->ends)
    {
      while (this->from[p] != None)
      {
        const Index line = this->from[p];
        this->kept[line] = 1;
        p = this->lines[line][0] == p ? this->lines[line][1] : this->lines[line][0];
      }
    }
  }

  const MedialAxis& axis;
  const std::vector<Edge>& lines;
  const std::vector<Index>& covering;
  std::vector<char> kept;
  std::vector<Index> degree;
  std::vector<double> depth; ///< length of the longest dead end that went, at each point
  std::vector<Index> tip;    ///< where it ends
  std::vector<Index> from;   ///< its first line
  IndexLists linesAt;
  std::vector<Index> ends; ///< where dead ends are not taken any further back
  Queue tips;
};
}

RodSkeleton rodSkeleton(const MedialAxis& axis, const AxisEdges& edges,
  const std::vector<double>& times, const std::vector<char>& inRod, const std::vector<char>& anchor,
  const std::vector<Index>& covering, const Execution& execution)
{
  const std::vector<Edge> lines = curveSkeleton(axis, edges, times, inRod, execution).edges;
  return { Shortening(axis, lines, anchor, covering, execution).result() };
}
}
