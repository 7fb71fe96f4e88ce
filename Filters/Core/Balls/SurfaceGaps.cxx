// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/SurfaceGaps.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <iomanip>

namespace medial
{
namespace
{
/// The circle in which two spheres meet.
struct Circle
{
  Point center;
  double radius; ///< 0 where they don't meet
};

Circle commonCircle(const Ball& a, const Ball& b)
{
  const Point across = b.center - a.center;
  const double distance = across.norm();
  const double along =
    (distance * distance + a.radius * a.radius - b.radius * b.radius) / (2 * distance);
  const double squared = a.radius * a.radius - along * along;
  return { a.center + across * (along / distance), squared > 0 ? std::sqrt(squared) : 0 };
}
}

Warnings surfaceGaps(const SampleEvidence& evidence, const std::vector<char>& contested)
{
  const std::vector<double>& spacings = evidence.largestSpacings;
  constexpr double tooWide = 1.5; // spacings; circles of evenly spread samples stay below 1
  DisjointSets gaps(count(evidence.balls));
  std::vector<char> atGap(evidence.balls.size(), 0);
  Circle largest{ Point::Zero(), 0 };
  for (const auto& [a, b] : evidence.edges)
  {
    const bool crossed = evidence.sides[a] != evidence.sides[b] && !contested[a] && !contested[b];
    const Circle circle = crossed ? commonCircle(evidence.balls[a], evidence.balls[b]) : Circle();
    if (crossed && circle.radius > tooWide * std::max(spacings[a], spacings[b]))
    {
      gaps.unite(a, b);
      atGap[a] = atGap[b] = 1;
      largest = circle.radius > largest.radius ? circle : largest;
    }
  }
  Warning warning;
  for (Index b = 0; b < count(evidence.balls); ++b)
  {
    warning.count += atGap[b] && gaps.find(b) == b;
  }
  if (warning.count == 0)
  {
    return {};
  }
  // A disc with the local spacing as its radius holds six samples beside the one in its centre.
  double samples = 0;
  for (const double spacing : evidence.spacings)
  {
    samples += spacing * spacing / 6;
  }
  const double share = largest.radius * largest.radius / samples;
  warning.code = "gaps";
  warning.text = text(std::setprecision(3), "The surface crosses ", warning.count,
    " gaps without samples; the largest is ", 2 * largest.radius / evidence.frame.scale, " wide, ",
    100 * share, " % of the sampled area. Its shape is a guess there. Complete the samples.");
  warning.place = evidence.frame.toWorld(largest.center);
  warning.doubtsSolid = share > 0.025;
  return { warning };
}
}
