// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/VoronoiFaces.h"

#include "Base/DisjointSets.h"
#include "Base/Lists.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

// A Voronoi face is in the dual complex if all cells around its Delaunay edge are in the set. A face is
// found by a walk around the edge, so all faces together take time linear in the cells.
//
// Polygons know their corners only, so that two sides with the same two corners would be one. Where a
// vertex stands for many cells, several Voronoi edges go from it to the same other vertex, and a face may
// come to it more than once. If these were taken for one, the axis would get voids, or lose tunnels. So
// sides are told apart by the facets that they are dual to, and get vertices of their own in between.
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

/// For each edge: do all cells around it have the same vertex? Then its face shrinks to that.
std::vector<char> facesInVertices(const SiteTriangulation& sites, const AxisVertices& vertices)
{
  std::vector<Index> vertexOf(sites.edges.edges.size(), None);
  std::vector<char> result(vertexOf.size(), 1);
  for (Index c = 0; c < count(vertices.ofCell); ++c)
  {
    for (const Index e : sites.edges.ofCell[c])
    {
      vertexOf[e] = vertexOf[e] == None ? vertices.ofCell[c] : vertexOf[e];
      result[e] &= vertexOf[e] == vertices.ofCell[c];
    }
  }
  return result;
}

/// Leaves out one face of every Voronoi cell that is there with all its faces: one that no other such
/// cell has, so that cell and face collapse. Cells that shrink to a vertex have none to leave out.
void openCells(const SiteTriangulation& sites, const Outside& outside,
  const std::vector<char>& isInVertex, Faces& faces)
{
  const IndexLists around = listsByKey(sites.siteCount, [&](const auto& add) {
    for (Index e = 0; e < count(faces); ++e)
    {
      for (const Index v : sites.edges.edges[e])
      {
        if (faces[e] != None && !isInVertex[e] && !outside.vertices[v])
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

Faces keptFaces(const SiteTriangulation& sites, const OpenSet& set, const AxisVertices& vertices)
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
  openCells(sites, outside, facesInVertices(sites, vertices), faces);
  return faces;
}

/// A face as it is walked around: its vertices, and the Voronoi edge, by its facet, after each of them.
struct FaceWalk
{
  Index siteEdge;
  std::vector<Index> vertices, facetAfter;
};

/// A number for the facet between two neighbouring cells, the same from both.
Index facetBetween(const Tetrahedra& mesh, Index c, Index n)
{
  const Tetrahedron& across = mesh.neighbors[std::min(c, n)];
  return 4 * std::min(c, n) +
    static_cast<Index>(std::find(across.begin(), across.end(), std::max(c, n)) - across.begin());
}

FaceWalk faceWalk(
  const SiteTriangulation& sites, Index siteEdge, Index cell, const AxisVertices& vertices)
{
  const Edge& edge = sites.edges.edges[siteEdge];
  const Tetrahedron& corners = sites.mesh.cells[cell];
  int leave = 0; // any corner that is not on the edge
  while (corners[leave] == edge[0] || corners[leave] == edge[1])
  {
    ++leave;
  }
  const std::vector<Index> cells = cellsAround(sites.mesh, edge, cell, leave);
  FaceWalk walk{ siteEdge, {}, {} };
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const Index next = cells[(i + 1) % cells.size()];
    if (vertices.ofCell[cells[i]] != vertices.ofCell[next])
    {
      walk.vertices.push_back(vertices.ofCell[cells[i]]);
      walk.facetAfter.push_back(facetBetween(sites.mesh, cells[i], next));
    }
  }
  return walk;
}

/// The sides of faces: Voronoi edges between the same two vertices are one side where faces without any
/// other vertex connect them. Others enclose something, so all but one of these sides get a vertex in
/// their middle.
class VertexSides
{
public:
  VertexSides(const SiteTriangulation& sites, const OpenSet& set, const AxisVertices& vertices,
    const std::vector<FaceWalk>& walks, std::vector<Edge>& midpoints)
    : sideOfFacet(4 * count(sites.mesh.cells))
  {
    for (const FaceWalk& walk : walks)
    {
      if (walk.vertices.size() == 2)
      {
        this->sideOfFacet.unite(walk.facetAfter[0], walk.facetAfter[1]);
      }
    }
    std::vector<std::pair<Edge, Index>> all;
    for (Index c = 0; c < count(set.cells); ++c)
    {
      for (int i = 0; i < 4; ++i)
      {
        const Index n = sites.mesh.neighbors[c][i];
        if (n > c && set.cells[c] && set.cells[n] && vertices.ofCell[c] != vertices.ofCell[n] &&
          this->sideOfFacet.find(4 * c + i) == 4 * c + i)
        {
          const auto [a, b] = std::minmax(vertices.ofCell[c], vertices.ofCell[n]);
          all.push_back({ { a, b }, 4 * c + i });
        }
      }
    }
    std::sort(all.begin(), all.end());
    for (std::size_t i = 1; i < all.size(); ++i)
    {
      if (all[i].first == all[i - 1].first)
      {
        this->middles[all[i].second] = count(vertices.firstCell) + count(midpoints);
        midpoints.push_back(all[i].first);
      }
    }
  }

  /// The vertex in the middle of the side of a facet, or None.
  Index middle(Index facet)
  {
    const auto found = this->middles.find(this->sideOfFacet.find(facet));
    return found == this->middles.end() ? None : found->second;
  }

private:
  DisjointSets sideOfFacet; ///< each is known by its lowest facet
  std::map<Index, Index> middles;
};

std::vector<Index> withMiddles(const FaceWalk& walk, VertexSides& sides)
{
  std::vector<Index> corners;
  for (std::size_t i = 0; i < walk.vertices.size(); ++i)
  {
    corners.push_back(walk.vertices[i]);
    const Index middle = sides.middle(walk.facetAfter[i]);
    if (middle != None)
    {
      corners.push_back(middle);
    }
  }
  return corners;
}

/// Appends a face. Where it comes to a vertex again, it is another corner of it: the face gets a vertex
/// of its own beside it there.
void appendFace(const std::vector<Index>& corners, Index siteEdge, Index& nextVertex,
  std::vector<Edge>& midpoints, std::vector<FacePolygon>& polygons)
{
  const std::size_t n = corners.size();
  std::vector<Index> own(corners);
  for (std::size_t i = 1; i < n; ++i)
  {
    const auto begin = corners.begin();
    if (std::find(begin, begin + i, corners[i]) != begin + i)
    {
      own[i] = nextVertex++;
      midpoints.push_back({ corners[i - 1], corners[i] });
    }
  }
  polygons.push_back({ own, siteEdge });
  for (std::size_t i = 0; i < n; ++i)
  {
    const std::size_t k = (i + 1) % n;
    std::vector<Index> between{ corners[i], corners[k] };
    if (own[k] != corners[k])
    {
      between.push_back(own[k]);
    }
    if (own[i] != corners[i])
    {
      between.push_back(own[i]);
    }
    if (between.size() > 2)
    {
      polygons.push_back({ between, siteEdge });
    }
  }
}

/// Appends an edge, as two where it has a vertex in its middle.
void appendEdge(
  const Edge& ends, Index middle, FacePolygon edge, std::vector<FacePolygon>& polygons)
{
  edge.corners = { ends[0], middle == None ? ends[1] : middle };
  polygons.push_back(edge);
  if (middle != None)
  {
    edge.corners = { middle, ends[1] };
    polygons.push_back(edge);
  }
}

/// Appends the Voronoi edges in the set that are in no face.
void appendEdgesWithoutFace(const SiteTriangulation& sites, const OpenSet& set, const Faces& faces,
  const AxisVertices& vertices, VertexSides& sides, std::vector<FacePolygon>& polygons)
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
        inFace = inFace || (isInFacet(k, i) && faces[sites.edges.ofCell[c][k]] != None);
      }
      if (!inFace && vertices.ofCell[c] != vertices.ofCell[n])
      {
        appendEdge({ vertices.ofCell[c], vertices.ofCell[n] },
          sides.middle(facetBetween(sites.mesh, c, n)), { {}, None, facet(sites.mesh.cells[c], i) },
          polygons);
      }
    }
  }
}

}

