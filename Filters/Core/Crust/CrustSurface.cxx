// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/CrustSurface.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Base/Frame.h"
#include "Base/Lists.h"
#include "Base/Polygons.h"
#include "Base/Predicates.h"

#include <algorithm>
#include <unordered_map>

namespace medial
{
namespace
{
bool isMixed(const PowerDiagram& diagram, const Tetrahedron& cell)
{
  const int inner = diagram.inner[cell[0]] + diagram.inner[cell[1]] + diagram.inner[cell[2]] +
    diagram.inner[cell[3]];
  return inner > 0 && inner < 4;
}

/// The faces of the crust as cycles of cells of the dual, each a power vertex.
struct CellFaces
{
  std::vector<std::vector<Index>> cycles; ///< counter-clockwise seen from outside
  std::vector<Edge> balls;                ///< inner, outer
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

CellFaces cellFaces(const PowerDiagram& diagram)
{
  CellFaces result;
  const Tetrahedra& mesh = diagram.dual;
  const EdgeNumbers edges = edgeNumbers(mesh.cells, count(diagram.balls));
  std::vector<char> done(edges.edges.size(), 0);
  for (Index c = 0; c < count(mesh.cells); ++c)
  {
    for (const Index e : edges.ofCell[c])
    {
      auto [a, b] = edges.edges[e];
      if (done[e] || diagram.inner[a] == diagram.inner[b])
      {
        continue;
      }
      done[e] = 1;
      if (!diagram.inner[a])
      {
        std::swap(a, b);
      }
      result.cycles.push_back(cycleAround(mesh, a, b, c));
      result.balls.push_back({ a, b });
    }
  }
  return result;
}

/// Sets of neighbouring power vertices that are to become one vertex.
class Contraction
{
public:
  Contraction(const PowerDiagram& power, const CellFaces& cellFaces)
    : diagram(power)
    , faces(cellFaces)
    , sets(count(power.dual.cells))
  {
    this->unite();
    this->splitUnlessDiscs();
    while (this->splitWherePinched())
    {
    }
  }

  /// The vertex of a cell: its set's lowest cell, or itself where the set was split.
  Index vertexOf(Index cell)
  {
    const Index set = this->sets.find(cell);
    return this->split[set] ? cell : set;
  }

  /// A face's vertices without those that fall together; fewer than 3 where the face vanishes.
  std::vector<Index> corners(Index face)
  {
    std::vector<Index> result;
    for (const Index cell : this->faces.cycles[face])
    {
      const Index vertex = this->vertexOf(cell);
      if (result.empty() || result.back() != vertex)
      {
        result.push_back(vertex);
      }
    }
    while (result.size() > 1 && result.back() == result.front())
    {
      result.pop_back();
    }
    return result;
  }

private:
  bool fallTogether(Index a, Index b) const
  {
    const Index s = this->diagram.sampleOfVertex[a], t = this->diagram.sampleOfVertex[b];
    return s != None && t != None
      ? s == t
      : (this->diagram.vertices[a] - this->diagram.vertices[b]).norm() < coincident;
  }

