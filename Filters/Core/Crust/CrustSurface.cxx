// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/CrustSurface.h"

#include "Base/DisjointSets.h"
#include "Base/EdgeTable.h"
#include "Base/Frame.h"
#include "Base/Lists.h"
#include "Base/Polygons.h"
#include "Crust/CellFaces.h"

#include <algorithm>
#include <cstdlib>

namespace medial
{
namespace
{
/// For each vertex those next to it in loops, from each side of a face.
IndexLists verticesNext(const IndexLists& loops, Index vertexCount)
{
  return listsByKey(vertexCount, [&loops](const auto& add) {
    for (Index face = 0; face < loops.size(); ++face)
    {
      const IndexLists::View loop = loops[face];
      for (Index k = 0; k < loop.size(); ++k)
      {
        add(loop[k], loop[k + 1 < loop.size() ? k + 1 : 0]);
      }
    }
  });
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
/// The steps take linear time each. `splitWherePinched` repeats, since a split set can
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

  /// The vertices next to each vertex.
  const IndexLists& neighbors() const { return this->next; }

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
    this->next = verticesNext(this->contracted, count(this->vertices));
    this->execution.poll();
    std::vector<Index> last(this->vertices.size(), None); // vertex that had this neighbour
    for (Index from = 0; from < this->next.size(); ++from)
    {
      for (const Index to : this->next[from])
      {
        if (last[to] == from)
        {
          splitSet(from);
          splitSet(to);
        }
        last[to] = from;
      }
    }
    last.assign(this->vertices.size(), None); // face that had this corner
    for (Index face = 0; face < this->contracted.size(); ++face)
    {
      for (const Index corner : this->contracted[face])
      {
        if (last[corner] == face)
        {
          splitSet(corner);
        }
        last[corner] = face;
      }
    }
    return any;
  }

  const PowerDiagram& diagram;
  const CellFaces& faces;
  const Execution& execution;
  DisjointSets sets;
  std::vector<char> split; ///< by set
  IndexLists contracted, next;
  std::vector<Index> vertices; ///< of the loops
  std::vector<Index> number;   ///< of each vertex among them, or None
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

/// Cuts the contracted faces into triangles.
class Cutting
{
public:
  Cutting(const Contraction& contraction, CrustSurface& crustSurface)
    : loops(contraction.loops())
    , neighbors(contraction.neighbors())
    , surface(crustSurface)
    , place(neighbors.size(), None)
    , edges(neighbors.items.size() / 4)
  {
  }

  void run(const CellFaces& faces, const Execution& execution)
  {
    std::vector<Index> polygon;
    for (Index face = 0; face < this->loops.size(); ++face)
    {
      execution.pollAt(face);
      polygon.assign(this->loops[face].begin(), this->loops[face].end());
      this->cut(polygon);
      this->surface.innerBall.resize(this->surface.triangles.size(), faces.balls[face][0]);
      this->surface.outerBall.resize(this->surface.triangles.size(), faces.balls[face][1]);
    }
  }

private:
  void cut(const std::vector<Index>& polygon)
  {
    if (polygon.size() <= 3)
    {
      if (!polygon.empty())
      {
        this->surface.triangles.push_back({ polygon[0], polygon[1], polygon[2] });
      }
      return;
    }
    this->addSides(polygon);
    const std::vector<Triangle> triangles = triangulate(polygon, this->surface.points, this->edges);
    this->surface.triangles.insert(
      this->surface.triangles.end(), triangles.begin(), triangles.end());
  }

  /// No diagonal may be the side of another polygon: adds those that could be one of this polygon.
  void addSides(const std::vector<Index>& polygon)
  {
    const Index n = count(polygon);
    for (Index k = 0; k < n; ++k)
    {
      this->place[polygon[k]] = k;
    }
    for (Index k = 0; k < n; ++k)
    {
      for (const Index other : this->neighbors[polygon[k]])
      {
        const Index steps = std::abs(this->place[other] - k); // around the polygon
        if (this->place[other] != None && steps != 1 && steps != n - 1)
        {
          this->edges.insert(polygon[k], other);
        }
      }
    }
    for (const Index corner : polygon)
    {
      this->place[corner] = None;
    }
  }

  const IndexLists& loops;
  const IndexLists& neighbors;
  CrustSurface& surface;
  std::vector<Index> place; ///< of each vertex in the polygon, or None
  EdgeSet edges;            ///< diagonals, and sides that may not become one
};
}

CrustSurface crustSurface(const PowerDiagram& diagram, const Execution& execution)
{
  CrustSurface surface;
  const CellFaces faces = cellFaces(diagram, execution);
  Contraction contraction(diagram, faces, execution);
  for (const Index cell : placeOfVertex(diagram, faces, contraction))
  {
    surface.points.push_back(diagram.vertices[cell]);
    surface.sampleOfPoint.push_back(diagram.sampleOfVertex[cell]);
  }
  Cutting(contraction, surface).run(faces, execution);
  // Points that triangulation has added are no samples.
  surface.sampleOfPoint.resize(surface.points.size(), None);
  return surface;
}
}
