// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/SamplingOptions.h"

#include "Base/Errors.h"
#include "Base/Frame.h"
#include "Samples/BlueNoise.h"

#include <algorithm>
#include <cmath>

namespace medial
{
void check(const SamplingOptions& options)
{
  if (!(options.fineness > 0 && options.fineness <= 1))
  {
    throw InvalidInput("the fineness must be above 0 and at most 1, it is ", options.fineness);
  }
  if (!(options.spacing >= 0) || !std::isfinite(options.spacing))
  {
    throw InvalidInput("the spacing must be 0 or more, it is ", options.spacing);
  }
  if (options.maximumSamples < 4)
  {
    throw InvalidInput("there must be room for 4 samples, not ", options.maximumSamples);
  }
  if (!(options.sharpAngle > 0 && options.sharpAngle <= 180))
  {
    throw InvalidInput(
      "the sharp angle must be above 0 and at most 180 degrees, it is ", options.sharpAngle);
  }
}

double usualSpacing(const ClosedSurface& surface)
{
  const double samples = std::clamp<double>(count(surface.points), 20000, 50000);
  return std::sqrt(samplesPerSquare * surface.area / samples);
}

double closestSpacing(const ClosedSurface& surface, const SamplingOptions& options)
{
  constexpr double rounding = 1 + 1e-9; // no more than these, however the areas of pieces add up
  return rounding * std::sqrt(samplesPerSquare * surface.area / options.maximumSamples);
}

void checkLength(const ClosedSurface& surface)
{
  constexpr double longest = 2e4; // spacings: a square rod takes about a million samples then
  const double diagonal = boundingBox(surface.points).diagonal().norm();
  if (diagonal > longest * usualSpacing(surface))
  {
    throw InvalidInput("the surface is ", diagonal, " long, but has an area of only ", surface.area,
      ": too narrow to be sampled; is a point at a wrong place far away?");
  }
}
}