  void unite()
  {
    for (const std::vector<Index>& cycle : this->faces.cycles)
    {
      for (std::size_t k = 0; k < cycle.size(); ++k)
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

  /// Splits sets whose vertices, edges and faces don't make a disc (V - E + F = 1).
  void splitUnlessDiscs()
  {
    std::vector<Index> euler(this->split.size(), 0); // doubled: each edge is met twice
    std::vector<char> counted(this->split.size(), 0);
    for (const std::vector<Index>& cycle : this->faces.cycles)
    {
      bool inside = true;
      for (std::size_t k = 0; k < cycle.size(); ++k)
      {
        const Index set = this->sets.find(cycle[k]);
        euler[set] += counted[cycle[k]] ? 0 : 2;
        counted[cycle[k]] = 1;
        const bool sameSet = set == this->sets.find(cycle[(k + 1) % cycle.size()]);
        euler[set] -= sameSet;
        inside = inside && sameSet;
      }
      euler[cycle.empty() ? 0 : this->sets.find(cycle[0])] += inside && !cycle.empty() ? 2 : 0;
    }
    for (std::size_t set = 0; set < this->split.size(); ++set)
    {
      this->split[set] = counted[set] && euler[set] != 2;
    }
  }

  /// Splits sets at which a face has a corner twice, or two vertices have more than one edge.
  /// @return  was any split?
  bool splitWherePinched()
  {
    bool any = false;
    const auto splitSet = [&](Index vertex) {
      const Index set = this->sets.find(vertex);
      any = any || !this->split[set];
      this->split[set] = 1;
    };
    std::unordered_map<std::uint64_t, int> uses;
    for (Index face = 0; face < count(this->faces.cycles); ++face)
    {
      std::vector<Index> loop = this->corners(face);
      for (std::size_t k = 0; k < loop.size() && loop.size() > 2; ++k)
      {
        const auto key = static_cast<std::uint64_t>(loop[k]) << 32 |
          static_cast<std::uint64_t>(loop[(k + 1) % loop.size()]);
        if (++uses[key] > 1)
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
  DisjointSets sets;
  std::vector<char> split; ///< by set
};

/// Faces with their vertices numbered, and the points of the crust.
struct Polygons
{
  std::vector<std::vector<Index>> corners;
  std::vector<Edge> balls;
};

Polygons polygons(const PowerDiagram& diagram, const CellFaces& faces, Crust& crust)
{
  Contraction contraction(diagram, faces);
  // A set takes the sample if one of its cells has one.
  std::vector<Index> best(diagram.dual.cells.size(), None);
  for (const std::vector<Index>& cycle : faces.cycles)
  {
    for (const Index cell : cycle)
    {
      Index& chosen = best[contraction.vertexOf(cell)];
      const bool better = chosen == None ||
        (diagram.sampleOfVertex[chosen] == None && diagram.sampleOfVertex[cell] != None);
      chosen = better ? cell : chosen;
    }
  }
  Polygons result;
  std::vector<Index> number(diagram.dual.cells.size(), None);
  for (Index face = 0; face < count(faces.cycles); ++face)
  {
    std::vector<Index> corners = contraction.corners(face);
    if (corners.size() < 3)
    {
      continue;
    }
    for (Index& vertex : corners)
    {
      if (number[vertex] == None)
      {
        number[vertex] = count(crust.points);
        crust.points.push_back(diagram.vertices[best[vertex]]);
        crust.sampleOfPoint.push_back(diagram.sampleOfVertex[best[vertex]]);
      }
      vertex = number[vertex];
    }
    result.corners.push_back(std::move(corners));
    result.balls.push_back(faces.balls[face]);
  }
  return result;
}
}

void findVertices(Tetrahedra dual, PowerDiagram& diagram, const Execution& execution)
{
  diagram.dual = std::move(dual);
  const Index cellCount = count(diagram.dual.cells);
  diagram.sampleOfVertex.assign(cellCount, None);
  diagram.vertices.assign(cellCount, Point::Zero());
  execution.forEach(cellCount, [&](Index c) {
    const Tetrahedron& cell = diagram.dual.cells[c];
    if (!isMixed(diagram, cell))
    {
      return;
    }
    const Index sample = lowestCommonItem(diagram.samples, cell);
    diagram.sampleOfVertex[c] = sample;
    diagram.vertices[c] = sample != None
      ? diagram.positions[sample]
      : powerCenter({ diagram.balls[cell[0]], diagram.balls[cell[1]], diagram.balls[cell[2]],
                      diagram.balls[cell[3]] },
          constructionError);
  });
  const auto isFinite = [](const Point& p) { return p.allFinite(); };
  if (!std::all_of(diagram.vertices.begin(), diagram.vertices.end(), isFinite))
  {
    throw InvalidInput(
      "the coordinates of the balls are too coarse, a tetrahedron of them is flat: "
      "move the samples nearer to the origin before Polar Balls");
  }
}

Crust crustSurface(const PowerDiagram& diagram)
{
  Crust crust{};
  const Polygons faces = polygons(diagram, cellFaces(diagram), crust);
  EdgeSet edges;
  for (const std::vector<Index>& corners : faces.corners)
  {
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      edges.insert(corners[k], corners[(k + 1) % corners.size()]);
    }
  }
  for (std::size_t face = 0; face < faces.corners.size(); ++face)
  {
    for (const Triangle& t : triangulate(faces.corners[face], crust.points, edges))
    {
      crust.faces.items.insert(crust.faces.items.end(), t.begin(), t.end());
      crust.faces.close();
      crust.innerBall.push_back(faces.balls[face][0]);
      crust.outerBall.push_back(faces.balls[face][1]);
    }
  }
  crust.sampleOfPoint.resize(crust.points.size(), None);
  return crust;
}
}
