// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/AxisEdges.h"

#include "Base/Lists.h"

#include <algorithm>
#include <cstdint>

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

/// The uses of edges in lists by their lower corner, each sorted by higher corner and place, which are
/// one number: few edges share a lower corner, so this is much faster than to sort all edges.
Lists<std::uint64_t> usesByLowerCorner(const AxisCells& cells)
{
  Index last = None;
  forUses(cells, [&last](Index lower, Index, Index) { last = std::max(last, lower); });
  Lists<std::uint64_t> uses = listsByKey<std::uint64_t>(last + 1, [&](const auto& add) {
    forUses(cells, [&](Index lower, Index higher, Index place) {
      add(lower, static_cast<std::uint64_t>(higher) << 32 | place);
    });
  });
  uses.sortEach();
  return uses;
}
}

AxisEdges axisEdges(const AxisCells& cells)
{
  AxisEdges result;
  result.ofTriangle.resize(cells.triangles.size());
  result.ofDangling.resize(cells.edges.size());
  const Index sides = 3 * count(cells.triangles);
  const Lists<std::uint64_t> uses = usesByLowerCorner(cells);
  result.points.reserve(uses.items.size());
  result.triangles.offsets.reserve(uses.items.size());
  result.triangles.items.reserve(sides);
  for (Index lower = 0; lower < uses.size(); ++lower)
  {
    Index last = None;
    for (const std::uint64_t use : uses[lower])
    {
      const auto higher = static_cast<Index>(use >> 32);
      const auto place = static_cast<Index>(use & 0xffffffff);
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
