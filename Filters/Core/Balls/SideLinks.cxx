// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/SideLinks.h"

#include <algorithm>

namespace medial
{
std::vector<SideLink> sideLinks(const SideInput& input)
{
  std::vector<SideLink> result;
  const auto add = [&](Index a, Index b, double strength, bool same) {
    if (strength > 0)
    {
      result.push_back({ a, b, static_cast<float>(std::min(strength, 1.0)), same });
    }
  };
  for (const auto& [a, b] : input.edges)
  {
    add(a, b, intersectionDepth(input.balls[a], input.balls[b]), true);
  }
  for (std::size_t s = 0; s < input.samples.size(); ++s)
  {
    const auto [first, second] = input.ballsOfSample[s];
    if (first != None && second != None && first != second)
    {
      const Point u = input.balls[first].center - input.samples[s];
      const Point v = input.balls[second].center - input.samples[s];
      add(first, second, -u.dot(v) / (u.norm() * v.norm()), false);
    }
  }
  return result;
}
}
