// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/CrustSurface.h"

#include "Base/DisjointSets.h"
#include "Base/EdgeTable.h"
#include "Base/Frame.h"
#include "Base/Lists.h"
#include "Base/Polygons.h"

#include <algorithm>
#include <cstdint>

namespace medial
{
namespace
{
/// The faces between inner and outer power cells. A power vertex is named by its tetrahedron of the
/// dual, so a face is the cycle of tetrahedra around its dual edge.
struct CellFaces
{
  Lists<Index> cycles;     ///< counter-clockwise seen from outside
  std::vector<Edge> balls; ///< inner, outer
};

/// The cells around the dual edge (inner, outer), counter-clockwise seen from the outer ball; empty
/// where the edge is on the convex hull.
std::vector<Index> cycleAround(const Tetrahedra& mesh, Index inner, Index outer, Index start)
{
  const Tetrahedron& corners = mesh.cells[start];
  const auto place = [](const auto& balls, Index ball) {
    return static_cast<int>(std::find(balls.begin(), balls.end(), ball) - balls.begin());
  };
  // Of the facets with the edge, leave by the one from which the turn is counter-clockwise.
  const Triangle seen = facet(corners, place(corners, inner)); // so seen from the inner ball
  const Index leave = seen[(place(seen, outer) + 2) % 3];
  return cellsAround(mesh, { inner, outer }, start, place(corners, leave));
}

/// The bit of a cell's edge between two of its corners.
unsigned edgeBit(const Tetrahedron& corners, Index a, Index b)
{
  unsigned ends = 0;
  for (int i = 0; i < 4; ++i)
  {
    ends |= static_cast<unsigned>(corners[i] == a || corners[i] == b) << i;
  }
  return 1U << ends; // of six edges and ten other sets of corners
}

/// One face for each dual edge between an inner and an outer ball. An edge is met in each of the cells
/// around it, and known there by a bit.
CellFaces cellFaces(const PowerDiagram& diagram, const Execution& execution)
{
  CellFaces result;
  const Tetrahedra& mesh = diagram.dual;
  std::vector<std::uint16_t> done(mesh.cells.size(), 0);
  for (Index c = 0; c < count(mesh.cells); ++c)
  {
    execution.pollAt(c);
    for (const auto& ends : cellEdges)
    {
      Index a = mesh.cells[c][ends[0]], b = mesh.cells[c][ends[1]];
      if (diagram.inner[a] == diagram.inner[b] || (done[c] & edgeBit(mesh.cells[c], a, b)) != 0)
      {
        continue;
      }
      if (!diagram.inner[a])
      {
        std::swap(a, b);
      }
      const std::vector<Index> cycle = cycleAround(mesh, a, b, c);
      for (const Index cell : cycle)
      {
        done[cell] |= edgeBit(mesh.cells[cell], a, b);
      }
      if (!cycle.empty())
      {
        result.cycles.append(cycle);
        result.balls.push_back({ a, b });
      }
    }
  }
  return result;
}

/// Sets of neighbouring power vertices that become one point of the crust.
///
/// All polar balls through a sample meet in it, so very many power vertices are at a sample, joined by
/// edges of length zero and faces without area. They are contracted: a set whose vertices, edges and
/// faces form a disc can shrink to a point without changing the surface's topology. A ring of
/// vertices around a handle, say, can't; such a set is split into its vertices again, and they stay
/// several points at one place. So the exact arithmetic of the regular triangulation decides the
/// topology, and contraction never changes it.
///
/// Invariant: the surface is a closed 2-manifold with the topology of the diagram's.
/// The steps take linear time on average each. `splitWherePinched` repeats, since a split set can
/// pinch its neighbours; each turn splits one set at least, and two or three turns are usual.
class Contraction
{
public:
  Contraction(
    const PowerDiagram& powerDiagram, const CellFaces& cellFaces, const Execution& ofContraction)
    : diagram(powerDiagram)
    , faces(cellFaces)
    , execution(ofContraction)
    , sets(count(powerDiagram.dual.cells))
  {
    this->unite();
    execution.poll();
    this->splitUnlessDiscs();
    while (this->splitWherePinched())
    {
    }
  }

