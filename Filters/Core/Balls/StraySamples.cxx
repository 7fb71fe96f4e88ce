// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/StraySamples.h"

#include "Base/Lists.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>

namespace medial
{
namespace
{
/// The radius of a sample's larger polar ball, in local spacings. On a surface it is the distance to the
/// medial axis on one of its sides, many spacings where the samples are dense.
double reach(const SampleEvidence& evidence, Index s)
{
  const Index first = evidence.ballsOfSample[s][0];
  return evidence.balls[first].radius / evidence.spacings[s];
}

/// Are both of its balls inside, or both outside?
bool isOnNoBoundary(const SampleEvidence& evidence, Index s)
{
  const auto [first, second] = evidence.ballsOfSample[s];
  return first != None && second != None && evidence.sides[first] == evidence.sides[second] &&
    evidence.sides[first] != Side::Hidden;
}

bool isOneSided(const SampleEvidence& evidence, Index s)
{
  if (!isOnNoBoundary(evidence, s))
  {
    return false;
  }
  // Not at a sharp edge.
  const auto [first, second] = evidence.ballsOfSample[s];
  return opposition(evidence.points[s], evidence.balls[first], evidence.balls[second]) > 0.5;
}

/// A kind of samples that are on no surface.
struct StrayKind
{
  const char* code;
  std::function<bool(Index)> isMeant;
  double remarkable; ///< share of all samples above which it is said
  double doubtful;   ///< and above which the solid is doubtful
  const char* text;  ///< after the number of samples
};

void append(const SampleEvidence& evidence, const StrayKind& kind, Warnings& warnings)
{
  const auto all = static_cast<double>(evidence.points.size());
  Warning warning;
  for (Index s = 0; s < count(evidence.points); ++s)
  {
    if (kind.isMeant(s))
    {
      warning.place = warning.place ? warning.place : evidence.frame.toWorld(evidence.points[s]);
      ++warning.count;
    }
  }
  if (warning.count > kind.remarkable * all)
  {
    warning.code = kind.code;
    warning.text = std::to_string(warning.count) + kind.text;
    warning.doubtsSolid = warning.count > kind.doubtful * all;
    warnings.push_back(std::move(warning));
  }
}
}

Warnings straySamples(
  const SampleEvidence& evidence, const Neighbors& neighbors, const std::vector<Index>& nearest)
{
  constexpr double never = 1;
  const double usual = median(evidence.spacings);
  const auto nearestDistance = [&](Index s) {
    return (evidence.points[nearest[s]] - evidence.points[s]).norm();
  };
  const auto loneliness = [&](Index s) {
    const double spacing = evidence.spacings[nearest[s]];
    return nearestDistance(s) / spacing;
  };
  const auto isIsolated = [&](Index s) { // where the surface doesn't pass, by less
    return loneliness(s) > (isOnNoBoundary(evidence, s) ? 1.5 : 3);
  };
  const auto isLost = [&](Index s) { // at a sharp edge, those on its two faces are not
    constexpr Index around = 6;
    const auto isOff = [&](Index other) { return isOnNoBoundary(evidence, other); };
    if (!isOff(s))
    {
      return false;
    }
    const std::vector<Index> near = neighbors.nearest(s, around);
    return std::all_of(near.begin(), near.end(), isOff);
  };
  const std::vector<StrayKind> kinds{
    { "interior_samples",
      [&](Index s) { return reach(evidence, s) < 1.2 && evidence.spacings[s] > 1.5 * usual; }, 0,
      0.003, // a single one makes a small pit at most
      " samples seem to be on no surface: others are on all sides of them, and they are sparser "
      "than "
      "the others. Remove stray points; give points of the boundary only." },
    { "volume_samples", [&](Index s) { return reach(evidence, s) < 1; }, 0.2, 0.2,
      " samples have others on all sides, as in a volume or in strong noise. Give points of the "
      "boundary only, or sample thin walls more densely." },
    { "one_sided_samples", [&](Index s) { return isOneSided(evidence, s); }, 0.01, 0.01,
      " samples have the solid on both of their sides or on none. Give points of a closed surface, "
      "evenly spaced in all directions." },
    { "lost_surface", isLost, 0, 0,
      " samples, and all around them, have the solid on both of their sides or on none: the "
      "surface misses a thin part or "
      "a narrow gap there. Sample it more densely." },
    { "isolated_samples", isIsolated, 0, never,
      " samples are far from all others, measured by the spacing there. Remove outliers, or fill "
      "the "
      "gap around them." },
    { "clustered_samples",
      [&](Index s) { return nearestDistance(s) < 1e-3 * evidence.spacings[s]; }, 0.01, never,
      " samples are a thousand times nearer to another one than the spacing. Merge near "
      "duplicates." },
  };
  Warnings result;
  for (const StrayKind& kind : kinds)
  {
    append(evidence, kind, result);
  }
  return result;
}
}