VoronoiFaces voronoiFaces(const SiteTriangulation& sites, const OpenSet& set,
  const AxisVertices& vertices, const Execution& execution)
{
  const Faces faces = keptFaces(sites, set, vertices);
  std::vector<FaceWalk> walks;
  for (Index e = 0; e < count(faces); ++e)
  {
    execution.pollAt(e);
    if (faces[e] != None)
    {
      walks.push_back(faceWalk(sites, e, faces[e], vertices));
    }
  }
  execution.poll();
  VoronoiFaces result;
  VertexSides sides(sites, set, vertices, walks, result.midpoints);
  Index nextVertex = count(vertices.firstCell) + count(result.midpoints);
  execution.poll();
  for (const FaceWalk& walk : walks)
  {
    if (walk.vertices.size() == 2)
    {
      appendEdge({ walk.vertices[0], walk.vertices[1] }, sides.middle(walk.facetAfter[0]),
        { {}, walk.siteEdge }, result.polygons);
    }
    if (walk.vertices.size() > 2)
    {
      appendFace(
        withMiddles(walk, sides), walk.siteEdge, nextVertex, result.midpoints, result.polygons);
    }
  }
  execution.poll();
  appendEdgesWithoutFace(sites, set, faces, vertices, sides, result.polygons);
  return result;
}
}