  /// The vertices of each face, neighbours that become one named once. None where the face shrinks to an edge
  /// or a point. Vertices are numbered in the order in which they are met.
  const IndexLists& loops() const { return this->contracted; }

  /// The number of the vertex of a tetrahedron, None where it is in no loop.
  Index numberOf(Index cell) { return this->number[this->vertexOf(cell)]; }

  Index vertexCount() const { return count(this->vertices); }

private:
  /// The vertex of a tetrahedron: the lowest one of its set, or itself where the set was split.
  Index vertexOf(Index cell)
  {
    const Index set = this->sets.find(cell);
    return this->split[set] ? cell : set;
  }

  void appendLoop(Index face, std::vector<Index>& loop)
  {
    loop.clear();
    for (const Index cell : this->faces.cycles[face])
    {
      const Index vertex = this->vertexOf(cell);
      if (loop.empty() || loop.back() != vertex)
      {
        loop.push_back(vertex);
      }
    }
    while (loop.size() > 1 && loop.back() == loop.front())
    {
      loop.pop_back();
    }
    if (loop.size() < 3)
    {
      loop.clear();
    }
    for (Index& vertex : loop)
    {
      if (this->number[vertex] == None)
      {
        this->number[vertex] = count(this->vertices);
        this->vertices.push_back(vertex);
      }
      vertex = this->number[vertex];
    }
    this->contracted.append(loop);
  }

  void contract()
  {
    this->number.assign(this->split.size(), None);
    this->vertices.clear();
    this->contracted.items.clear();
    this->contracted.offsets.assign(1, 0);
    std::vector<Index> loop;
    for (Index face = 0; face < this->faces.cycles.size(); ++face)
    {
      this->execution.pollAt(face);
      this->appendLoop(face, loop);
    }
  }

  /// Are two power vertices the same? Samples are compared by their numbers; only where one of the
  /// two is no sample its place decides.
  bool fallTogether(Index a, Index b) const
  {
    const Index s = this->diagram.sampleOfVertex[a], t = this->diagram.sampleOfVertex[b];
    return s != None && t != None
      ? s == t
      : (this->diagram.vertices[a] - this->diagram.vertices[b]).norm() < coincident;
  }

  /// Unites vertices along edges of the surface only: vertices at the same place that no such edge
  /// joins belong to different sheets of it.
  void unite()
  {
    for (Index face = 0; face < this->faces.cycles.size(); ++face)
    {
      const auto cycle = this->faces.cycles[face];
      for (Index k = 0; k < cycle.size(); ++k)
      {
        const Index a = cycle[k], b = cycle[(k + 1) % cycle.size()];
        if (this->fallTogether(a, b))
        {
          this->sets.unite(a, b);
        }
      }
    }
    this->split.assign(this->diagram.dual.cells.size(), 0);
  }

  /// Splits sets whose vertices, edges and faces don't form a disc. A connected piece of a surface that
  /// isn't closed is a disc if and only if vertices - edges + faces is 1.
  void splitUnlessDiscs()
  {
    std::vector<Index> euler(this->split.size(), 0); // doubled: each edge is met twice
    std::vector<char> counted(this->split.size(), 0);
    for (Index face = 0; face < this->faces.cycles.size(); ++face)
    {
      const auto cycle = this->faces.cycles[face];
      bool inside = true;
      for (Index k = 0; k < cycle.size(); ++k)
      {
        const Index set = this->sets.find(cycle[k]);
        euler[set] += counted[cycle[k]] ? 0 : 2;
        counted[cycle[k]] = 1;
        const bool sameSet = set == this->sets.find(cycle[(k + 1) % cycle.size()]);
        euler[set] -= sameSet;
        inside = inside && sameSet;
      }
      if (inside && cycle.size() > 0)
      {
        euler[this->sets.find(cycle[0])] += 2;
      }
    }
    for (std::size_t set = 0; set < this->split.size(); ++set)
    {
      this->split[set] = counted[set] && euler[set] != 2;
    }
  }

