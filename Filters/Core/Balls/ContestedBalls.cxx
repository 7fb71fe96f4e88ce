// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/ContestedBalls.h"

#include "Balls/MarkedBetti.h"
#include "Base/BettiWords.h"
#include "Base/Errors.h"

#include <algorithm>

namespace medial
{
namespace
{
std::vector<char> marked(
  const std::vector<Side>& sides, const std::vector<char>& contested, Side whereContested)
{
  std::vector<char> result(sides.size());
  for (std::size_t b = 0; b < sides.size(); ++b)
  {
    const bool flips = contested[b] && sides[b] != Side::Hidden;
    result[b] = (flips ? whereContested : sides[b]) == Side::Inner;
  }
  return result;
}
}

std::vector<Support> supports(const SampleEvidence& evidence)
{
  std::vector<Support> result(evidence.balls.size());
  const auto add = [&](Index a, Index b, bool agrees, double strength) {
    for (const Index ball : { a, b })
    {
      (agrees ? result[ball].agreeing : result[ball].contradicting) += std::min(strength, 1.0);
    }
  };
  // Inner and outer balls of a densely sampled surface touch it from both sides, so that they meet at a
  // flat angle; less than this is no evidence.
  constexpr double meaningful = 0.3;
  for (const auto& [a, b] : evidence.edges)
  {
    const double depth = intersectionDepth(evidence.balls[a], evidence.balls[b]);
    if (depth > meaningful)
    {
      add(a, b, evidence.sides[a] == evidence.sides[b], depth);
    }
  }
  for (std::size_t s = 0; s < evidence.points.size(); ++s)
  {
    const auto [first, second] = evidence.ballsOfSample[s];
    if (first == None || second == None || evidence.sides[first] == evidence.sides[second])
    {
      continue; // at a sharp edge both poles may be on one side
    }
    const double opposite =
      opposition(evidence.points[s], evidence.balls[first], evidence.balls[second]);
    add(first, second, true, std::max(0.0, opposite));
  }
  return result;
}

bool isContested(const Support& support)
{
  return support.contradicting > 0 && 2 * support.contradicting >= support.agreeing;
}

Warnings contestedTopology(const SampleEvidence& evidence, const std::vector<Support>& supports,
  const std::vector<char>& contested, const Betti& betti)
{
  Index worst = None;
  Warning warning;
  for (Index b = 0; b < count(contested); ++b)
  {
    warning.count += contested[b] != 0;
    if (contested[b] &&
      (worst == None || supports[b].contradicting > supports[worst].contradicting))
    {
      worst = b;
    }
  }
  if (worst == None)
  {
    return {};
  }
  const Betti without =
    markedBetti(evidence.mesh, evidence.edges, marked(evidence.sides, contested, Side::Outer));
  const Betti with =
    markedBetti(evidence.mesh, evidence.edges, marked(evidence.sides, contested, Side::Inner));
  if (without == betti && with == betti)
  {
    return {};
  }
  warning.code = "contested_sides";
  warning.text = text("It is doubtful for ", warning.count,
    " balls whether they are inside the solid, and the topology depends on them (", inWords(betti),
    "; if all are outside: ", inWords(without), "; if all are inside: ", inWords(with),
    "). Sample walls, gaps and sharp edges more densely.");
  warning.place = evidence.frame.toWorld(evidence.balls[worst].center);
  warning.doubtsSolid = true;
  return { warning };
}
}
