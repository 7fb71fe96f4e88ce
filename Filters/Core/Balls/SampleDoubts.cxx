// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/SampleDoubts.h"

#include "Balls/ContestedBalls.h"
#include "Balls/SampleEvidence.h"
#include "Balls/StraySamples.h"
#include "Balls/SurfaceGaps.h"
#include "Balls/ThinFeatures.h"
#include "Balls/TinyPieces.h"
#include "Base/BettiWords.h"
#include "Base/Errors.h"
#include "Base/Lists.h"
#include "Base/Neighbors.h"
#include "Samples/NoiseEstimate.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>

namespace medial
{
namespace
{
struct Nearness
{
  std::vector<Index> nearest;   ///< of each sample
  std::vector<double> spacings; ///< see SampleEvidence
};

Nearness nearness(
  const std::vector<Point>& points, const Neighbors& neighbors, const Execution& execution)
{
  Nearness result;
  result.nearest.resize(points.size());
  result.spacings.resize(points.size());
  execution.forEach(count(points), [&](Index s) {
    const std::vector<Index> around = neighbors.nearest(s, 6);
    result.nearest[s] = around.front();
    result.spacings[s] = (points[around.back()] - points[s]).norm();
  });
  return result;
}

struct SpacingsAtBalls
{
  std::vector<double> largest, mean;
};

SpacingsAtBalls spacingsAtBalls(const DoubtInput& input, const std::vector<double>& spacings)
{
  std::vector<double> ofSample(input.samples.size(), 0);
  for (std::size_t s = 0; s < spacings.size(); ++s)
  {
    ofSample[input.distinct.ids[s]] = spacings[s];
  }
  SpacingsAtBalls result;
  for (Index b = 0; b < count(input.balls); ++b)
  {
    double largest = 0, sum = 0;
    for (const Index s : input.ballSamples[b])
    {
      largest = std::max(largest, ofSample[s]);
      sum += ofSample[s];
    }
    result.largest.push_back(largest);
    result.mean.push_back(sum / std::max(1, input.ballSamples[b].size()));
  }
  return result;
}

Warnings emptiness(const Betti& betti)
{
  if (betti[0] > 0)
  {
    return {};
  }
  return { { "no_inner_balls",
    "No ball is inside a solid: the samples are on an open surface, or there are far too few of "
    "them. Give samples of a closed surface.",
    0, {}, true } };
}

Warnings noise(
  const DistinctSamples& distinct, const Neighbors& neighbors, const Execution& execution)
{
  const double estimate = noiseEstimate(distinct.points, neighbors, execution);
  if (!(estimate > 0.3))
  {
    return {};
  }
  return { { "noise",
    text(std::setprecision(3), "Half of the samples scatter by ", estimate,
      " of their spacing or more about a smooth surface: noise, or features too small for the "
      "samples. Smooth the samples or take fewer of them against noise, more against small "
      "features."),
    count(distinct.points), {}, false } };
}

Warnings proportion(const Betti& betti, Index sampleCount)
{
  // A torus needs about so many samples.
  constexpr Index samplesForOne = 50;
  const Index features = betti[0] + betti[1] + betti[2];
  if ((features - 1) * samplesForOne <= sampleCount)
  {
    return {};
  }
  return { { "too_many_features",
    text("There are only ", sampleCount, " samples for ", inWords(betti),
      ". Sample the solid more densely."),
    features, {}, true } };
}

/// Were the coordinates rounded to floats, and does it matter? Numbers that floats hold by chance, such as
/// integers, rarely need the last bit of a float.
Warnings floatRounding(const DoubtInput& input, const std::vector<double>& spacings)
{
  constexpr int floatBits = std::numeric_limits<float>::digits;
  Index odd = 0;
  double largest = 0;
  for (const Point& sample : input.samples)
  {
    for (const double x : sample)
    {
      int exponent = 0;
      const double mantissa = std::ldexp(std::frexp(x, &exponent), floatBits);
      if (mantissa != std::floor(mantissa))
      {
        return {};
      }
      odd += std::fmod(mantissa, 2) != 0;
      largest = std::max(largest, std::abs(x));
    }
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  const double step = std::ldexp(1.0, exponent - floatBits);
  const double usual = median(spacings) / input.distinct.frame.scale;
  if (10 * odd < count(input.samples) || step < 1e-3 * usual)
  {
    return {};
  }
  return { { "float_rounding",
    text(std::setprecision(3), "The coordinates were rounded to 32-bit floats: they lie ", step,
      " apart, the samples ", usual,
      ". Move the object to the origin before it is stored so, or store doubles."),
    count(input.samples), {}, false } };
}

void append(Warnings& warnings, const Warnings& more)
{
  warnings.insert(warnings.end(), more.begin(), more.end());
}
}

Warnings sampleDoubts(const DoubtInput& input, const Execution& execution)
{
  const std::vector<Point>& points = input.distinct.points;
  const Neighbors neighbors(points);
  const Nearness near = nearness(points, neighbors, execution);
  execution.report(0.3);
  const SpacingsAtBalls atBalls = spacingsAtBalls(input, near.spacings);
  const SampleEvidence evidence{ input.distinct.frame, points, input.ballsOfSample, input.balls,
    input.sides, input.mesh, input.edges, near.spacings, atBalls.largest, atBalls.mean };
  execution.report(0.6);
  const std::vector<Support> support = supports(evidence);
  std::vector<char> contested(support.size());
  std::transform(support.begin(), support.end(), contested.begin(), isContested);

  Warnings result = contestedTopology(evidence, support, contested, input.powerShape);
  execution.report(0.9);
  append(result, thinFeatures(evidence, input.powerShape));
  append(result, emptiness(input.powerShape));
  append(result, proportion(input.powerShape, count(points)));
  append(result, tinyPieces(evidence));
  append(result, straySamples(evidence, neighbors, near.nearest));
  append(result, surfaceGaps(evidence, contested));
  append(result, noise(input.distinct, neighbors, execution));
  append(result, floatRounding(input, near.spacings));
  append(result, mergeWarnings(input.samples, input.distinct));
  execution.report(1);
  return result;
}
}