  /// Splits sets at which a face has a corner twice, or between which there are several edges: discs
  /// that leave a manifold, but not one that can be given by its triangles' corners.
  /// @return  was any split?
  bool splitWherePinched()
  {
    bool any = false;
    const auto splitSet = [&](Index vertexNumber) {
      const Index set = this->sets.find(this->vertices[vertexNumber]);
      any = any || !this->split[set];
      this->split[set] = 1;
    };
    this->contract();
    EdgeTable sides(this->contracted.items.size());
    std::vector<Index> loop;
    for (Index face = 0; face < this->contracted.size(); ++face)
    {
      this->execution.pollAt(face);
      loop.assign(this->contracted[face].begin(), this->contracted[face].end());
      for (std::size_t k = 0; k < loop.size(); ++k)
      {
        if (!sides.insert(loop[k], loop[(k + 1) % loop.size()], face))
        {
          splitSet(loop[k]);
          splitSet(loop[(k + 1) % loop.size()]);
        }
      }
      std::sort(loop.begin(), loop.end());
      for (std::size_t k = 1; k < loop.size(); ++k)
      {
        if (loop[k] == loop[k - 1])
        {
          splitSet(loop[k]);
        }
      }
    }
    return any;
  }

  const PowerDiagram& diagram;
  const CellFaces& faces;
  const Execution& execution;
  DisjointSets sets;
  std::vector<char> split; ///< by set
  IndexLists contracted;
  std::vector<Index> vertices; ///< of the loops
  std::vector<Index> number;   ///< of each vertex among them, or None
};

/// The contracted faces by their points.
struct Polygons
{
  Lists<Index> corners;
  std::vector<Edge> balls; ///< inner, outer
};

/// For each vertex of the contraction the tetrahedron whose place it takes: one whose power vertex is
/// a sample, if its set has one, since samples are exact.
std::vector<Index> placeOfVertex(
  const PowerDiagram& diagram, const CellFaces& faces, Contraction& contraction)
{
  std::vector<Index> best(contraction.vertexCount(), None);
  for (const Index cell : faces.cycles.items)
  {
    const Index vertex = contraction.numberOf(cell);
    if (vertex == None)
    {
      continue;
    }
    Index& chosen = best[vertex];
    const bool better = chosen == None ||
      (diagram.sampleOfVertex[chosen] == None && diagram.sampleOfVertex[cell] != None);
    chosen = better ? cell : chosen;
  }
  return best;
}

/// Contracts the faces, and puts their vertices into the surface.
Polygons polygons(const PowerDiagram& diagram, const CellFaces& faces, CrustSurface& surface,
  const Execution& execution)
{
  Contraction contraction(diagram, faces, execution);
  for (const Index cell : placeOfVertex(diagram, faces, contraction))
  {
    surface.points.push_back(diagram.vertices[cell]);
    surface.sampleOfPoint.push_back(diagram.sampleOfVertex[cell]);
  }
  Polygons result;
  for (Index face = 0; face < contraction.loops().size(); ++face)
  {
    execution.pollAt(face);
    const IndexLists::View corners = contraction.loops()[face];
    if (corners.size() > 0)
    {
      result.corners.append(corners);
      result.balls.push_back(faces.balls[face]);
    }
  }
  return result;
}
}

CrustSurface crustSurface(const PowerDiagram& diagram, const Execution& execution)
{
  CrustSurface surface;
  const Polygons faces = polygons(diagram, cellFaces(diagram, execution), surface, execution);
  // All sides first: no diagonal may be the side of another polygon.
  EdgeSet edges(
    faces.corners.items.size() / 2 + faces.corners.items.size() - 3 * faces.balls.size());
  for (Index face = 0; face < faces.corners.size(); ++face)
  {
    const auto corners = faces.corners[face];
    for (Index k = 0; k < corners.size(); ++k)
    {
      edges.insert(corners[k], corners[(k + 1) % corners.size()]);
    }
  }
  std::vector<Index> polygon;
  for (Index face = 0; face < faces.corners.size(); ++face)
  {
    execution.pollAt(face);
    polygon.assign(faces.corners[face].begin(), faces.corners[face].end());
    for (const Triangle& t : triangulate(polygon, surface.points, edges))
    {
      surface.triangles.push_back(t);
      surface.innerBall.push_back(faces.balls[face][0]);
      surface.outerBall.push_back(faces.balls[face][1]);
    }
  }
  // Points that triangulation has added are no samples.
  surface.sampleOfPoint.resize(surface.points.size(), None);
  return surface;
}
}
