// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/ShapeComplex.h"

#include <algorithm>
#include <utility>

namespace medial
{
namespace
{
bool areMarked(const std::vector<char>& marked, const Edge& edge)
{
  return marked[edge[0]] && marked[edge[1]];
}

template <typename Corners>
bool allAre(const std::vector<char>& marked, const Corners& corners)
{
  return std::all_of(corners.begin(), corners.end(), [&marked](Index p) { return marked[p] != 0; });
}

/// The number of a cell's edge between two of its points.
Index edgeBetween(
  const Tetrahedra& mesh, const EdgeNumbers& meshEdges, Index cell, Index a, Index b)
{
  for (int k = 0; k < 6; ++k)
  {
    const Index p = mesh.cells[cell][cellEdges[k][0]], q = mesh.cells[cell][cellEdges[k][1]];
    if ((p == a && q == b) || (p == b && q == a))
    {
      return meshEdges.ofCell[cell][k];
    }
  }
  return None;
}
}

ShapeComplex::ShapeComplex(const Tetrahedra& mesh, const std::vector<char>& marked)
{
  const EdgeNumbers meshEdges = edgeNumbers(mesh.cells, count(marked));
  std::vector<Index> edgeOfMesh(meshEdges.edges.size(), None);
  for (Index e = 0; e < count(meshEdges.edges); ++e)
  {
    if (areMarked(marked, meshEdges.edges[e]))
    {
      edgeOfMesh[e] = count(this->edges);
      this->edges.push_back(meshEdges.edges[e]);
    }
  }
  this->numberTriangles(mesh, marked, meshEdges, edgeOfMesh);
  this->livingTetrahedron.assign(this->tetrahedra.size(), 1);
  this->livingTriangle.assign(this->triangles.size(), 1);
  this->livingEdge.assign(this->edges.size(), 1);
  this->triangleLists = listsByKey(count(this->edges), [this](const auto& add) {
    for (Index t = 0; t < count(this->triangles); ++t)
    {
      for (const Index e : this->sides[t])
      {
        add(e, t);
      }
    }
  });
  for (Index e = 0; e < this->triangleLists.size(); ++e)
  {
    this->trianglesAtEdge.push_back(this->triangleLists[e].size());
  }
}

/// Numbers triangles and tetrahedra in the order of the mesh's cells; a triangle counts for the first of
/// its two cells.
void ShapeComplex::numberTriangles(const Tetrahedra& mesh, const std::vector<char>& marked,
  const EdgeNumbers& meshEdges, const std::vector<Index>& edgeOfMesh)
{
  std::vector<Tetrahedron> triangleOfFacet(mesh.cells.size(), { None, None, None, None });
  for (Index c = 0; c < count(mesh.cells); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      Triangle corners = facet(mesh.cells[c], i);
      const Index n = mesh.neighbors[c][i];
      if (triangleOfFacet[c][i] != None || !allAre(marked, corners))
      {
        continue;
      }
      std::sort(corners.begin(), corners.end());
      triangleOfFacet[c][i] = count(this->triangles);
      if (n != None)
      {
        const Tetrahedron& back = mesh.neighbors[n];
        triangleOfFacet[n][std::find(back.begin(), back.end(), c) - back.begin()] =
          count(this->triangles);
      }
      const auto side = [&](int a, int b) {
        return edgeOfMesh[edgeBetween(mesh, meshEdges, c, corners[a], corners[b])];
      };
      this->triangles.push_back(corners);
      this->sides.push_back({ side(1, 2), side(0, 2), side(0, 1) });
      this->cells.push_back({ None, None });
    }
    if (allAre(marked, mesh.cells[c]))
    {
      std::array<std::pair<Index, Index>, 4> sorted; // corner, triangle opposite to it
      for (int i = 0; i < 4; ++i)
      {
        sorted[i] = { mesh.cells[c][i], triangleOfFacet[c][i] };
        Edge& around = this->cells[triangleOfFacet[c][i]];
        around[around[0] == None ? 0 : 1] = count(this->tetrahedra);
      }
      std::sort(sorted.begin(), sorted.end());
      this->tetrahedra.push_back(
        { sorted[0].first, sorted[1].first, sorted[2].first, sorted[3].first });
      this->facets.push_back(
        { sorted[0].second, sorted[1].second, sorted[2].second, sorted[3].second });
    }
  }
}

int ShapeComplex::tetrahedronCount(Index triangle) const
{
  int result = 0;
  for (const Index c : this->cells[triangle])
  {
    result += c != None && this->livingTetrahedron[c];
  }
  return result;
}

Index ShapeComplex::onlyTetrahedron(Index triangle) const
{
  Index result = None;
  for (const Index c : this->cells[triangle])
  {
    if (c != None && this->livingTetrahedron[c])
    {
      if (result != None)
      {
        return None;
      }
      result = c;
    }
  }
  return result;
}

std::vector<Index> ShapeComplex::trianglesAt(Index edge) const
{
  std::vector<Index> result;
  for (const Index t : this->triangleLists[edge])
  {
    if (this->livingTriangle[t])
    {
      result.push_back(t);
    }
  }
  return result;
}

bool ShapeComplex::collapseTetrahedron(Index tetrahedron, Index triangle)
{
  if (!this->livingTetrahedron[tetrahedron] || !this->livingTriangle[triangle] ||
    this->onlyTetrahedron(triangle) != tetrahedron)
  {
    return false;
  }
  this->livingTetrahedron[tetrahedron] = 0;
  this->livingTriangle[triangle] = 0;
  for (const Index e : this->sides[triangle])
  {
    --this->trianglesAtEdge[e];
  }
  return true;
}

bool ShapeComplex::collapseTriangle(Index triangle, Index edge)
{
  const Triangle& own = this->sides[triangle];
  if (!this->livingTriangle[triangle] || this->tetrahedronCount(triangle) > 0 ||
    !this->livingEdge[edge] || this->trianglesAtEdge[edge] != 1 ||
    std::find(own.begin(), own.end(), edge) == own.end())
  {
    return false;
  }
  this->livingTriangle[triangle] = 0;
  this->livingEdge[edge] = 0;
  for (const Index e : own)
  {
    --this->trianglesAtEdge[e];
  }
  return true;
}
}
