// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/RodCells.h"

#include "Base/DisjointSets.h"

namespace medial
{
namespace
{
/// RodCells::anchor by the rest of it.
std::vector<char> anchors(const MedialAxis& axis, const AxisEdges& edges, const RodCells& rods)
{
  const Index pointCount = count(axis.points);
  const auto isContact = [&](Index p) { return rods.points[p] && rods.plateAt[p] != None; };
  DisjointSets contacts(pointCount);
  for (Index e = 0; e < count(edges.points); ++e)
  {
    const auto& [a, b] = edges.points[e];
    if (rods.edges[e] && isContact(a) && isContact(b))
    {
      contacts.unite(a, b);
    }
  }
  std::vector<Index> last(pointCount, None);
  const auto time = [&axis](Index p) { return axis.erosion[p] + axis.radii[p]; };
  for (Index p = 0; p < pointCount; ++p)
  {
    Index& best = last[contacts.find(p)];
    best = isContact(p) && (best == None || time(p) > time(best)) ? p : best;
  }
  std::vector<char> result(pointCount, 0);
  for (const Index p : last)
  {
    if (p != None)
    {
      result[p] = 1;
    }
  }
  return result;
}

}

RodCells rodCells(const MedialAxis& axis, const AxisEdges& edges, const PlatePieces& plates)
{
  RodCells result;
  result.points.assign(axis.points.size(), 0);
  result.plateAt.assign(axis.points.size(), None);
  result.edges.assign(edges.points.size(), 0);
  for (Index t = 0; t < count(axis.cells.triangles); ++t)
  {
    const Index plate = plates.ofTriangle[t];
    result.triangles.push_back(plate == None);
    for (int i = 0; i < 3; ++i)
    {
      const Index p = axis.cells.triangles[t][i];
      if (plate == None)
      {
        result.points[p] = result.edges[edges.ofTriangle[t][i]] = 1;
      }
      else if (result.plateAt[p] == None || plate < result.plateAt[p])
      {
        result.plateAt[p] = plate;
      }
    }
  }
  for (const Index e : edges.ofDangling)
  {
    result.edges[e] = result.points[edges.points[e][0]] = result.points[edges.points[e][1]] = 1;
  }
  for (const Index p : axis.cells.vertices)
  {
    result.points[p] = 1;
  }
  result.anchor = anchors(axis, edges, result);
  return result;
}
}
