// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/StraySamples.h"

#include <algorithm>
#include <sstream>

namespace medial
{
namespace
{
double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A warning about the samples for which `isMeant` is true; its count is 0 where there is none.
template <typename IsMeant>
Warning about(const SampleEvidence& evidence, const char* code, const IsMeant& isMeant)
{
  Warning result;
  result.code = code;
  for (Index s = 0; s < count(evidence.points); ++s)
  {
    if (isMeant(s))
    {
      result.place = result.place ? result.place : evidence.frame.toWorld(evidence.points[s]);
      ++result.count;
    }
  }
  return result;
}

/// The radius of a sample's larger polar ball, in local spacings. On a surface it is the distance to the
/// medial axis on one of its sides, many spacings where the samples are dense.
double reach(const SampleEvidence& evidence, Index s)
{
  const Index first = evidence.ballsOfSample[s][0];
  return evidence.balls[first].radius / evidence.spacings[s];
}

bool isOneSided(const SampleEvidence& evidence, Index s)
{
  const auto [first, second] = evidence.ballsOfSample[s];
  if (first == None || second == None || evidence.sides[first] != evidence.sides[second] ||
    evidence.sides[first] == Side::Hidden)
  {
    return false;
  }
  const Point u = evidence.balls[first].center - evidence.points[s];
  const Point v = evidence.balls[second].center - evidence.points[s];
  return -u.normalized().dot(v.normalized()) > 0.5; // not at a sharp edge
}

void append(Warnings& warnings, Warning warning, double share, double allowed, const char* seen)
{
  if (warning.count > allowed * share)
  {
    std::ostringstream text;
    text << warning.count << seen;
    warning.text = text.str();
    warnings.push_back(std::move(warning));
  }
}
}

Warnings straySamples(const SampleEvidence& evidence, const std::vector<Index>& nearest)
{
  const auto all = static_cast<double>(evidence.points.size());
  const double usual = median(evidence.spacings);
  const auto nearestDistance = [&](Index s) {
    return (evidence.points[nearest[s]] - evidence.points[s]).norm();
  };
  Warnings result;
  Warning interior = about(evidence, "interior_samples",
    [&](Index s) { return reach(evidence, s) < 1.2 && evidence.spacings[s] > 1.5 * usual; });
  interior.doubtsSolid = true;
  append(result, std::move(interior), all, 0,
    " samples seem to be on no surface: there are samples on all sides of them, and they are "
    "sparser "
    "than the others. Remove stray points; give points of the boundary only.");
  Warning volume =
    about(evidence, "volume_samples", [&](Index s) { return reach(evidence, s) < 1; });
  volume.doubtsSolid = true;
  append(result, std::move(volume), all, 0.03,
    " samples are surrounded by others on all sides, as in a volume or in strong noise. Give "
    "points "
    "of the boundary only, or sample thin walls more densely.");
  Warning oneSided =
    about(evidence, "one_sided_samples", [&](Index s) { return isOneSided(evidence, s); });
  oneSided.doubtsSolid = true;
  append(result, std::move(oneSided), all, 0.02,
    " samples have the solid on both of their sides or on none. Give points of a closed surface, "
    "evenly "
    "spaced in all directions.");
  append(result,
    about(evidence, "isolated_samples",
      [&](Index s) { return nearestDistance(s) > 3 * evidence.spacings[nearest[s]]; }),
    all, 0,
    " samples are far from all others, measured by the spacing there. Remove outliers, or fill the "
    "gap "
    "around them.");
  append(result,
    about(evidence, "clustered_samples",
      [&](Index s) { return nearestDistance(s) < 1e-3 * evidence.spacings[s]; }),
    all, 0.01,
    " samples are a thousand times nearer to another one than the spacing. Merge near duplicates.");
  return result;
}
}
