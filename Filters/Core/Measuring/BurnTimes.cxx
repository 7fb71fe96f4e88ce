// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/BurnTimes.h"

#include <algorithm>
#include <limits>

namespace medial
{
// The erosion thickness of a point where lines end tells of the lines, which burn last; that of the triangles there
// tells of the sheet.
std::vector<double> burnTimes(const MedialAxis& axis)
{
  constexpr double noSheet = std::numeric_limits<double>::infinity();
  std::vector<double> sheet(axis.points.size(), noSheet);
  const Index first = axis.cells.firstTriangle();
  for (Index t = 0; t < count(axis.cells.triangles); ++t)
  {
    for (const Index p : axis.cells.triangles[t])
    {
      sheet[p] = std::min(sheet[p], axis.cellErosion[first + t]);
    }
  }
  std::vector<char> hasLine(axis.points.size(), 0);
  for (const Edge& line : axis.cells.edges)
  {
    hasLine[line[0]] = hasLine[line[1]] = 1;
  }
  std::vector<double> result = axis.radii;
  for (Index p = 0; p < count(axis.points); ++p)
  {
    const double erosion = hasLine[p] ? std::min(axis.erosion[p], sheet[p]) : axis.erosion[p];
    result[p] += sheet[p] < noSheet ? erosion : 0;
  }
  return result;
}
}
