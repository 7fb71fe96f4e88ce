// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/RodLabels.h"

#include "Base/Lists.h"

#include <functional>
#include <queue>
#include <tuple>

namespace medial
{
std::vector<Index> nearestLabels(const MedialAxis& axis, const AxisEdges& edges,
  const std::vector<char>& open, const std::vector<LabelSeed>& seeds, const Execution& execution)
{
  const IndexLists edgesAt = listsByKey(count(axis.points), [&](const auto& add) {
    for (Index e = 0; e < count(edges.points); ++e)
    {
      if (open[e])
      {
        add(edges.points[e][0], e);
        add(edges.points[e][1], e);
      }
    }
  });
  using Event = std::tuple<double, Index, Index>; // distance, label, point
  std::priority_queue<Event, std::vector<Event>, std::greater<>> front;
  for (const LabelSeed& seed : seeds)
  {
    front.push({ 0, seed.label, seed.point });
  }
  std::vector<Index> result(axis.points.size(), None);
  for (Index turn = 0; !front.empty(); turn = (turn + 1) % 4096)
  {
    execution.pollAt(turn);
    const auto [distance, label, point] = front.top();
    front.pop();
    if (result[point] != None)
    {
      continue;
    }
    result[point] = label;
    for (const Index e : edgesAt[point])
    {
      const Index other = edges.points[e][0] == point ? edges.points[e][1] : edges.points[e][0];
      if (result[other] == None)
      {
        const double length = (axis.points[point] - axis.points[other]).norm();
        front.push({ distance + length, label, other });
      }
    }
  }
  return result;
}
}
