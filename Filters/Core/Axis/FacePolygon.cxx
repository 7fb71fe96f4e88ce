// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/FacePolygon.h"

#include <algorithm>
#include <utility>

namespace medial
{
void appendSimplePolygons(
  const std::vector<Index>& walk, Index siteEdge, std::vector<FacePolygon>& polygons)
{
  std::vector<Index> path;
  const auto emit = [&](std::vector<Index> corners) {
    if (corners.size() > 1)
    {
      polygons.push_back({ std::move(corners), siteEdge });
    }
  };
  for (const Index vertex : walk)
  {
    const auto before = std::find(path.begin(), path.end(), vertex);
    if (before == path.end())
    {
      path.push_back(vertex);
      continue;
    }
    emit({ before, path.end() });
    path.erase(before + 1, path.end());
  }
  emit(path);
}
}
