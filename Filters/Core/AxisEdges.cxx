// SPDX-License-Identifier: BSD-3-Clause
#include "AxisEdges.h"

#include <algorithm>
#include <tuple>

namespace medial
{
namespace
{
/// A side of a triangle (3 * triangle + side), or, numbered on from those, a dangling edge.
struct Use
{
  Index first, second, where;
  bool operator<(const Use& other) const
  {
    return std::tie(this->first, this->second, this->where) <
      std::tie(other.first, other.second, other.where);
  }
};

std::vector<Use> uses(const AxisCells& cells)
{
  std::vector<Use> result;
  result.reserve(3 * cells.triangles.size() + cells.edges.size());
  const auto add = [&result](Index a, Index b) {
    result.push_back({ std::min(a, b), std::max(a, b), count(result) });
  };
  for (const Triangle& t : cells.triangles)
  {
    add(t[0], t[1]);
    add(t[1], t[2]);
    add(t[2], t[0]);
  }
  for (const Edge& edge : cells.edges)
  {
    add(edge[0], edge[1]);
  }
  std::sort(result.begin(), result.end());
  return result;
}
}

AxisEdges axisEdges(const AxisCells& cells)
{
  AxisEdges result;
  result.ofTriangle.resize(cells.triangles.size());
  result.ofDangling.resize(cells.edges.size());
  const Index sides = 3 * count(cells.triangles);
  const std::vector<Use> all = uses(cells);
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const Use& use = all[i];
    if (i == 0 || use.first != all[i - 1].first || use.second != all[i - 1].second)
    {
      if (i > 0)
      {
        result.triangles.close();
      }
      result.points.push_back({ use.first, use.second });
    }
    const Index edge = count(result.points) - 1;
    if (use.where < sides)
    {
      result.triangles.items.push_back(use.where / 3);
      result.ofTriangle[use.where / 3][use.where % 3] = edge;
    }
    else
    {
      result.ofDangling[use.where - sides] = edge;
    }
  }
  if (!all.empty())
  {
    result.triangles.close();
  }
  return result;
}
}
