// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Frame.h"

#include "Base/Errors.h"

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
      throw InvalidInput(
        "sample ", i, " has a coordinate that is not finite (NaN or infinity); remove such points");
    }
  }
}
}

Eigen::AlignedBox3d boundingBox(const std::vector<Point>& points)
{
  Eigen::AlignedBox3d box;
  for (const Point& p : points)
  {
    box.extend(p);
  }
  return box;
}

Frame frameOf(const std::vector<Point>& points)
{
  if (points.empty())
  {
    throw InvalidInput("there are no samples; at least 4 points of a closed surface are needed");
  }
  requireFinite(points);
  const Eigen::AlignedBox3d box = boundingBox(points);
  // Half of the corners: their difference can't overflow.
  const Point lower = 0.5 * box.min(), upper = 0.5 * box.max();
  const double size = 2 * (upper - lower).maxCoeff();
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
  return { lower + upper, std::ldexp(1.0, -exponent) };
}
}
