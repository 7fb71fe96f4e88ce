// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Centerline_h
#define medial_Centerline_h

#include "Base/Types.h"

#include <cstddef>
#include <vector>

namespace medial
{
/// A polyline along the middle of a rod.
struct Centerline
{
  // One entry for each of its points, two or more; the first is repeated at the end of a loop.
  std::vector<Point> points;
  std::vector<double> radii; ///< of the largest ball about the point in the solid
  std::vector<double>
    halfWidths; ///< of the sheet of the axis there; the radius on lines, see burnTimes()

  Edge nodes; ///< what its ends are numbered; None twice for a loop that meets nothing
};

/// The length along a polyline up to each of its points.
inline std::vector<double> lengths(const std::vector<Point>& line)
{
  std::vector<double> result(line.size(), 0);
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    result[i] = result[i - 1] + (line[i] - line[i - 1]).norm();
  }
  return result;
}
}

#endif
