// SPDX-License-Identifier: BSD-3-Clause
#include "AxisEdges.h"

#include <algorithm>
#include <numeric>

namespace medial
{
namespace
{
/// A side of a triangle (3 * triangle + side), or, numbered on from those, a dangling edge.
struct Use
{
  Index first, second, where;
};

/// Calls body(use) for all of them in the order of their place.
template <typename Body>
void forUses(const AxisCells& cells, const Body& body)
{
  Index where = 0;
  const auto use = [&](Index a, Index b) { body(Use{ std::min(a, b), std::max(a, b), where++ }); };
  for (const Triangle& t : cells.triangles)
  {
    use(t[0], t[1]);
    use(t[1], t[2]);
    use(t[2], t[0]);
  }
  for (const Edge& edge : cells.edges)
  {
    use(edge[0], edge[1]);
  }
}

/// All uses by first corner, second corner, place. Counted by first corner: few share one.
std::vector<Use> sortedUses(const AxisCells& cells)
{
  Index highest = None;
  forUses(cells, [&highest](const Use& use) { highest = std::max(highest, use.first); });
  std::vector<Index> begin(highest + 2, 0);
  forUses(cells, [&begin](const Use& use) { ++begin[use.first + 1]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Use> result(begin.back());
  std::vector<Index> next = begin;
  forUses(cells, [&](const Use& use) { result[next[use.first]++] = use; });
  const auto before = [](const Use& a, const Use& b) {
    return a.second != b.second ? a.second < b.second : a.where < b.where;
  };
  for (std::size_t p = 1; p < begin.size(); ++p)
  {
    std::sort(result.begin() + begin[p - 1], result.begin() + begin[p], before);
  }
  return result;
}
}

AxisEdges axisEdges(const AxisCells& cells)
{
  AxisEdges result;
  result.ofTriangle.resize(cells.triangles.size());
  result.ofDangling.resize(cells.edges.size());
  const Index sides = 3 * count(cells.triangles);
  const std::vector<Use> all = sortedUses(cells);
  result.points.reserve(all.size());
  result.triangles.offsets.reserve(all.size());
  result.triangles.items.reserve(sides);
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
