// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/ThinFeatures.h"

#include "Balls/MarkedBetti.h"

#include <array>
#include <cstdlib>
#include <string>

namespace medial
{
namespace
{
/// Radii in local spacings below which a ball is small, the largest first. Plates of twice such a radius,
/// two to two and a half times as thick as the distance of nearest samples, come out with wrong tunnels now
/// and then; thicker ones don't.
constexpr std::array<double, 3> smallRadii{ 0.8, 0.7, 0.6 };

bool isSmall(const SampleEvidence& evidence, Index ball, double size)
{
  return evidence.balls[ball].radius < size * evidence.meanSpacings[ball];
}

/// The Betti numbers where balls of one side that are smaller than this go to the other side.
Betti withoutSmall(const SampleEvidence& evidence, Side side, double size, const Betti& unchanged)
{
  std::vector<char> inner(evidence.balls.size());
  bool any = false;
  for (Index b = 0; b < count(inner); ++b)
  {
    const bool moves = evidence.sides[b] == side && isSmall(evidence, b, size);
    inner[b] = (evidence.sides[b] == Side::Inner) != moves;
    any = any || moves;
  }
  return any ? markedBetti(evidence.mesh, evidence.edges, inner) : unchanged;
}

/// Does the topology depend on small balls of one side? It does if it changes without them for two of
/// the three sizes: for a single one, numbers may agree or differ by chance. It also does if nothing
/// is inside without them.
bool decidesTopology(const SampleEvidence& evidence, Side side, const Betti& betti)
{
  int votes = 0;
  for (const double size : smallRadii)
  {
    const Betti left = withoutSmall(evidence, side, size, betti);
    if (betti[0] > 0 && left[0] == 0)
    {
      return true;
    }
    votes += left != betti ? 1 : -1;
    if (std::abs(votes) == 2)
    {
      break; // the third one can't change it
    }
  }
  return votes > 0;
}

struct ThinKind
{
  const char* code;
  const char* seen; ///< after the number of balls
  Side side;
  bool doubtsSolid;
};

Warning about(const SampleEvidence& evidence, const ThinKind& kind)
{
  Warning result;
  Index smallest = None;
  for (Index b = 0; b < count(evidence.balls); ++b)
  {
    if (evidence.sides[b] == kind.side && isSmall(evidence, b, smallRadii.front()))
    {
      ++result.count;
      const bool smaller =
        smallest == None || evidence.balls[b].radius < evidence.balls[smallest].radius;
      smallest = smaller ? b : smallest;
    }
  }
  result.code = kind.code;
  result.text = std::to_string(result.count) + kind.seen;
  result.place = evidence.frame.toWorld(evidence.balls[smallest].center);
  result.doubtsSolid = kind.doubtsSolid;
  return result;
}
}

Warnings thinFeatures(const SampleEvidence& evidence, const Betti& betti)
{
  const std::array<ThinKind, 2> kinds{ {
    { "thin_parts",
      " balls inside are as small as the sample spacing, and pieces and tunnels depend on them. "
      "Sample thin parts more densely: at least four samples across.",
      Side::Inner, true },
    { "narrow_gaps",
      " balls outside are as small as the sample spacing, and it depends on them which parts are "
      "connected. Sample narrow gaps and holes more densely.",
      Side::Outer, false },
  } };
  Warnings result;
  for (const ThinKind& kind : kinds)
  {
    if (decidesTopology(evidence, kind.side, betti))
    {
      result.push_back(about(evidence, kind));
    }
  }
  return result;
}
}
