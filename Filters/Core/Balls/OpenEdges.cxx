// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/OpenEdges.h"

#include "Base/Errors.h"

#include <algorithm>

namespace medial
{
namespace
{
/// All edges of the polygons, the lower point first, once for each use. Edges without a length are left
/// out.
std::vector<Edge> edgesOf(const IndexLists& polygons, const std::vector<Index>& duplicateOf)
{
  const auto distinct = [&duplicateOf](
                          Index p) { return duplicateOf[p] == None ? p : duplicateOf[p]; };
  std::vector<Edge> result;
  result.reserve(polygons.items.size());
  for (Index i = 0; i < polygons.size(); ++i)
  {
    const IndexLists::View corners = polygons[i];
    for (Index k = 0; k < corners.size(); ++k)
    {
      const Index a = distinct(corners[k]), b = distinct(corners[(k + 1) % corners.size()]);
      if (a != b)
      {
        result.push_back({ std::min(a, b), std::max(a, b) });
      }
    }
  }
  return result;
}
}

std::vector<Edge> openEdges(const IndexLists& polygons, const std::vector<Index>& duplicateOf)
{
  std::vector<Edge> edges = edgesOf(polygons, duplicateOf);
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> result;
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    if (next - edge == 1)
    {
      result.push_back(*edge);
    }
    edge = next;
  }
  return result;
}

Warnings openSurfaceWarnings(const IndexLists& polygons, const std::vector<Index>& duplicateOf,
  const std::vector<Point>& points)
{
  const std::vector<Edge> open = openEdges(polygons, duplicateOf);
  if (open.empty())
  {
    return {};
  }
  const Index number = count(open);
  return { { "open_surface",
    text("The surface is open: ", number, number == 1 ? " edge has" : " edges have",
      " a polygon on one side only. Gaps between the points are closed as the balls have it; fill "
      "large holes first, or look at the result there."),
    number, points[open.front()[0]], false } };
}
}
