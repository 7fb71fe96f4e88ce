// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/AxisEdges.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace medial
{
namespace
{
/// Calls body(lower corner, higher corner, place) for each side of a triangle (the place is 3 *
/// triangle + side) and then, numbered on from those, for each dangling edge.
template <typename Body>
void forUses(const AxisCells& cells, const Body& body)
{
  Index place = 0;
  const auto use = [&](Index a, Index b) { body(std::min(a, b), std::max(a, b), place++); };
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

/// The uses of the edges at each lower corner.
struct Uses
{
  std::vector<Index> begin;       ///< of each corner, and the end
  std::vector<std::uint64_t> all; ///< higher corner and place as one number
};

/// By lower corner, higher corner, place. Counted by lower corner: few share one.
Uses sortedUses(const AxisCells& cells)
{
  Uses result;
  std::vector<Index>& begin = result.begin;
  forUses(cells, [&begin](Index lower, Index, Index) {
    begin.resize(std::max<std::size_t>(begin.size(), lower + 2), 0);
    ++begin[lower + 1];
  });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  result.all.resize(begin.empty() ? 0 : begin.back());
  std::vector<Index> next = begin;
  forUses(cells, [&](Index lower, Index higher, Index place) {
    result.all[next[lower]++] = static_cast<std::uint64_t>(higher) << 32 | place;
  });
  for (std::size_t p = 1; p < begin.size(); ++p)
  {
    std::sort(result.all.begin() + begin[p - 1], result.all.begin() + begin[p]);
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
  const Uses uses = sortedUses(cells);
  result.points.reserve(uses.all.size());
  result.triangles.offsets.reserve(uses.all.size());
  result.triangles.items.reserve(sides);
  for (Index lower = 0; lower + 1 < count(uses.begin); ++lower)
  {
    Index last = None;
    for (Index i = uses.begin[lower]; i < uses.begin[lower + 1]; ++i)
    {
      const auto higher = static_cast<Index>(uses.all[i] >> 32);
      const auto place = static_cast<Index>(uses.all[i] & 0xffffffff);
      if (higher != last)
      {
        result.points.push_back({ lower, higher });
        result.triangles.offsets.push_back(count(result.triangles.items));
      }
      last = higher;
      const Index edge = count(result.points) - 1;
      if (place < sides)
      {
        result.triangles.items.push_back(place / 3);
        result.triangles.offsets.back() = count(result.triangles.items);
        result.ofTriangle[place / 3][place % 3] = edge;
      }
      else
      {
        result.ofDangling[place - sides] = edge;
      }
    }
  }
  return result;
}
}
