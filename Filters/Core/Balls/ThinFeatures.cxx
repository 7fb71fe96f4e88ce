// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/ThinFeatures.h"

#include "Balls/MarkedBetti.h"

#include <algorithm>
#include <array>
#include <string>

namespace medial
{
namespace
{
/// Radii in local spacings below which a ball is small. Plates of twice such a radius, two to two and a
/// half times as thick as the distance of nearest samples, come out with wrong tunnels now and then;
/// thicker ones don't. A change of topology that vanishes at the next size decides nothing.
constexpr std::array<double, 2> smallRadii{ 0.7, 0.8 };

bool isSmall(const SampleEvidence& evidence, Index ball, double size)
{
  return evidence.balls[ball].radius < size * evidence.meanSpacings[ball];
}

/// Does the topology change, for all sizes, where small balls of one side go to the other?
bool decidesTopology(const SampleEvidence& evidence, Side side, const Betti& betti)
{
  return std::all_of(smallRadii.begin(), smallRadii.end(), [&](double size) {
    std::vector<char> inner(evidence.balls.size());
    bool any = false;
    for (Index b = 0; b < count(inner); ++b)
    {
      const bool moves = evidence.sides[b] == side && isSmall(evidence, b, size);
      inner[b] = (evidence.sides[b] == Side::Inner) != moves;
      any = any || moves;
    }
    return any && markedBetti(evidence.mesh, evidence.edges, inner) != betti;
  });
}

Warning about(
  const SampleEvidence& evidence, Side side, const char* code, const std::string& seen, bool doubts)
{
  Warning result;
  Index smallest = None;
  for (Index b = 0; b < count(evidence.balls); ++b)
  {
    if (evidence.sides[b] == side && isSmall(evidence, b, smallRadii.back()))
    {
      ++result.count;
      const bool smaller =
        smallest == None || evidence.balls[b].radius < evidence.balls[smallest].radius;
      smallest = smaller ? b : smallest;
    }
  }
  result.code = code;
  result.text = std::to_string(result.count) + seen;
  result.place = evidence.frame.toWorld(evidence.balls[smallest].center);
  result.doubtsSolid = doubts;
  return result;
}
}

Warnings thinFeatures(const SampleEvidence& evidence, const Betti& betti)
{
  Warnings result;
  if (decidesTopology(evidence, Side::Inner, betti))
  {
    result.push_back(about(evidence, Side::Inner, "thin_parts",
      " balls inside are as small as the sample spacing, and pieces and tunnels depend on them. "
      "Sample "
      "thin parts more densely: at least four samples across.",
      true));
  }
  if (decidesTopology(evidence, Side::Outer, betti))
  {
    result.push_back(about(evidence, Side::Outer, "narrow_gaps",
      " balls outside are as small as the sample spacing, and it depends on them which parts are "
      "connected. Sample narrow gaps and holes more densely.",
      false));
  }
  return result;
}
}
