// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/ThicknessReport.h"

#include "Base/Errors.h"
#include "Measuring/LargestBalls.h"
#include "Measuring/SampleWalls.h"

#include <cmath>
#include <limits>

namespace medial
{
namespace
{
PlaceThickness thicknessAt(std::vector<Index> balls, const std::vector<double>& distances)
{
  PlaceThickness result{ std::move(balls), {} };
  result.diameters.reserve(result.balls.size());
  for (const Index ball : result.balls)
  {
    result.diameters.push_back(
      ball == None ? std::numeric_limits<double>::quiet_NaN() : 2 * distances[ball]);
  }
  return result;
}

Distribution ofInnerBalls(const PolarBalls& balls, const std::vector<double>& distances)
{
  std::vector<double> diameters;
  for (std::size_t b = 0; b < distances.size(); ++b)
  {
    if (balls.sides[b] == Side::Inner)
    {
      diameters.push_back(2 * distances[b]);
    }
  }
  return distribution(diameters);
}

void check(const ThicknessOptions& options)
{
  if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance))
  {
    throw InvalidInput("the tolerance is ", options.tolerance,
      "; give how far outside of a ball a place may be, in sample spacings: 0 or more");
  }
  if (options.points < 0)
  {
    throw InvalidInput("the number of points to measure at is ", options.points,
      "; give 0 for no means over the volume, or thousands");
  }
}
}

ThicknessReport thicknessReport(const PolarBalls& balls, const std::vector<Point>* places,
  const AxisComplex* axis, const ThicknessOptions& options, const Execution& execution)
{
  check(options);
  const std::vector<SampleWall> walls = sampleWalls(balls, execution.between(0, 0.1));
  const std::vector<double> distances = wallDistances(balls, walls);
  const double tolerance = options.tolerance * balls.spacing;
  ThicknessReport result;
  const auto measured = [&](Side side, const Execution& part) {
    return thicknessAt(
      largestBallsAt(balls, side, places ? *places : balls.samples, tolerance, part), distances);
  };
  result.inside = measured(Side::Inner, execution.between(0.1, 0.3));
  if (options.separation)
  {
    result.outside = measured(Side::Outer, execution.between(0.3, 0.6));
  }
  if (options.points > 0)
  {
    result.volume = volumeThickness(
      balls, distances, options.volume, options.points, execution.between(0.6, 0.9));
  }
  result.ofBalls = ofInnerBalls(balls, distances);
  if (axis)
  {
    result.thin = thinPlaces(*axis,
      axisThickness(*axis, balls, walls, distances, execution.between(0.9, 1)), options.depth);
  }
  execution.report(1);
  return result;
}
}
