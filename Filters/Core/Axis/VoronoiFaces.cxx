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

/// A number for the facet of a cell opposite to its corner i, the same from both sides.
Index facetNumber(const Tetrahedra& mesh, Index cell, int i)
{
  const Index neighbor = mesh.neighbors[cell][i];
  if (cell < neighbor)
  {
    return 4 * cell + i;
  }
  const Tetrahedron& across = mesh.neighbors[neighbor];
  return 4 * neighbor +
    static_cast<Index>(std::find(across.begin(), across.end(), cell) - across.begin());
}

/// Calls body(cell, facet that leads to the next one) for the cells around an edge of sites, which are all in
/// the set, in any direction.
template <typename Body>
void forCellsAround(const SiteTriangulation& sites, Index edge, Index start, const Body& body)
{
  const Edge& ends = sites.edges.edges[edge];
  const Tetrahedron& corners = sites.mesh.cells[start];
  int leave = 0;
  while (corners[leave] == ends[0] || corners[leave] == ends[1])
  {
    ++leave;
  }
  forCellsAround(sites.mesh, ends, start, leave, body);
}

/// Do all cells around an edge have the same vertex? Then its face shrinks to that.
bool isInVertex(
  const SiteTriangulation& sites, Index edge, Index cell, const AxisVertices& vertices)
{
  bool result = true;
  forCellsAround(sites, edge, cell,
    [&](Index c, int) { result = result && vertices.ofCell[c] == vertices.ofCell[cell]; });
  return result;
}

/// Leaves out one face of every Voronoi cell that is there with all its faces: one that no other such
/// cell has, so that cell and face collapse. Cells that shrink to a vertex have none to leave out.
void openCells(const SiteTriangulation& sites, const Outside& outside, const AxisVertices& vertices,
  Faces& faces)
{
  const IndexLists around = listsByKey(sites.siteCount, [&](const auto& add) {
    for (Index e = 0; e < count(faces); ++e)
    {
      for (const Index v : sites.edges.edges[e])
      {
        if (faces[e] != None && !outside.vertices[v] && !isInVertex(sites, e, faces[e], vertices))
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
  openCells(sites, outside, vertices, faces);
  return faces;
}

/// Faces as they are walked around: the vertices of each, and the Voronoi edge, by its facet, after each of
/// them.
struct FaceWalks
{
  std::vector<Index> siteEdges;
  IndexLists vertices;
  std::vector<Index> facets; ///< after each item of `vertices`

  const Index* facetsOf(Index walk) const { return this->facets.data() + vertices.offsets[walk]; }
};

FaceWalks faceWalks(const SiteTriangulation& sites, const Faces& faces,
  const AxisVertices& vertices, const Execution& execution)
{
  FaceWalks result;
  for (Index e = 0; e < count(faces); ++e)
  {
    execution.pollAt(e);
    if (faces[e] == None)
    {
      continue;
    }
    forCellsAround(sites, e, faces[e], [&](Index cell, int leave) {
      if (vertices.ofCell[cell] != vertices.ofCell[sites.mesh.neighbors[cell][leave]])
      {
        result.vertices.items.push_back(vertices.ofCell[cell]);
        result.facets.push_back(facetNumber(sites.mesh, cell, leave));
      }
    });
    result.siteEdges.push_back(e);
    result.vertices.close();
  }
  return result;
}

/// The sides of faces: Voronoi edges between the same two vertices are one side where faces without any
/// other vertex connect them. Others enclose something, so all but one of these sides get a vertex in
/// their middle.
class VertexSides
{
public:
  VertexSides(const SiteTriangulation& sites, const OpenSet& set, const AxisVertices& vertices,
    const FaceWalks& walks, std::vector<Edge>& midpoints)
    : sideOfFacet(4 * count(sites.mesh.cells))
  {
    for (Index w = 0; w < walks.vertices.size(); ++w)
    {
      if (walks.vertices[w].size() == 2)
      {
        this->sideOfFacet.unite(walks.facetsOf(w)[0], walks.facetsOf(w)[1]);
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
    if (this->middles.empty())
    {
      return None;
    }
    const auto found = this->middles.find(this->sideOfFacet.find(facet));
    return found == this->middles.end() ? None : found->second;
  }

private:
  DisjointSets sideOfFacet; ///< each is known by its lowest facet
  std::map<Index, Index> middles;
};

/// The corners of a face in order: its vertices, and what is in the middle of its sides.
void findCorners(
  const FaceWalks& walks, Index walk, VertexSides& sides, std::vector<Index>& corners)
{
  const IndexLists::View vertices = walks.vertices[walk];
  corners.clear();
  for (Index i = 0; i < vertices.size(); ++i)
  {
    corners.push_back(vertices[i]);
    const Index middle = sides.middle(walks.facetsOf(walk)[i]);
    if (middle != None)
    {
      corners.push_back(middle);
    }
  }
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
  if (own == corners)
  {
    polygons.push_back({ std::move(own), siteEdge });
    return;
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
        appendEdge({ vertices.ofCell[c], vertices.ofCell[n] }, sides.middle(4 * c + i),
          { {}, None, facet(sites.mesh.cells[c], i) }, polygons);
      }
    }
  }
}

}

VoronoiFaces voronoiFaces(const SiteTriangulation& sites, const OpenSet& set,
  const AxisVertices& vertices, const Execution& execution)
{
  const Faces faces = keptFaces(sites, set, vertices);
  const FaceWalks walks = faceWalks(sites, faces, vertices, execution);
  execution.poll();
  VoronoiFaces result;
  VertexSides sides(sites, set, vertices, walks, result.midpoints);
  Index nextVertex = count(vertices.firstCell) + count(result.midpoints);
  execution.poll();
  result.polygons.reserve(walks.siteEdges.size());
  std::vector<Index> corners;
  for (Index w = 0; w < walks.vertices.size(); ++w)
  {
    const IndexLists::View own = walks.vertices[w];
    if (own.size() == 2)
    {
      appendEdge({ own[0], own[1] }, sides.middle(walks.facetsOf(w)[0]), { {}, walks.siteEdges[w] },
        result.polygons);
    }
    if (own.size() > 2)
    {
      findCorners(walks, w, sides, corners);
      appendFace(corners, walks.siteEdges[w], nextVertex, result.midpoints, result.polygons);
    }
  }
  execution.poll();
  appendEdgesWithoutFace(sites, set, faces, vertices, sides, result.polygons);
  return result;
}
}
