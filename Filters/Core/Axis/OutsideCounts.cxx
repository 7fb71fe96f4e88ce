// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/OutsideCounts.h"

#include <algorithm>

namespace medial
{
BoundaryPiece boundaryPiece(
  const std::array<bool, 4>& vertices, const std::array<bool, 6>& edges, int facets)
{
  int component[4] = { 0, 1, 2, 3 };
  auto components = static_cast<int>(std::count(vertices.begin(), vertices.end(), true));
  int euler = components + facets;
  for (int k = 0; k < 6; ++k)
  {
    if (edges[k])
    {
      --euler;
      const int a = component[cellEdges[k][0]], b = component[cellEdges[k][1]];
      components -= a != b;
      std::replace(component, component + 4, b, a);
    }
  }
  return { components, components - euler };
}

OutsideCounts::OutsideCounts(const SiteTriangulation& triangulation)
  : sites(triangulation)
  , atVertex(triangulation.siteCount, 0)
  , atEdge(triangulation.edges.edges.size(), 0)
{
  for (Index c = 0; c < count(triangulation.mesh.cells); ++c)
  {
    this->putOut(c);
    for (int i = 0; i < 4; ++i)
    {
      if (triangulation.mesh.neighbors[c][i] == None)
      {
        this->addBeyond(c, i);
      }
    }
  }
}

BoundaryPiece OutsideCounts::sharedWithOthers(Index cell, int facets) const
{
  std::array<bool, 4> vertices;
  std::array<bool, 6> edges;
  for (int i = 0; i < 4; ++i)
  {
    vertices[i] = this->atVertex[this->sites.mesh.cells[cell][i]] > 1;
  }
  for (int k = 0; k < 6; ++k)
  {
    edges[k] = this->atEdge[this->sites.edges.ofCell[cell][k]] > 1;
  }
  return boundaryPiece(vertices, edges, facets);
}

void OutsideCounts::add(Index cell, Index one)
{
  for (const Index v : this->sites.mesh.cells[cell])
  {
    this->atVertex[v] += one;
  }
  for (const Index e : this->sites.edges.ofCell[cell])
  {
    this->atEdge[e] += one;
  }
}

void OutsideCounts::addBeyond(Index cell, int i)
{
  for (const Index v : facet(this->sites.mesh.cells[cell], i))
  {
    ++this->atVertex[v];
  }
  for (int k = 0; k < 6; ++k)
  {
    this->atEdge[this->sites.edges.ofCell[cell][k]] += isInFacet(k, i);
  }
}
}
