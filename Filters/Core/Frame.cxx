// SPDX-License-Identifier: BSD-3-Clause
#include "Frame.h"

#include "Errors.h"

#include <cmath>

namespace medial
{
namespace
{
void requireFinite(const std::vector<Point>& points)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!points[i].allFinite())
    {
      throw InvalidInput("sample " + std::to_string(i) +
        " has a coordinate that is not finite (NaN or infinity); remove such points");
    }
  }
}
}

Frame frameOf(const std::vector<Point>& points)
{
  if (points.empty())
  {
    throw InvalidInput("there are no samples; at least 4 points of a closed surface are needed");
  }
  requireFinite(points);
  Point lower = points.front(), upper = points.front();
  for (const Point& p : points)
  {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  const double size = 2 * (0.5 * upper - 0.5 * lower).maxCoeff();
  if (size == 0)
  {
    throw InvalidInput("all samples are in the same place; at least 4 distinct points of a closed "
                       "surface are needed");
  }
  const double largest = 1e90; // its cube, the unit of volumes, is still a normal double
  if (!(size < largest && size > 1 / largest))
  {
    throw InvalidInput(
      "the samples' bounding box is larger than 1e90 or smaller than 1e-90, so that "
      "volumes would leave the range of doubles; use another unit of length");
  }
  int exponent = 0;
  std::frexp(size, &exponent);
  return { 0.5 * lower + 0.5 * upper, std::ldexp(1.0, -exponent) };
}
}
