// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/VoronoiFaces.h"

#include "Base/DisjointSets.h"
#include "Base/Frame.h"
#include "Base/Lists.h"

#include <algorithm>
#include <numeric>

// A Voronoi face is in the dual complex if all cells around its Delaunay edge are in the set. A face is
// found by a walk around the edge, so all faces together take time linear in the cells.
//
// Sites lie on the boundary of the solid, so nearly every site has a cell outside the set. If one has none,
// its Voronoi cell would be a solid in the complex. The axis is to be a surface, so this cell is collapsed
// through one of its faces, one that is not shared with another such cell.

namespace medial
{
namespace
{
/// For each edge of the triangulation one of its cells in the set, if all of them are and the dual
/// face is kept; else None.
using Faces = std::vector<Index>;

/// Leaves out one face of every Voronoi cell that is there with all its faces: one that no other such
/// cell has, so that cell and face collapse.
void openCells(const SiteTriangulation& sites, const Outside& outside, Faces& faces)
{
  const IndexLists around = listsByKey(sites.siteCount, [&](const auto& add) {
    for (Index e = 0; e < count(faces); ++e)
    {
      for (const Index v : sites.edges.edges[e])
      {
        if (faces[e] != None && !outside.vertices[v])
        {
          add(v, e); // v has all its faces
        }
      }
    }
  });
  std::vector<char> open(outside.vertices);
  std::vector<Index> todo(sites.siteCount);
  std::iota(todo.begin(), todo.end(), 0);
  while (!todo.empty())
  {
    const Index v = todo.back();
    todo.pop_back();
    for (const Index e : around[v])
    {
      const Edge& ends = sites.edges.edges[e];
      const Index other = ends[0] == v ? ends[1] : ends[0];
      if (!open[v] && open[other] && faces[e] != None)
      {
        faces[e] = None;
        open[v] = 1;
        for (const Index f : around[v])
        {
          const Edge& next = sites.edges.edges[f];
          todo.push_back(next[0] == v ? next[1] : next[0]);
        }
      }
    }
  }
}

Faces keptFaces(const SiteTriangulation& sites, const OpenSet& set)
{
  const Outside outside = outsideOf(sites, set);
  Faces faces(sites.edges.edges.size(), None);
  for (Index c = 0; c < count(set.cells); ++c)
  {
    for (const Index e : sites.edges.ofCell[c])
    {
      if (set.cells[c] && !outside.edges[e])
      {
        faces[e] = c;
      }
    }
  }
  openCells(sites, outside, faces);
  return faces;
}

std::vector<FacePolygon> facePolygons(
  const SiteTriangulation& sites, const Faces& faces, const AxisVertices& vertices)
{
  std::vector<FacePolygon> polygons;
  for (Index e = 0; e < count(faces); ++e)
  {
    if (faces[e] == None)
    {
      continue;
    }
    const Edge& edge = sites.edges.edges[e];
    const Tetrahedron& corners = sites.mesh.cells[faces[e]];
    int leave = 0; // any corner that is not on the edge
    while (corners[leave] == edge[0] || corners[leave] == edge[1])
    {
      ++leave;
    }
    std::vector<Index> walk;
    for (const Index c : cellsAround(sites.mesh, edge, faces[e], leave))
    {
      if (walk.empty() || walk.back() != vertices.ofCell[c])
      {
        walk.push_back(vertices.ofCell[c]);
      }
    }
    appendSimplePolygons(walk, e, polygons);
  }
  return polygons;
}

/// Appends the Voronoi edges in the set that are in no face.
void appendEdgesWithoutFace(const SiteTriangulation& sites, const OpenSet& set, const Faces& faces,
  const AxisVertices& vertices, std::vector<FacePolygon>& polygons)
{
  for (Index c = 0; c < count(set.cells); ++c)
  {
    for (int i = 0; i < 4 && set.cells[c]; ++i)
    {
      const Index n = sites.mesh.neighbors[c][i];
      if (n < c || !set.cells[n])
      {
        continue;
      }
      bool inFace = false;
      for (int k = 0; k < 6; ++k)
      {
        const bool inFacet = cellEdges[k][0] != i && cellEdges[k][1] != i;
        inFace = inFace || (inFacet && faces[sites.edges.ofCell[c][k]] != None);
      }
      if (!inFace && vertices.ofCell[c] != vertices.ofCell[n])
      {
        polygons.push_back(
          { { vertices.ofCell[c], vertices.ofCell[n] }, None, facet(sites.mesh.cells[c], i) });
      }
    }
  }
}

}

AxisVertices axisVertices(const SiteTriangulation& sites, const OpenSet& set)
{
  DisjointSets classes(count(set.cells));
  for (Index c = 0; c < count(set.cells); ++c)
  {
    for (const Index n : sites.mesh.neighbors[c])
    {
      if (set.cells[c] && n > c && set.cells[n] &&
        ((sites.onBall[c] != None && sites.onBall[c] == sites.onBall[n]) ||
          (sites.spheres[c].center - sites.spheres[n].center).norm() < coincident))
      {
        classes.unite(c, n);
      }
    }
  }
  AxisVertices result;
  result.ofCell.assign(set.cells.size(), None);
  for (Index c = 0; c < count(set.cells); ++c)
  {
    if (!set.cells[c])
    {
      continue;
    }
    const Index first = classes.find(c);
    if (first == c)
    {
      result.firstCell.push_back(c);
      result.ball.push_back(None);
    }
    const Index vertex = first == c ? count(result.firstCell) - 1 : result.ofCell[first];
    result.ofCell[c] = vertex;
    const Index ball = sites.onBall[c];
    if (ball != None && (result.ball[vertex] == None || ball < result.ball[vertex]))
    {
      result.ball[vertex] = ball;
    }
  }
  return result;
}

std::vector<FacePolygon> voronoiFaces(
  const SiteTriangulation& sites, const OpenSet& set, const AxisVertices& vertices)
{
  const Faces faces = keptFaces(sites, set);
  std::vector<FacePolygon> polygons = facePolygons(sites, faces, vertices);
  appendEdgesWithoutFace(sites, set, faces, vertices, polygons);
  return polygons;
}
}
