// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/GuidedCollapse.h"

#include "Axis/CollapseQueue.h"
#include "Axis/Fins.h"
#include "Axis/ShapeFacets.h"

#include <algorithm>

// A power shape is stacks of flat tetrahedra, with the poles of a sheet of the axis as corners. Any order of
// collapses keeps the topology, but if a tetrahedron goes through one of its triangles alone, the other
// triangle of that side is left as a fin. So a tetrahedron takes a whole side with it, and its other side
// stays as the sheet:
//
// - a side of one triangle goes as one collapse;
// - a side of two triangles goes as two collapses, if both are free and their common edge is in no third
//   triangle: tetrahedron and triangle, then triangle and edge. No point is lost;
// - a side of three triangles never goes: the point in their middle would be lost.
//
// What can be done first is done first, see CollapseMove. Only where nothing else can be done, a tetrahedron
// goes through one triangle. The other triangle of that side is then a flap, which goes as soon as it alone
// has the edge that it shared. Each solid piece has a free triangle as long as it has a tetrahedron, so none
// is left in the end.
//
// For n tetrahedra this takes O(n log n) time: a move is offered again only when a triangle becomes free
// or an edge has few triangles left, and each edge has so only a few times. Geometry decides about the order
// alone, so that rounding can't spoil anything.

namespace medial
{
namespace
{
/// Edges with more triangles are not looked at: they are far from being free.
constexpr Index fewTriangles = 4;

/// Queues a move with two triangles of a tetrahedron that are free.
void offerPair(const ShapeComplex& shape, const ShapeFacets& facets, Index c, FacetSet pair,
  CollapseQueue& queue)
{
  const double flatness = facets.views[c].flatness;
  const Index triangles = shape.triangleCount(facets.commonEdge(c, pair));
  const bool isSide = facets.isSide(c, pair);
  if (triangles == 2 && isSide)
  {
    queue.offer({ CollapseMove::Side, flatness, c, pair });
  }
  else if (triangles == 2 && facets.isLarger(c, pair))
  {
    queue.offer({ CollapseMove::Pair, flatness, c, pair });
  }
  else if (triangles <= fewTriangles && isSide)
  {
    queue.offer({ CollapseMove::BehindFins, flatness, c, pair });
  }
}

/// Queues all moves of a tetrahedron that can be made now.
void offerMoves(const ShapeComplex& shape, const ShapeFacets& facets, Index c, CollapseQueue& queue)
{
  const FacetSet free = facets.free(c);
  for (int i = 0; i < 4; ++i)
  {
    const FacetSet one = static_cast<FacetSet>(1 << i);
    if (!holds(free, i))
    {
      continue;
    }
    if (facets.isSide(c, one))
    {
      queue.offer({ CollapseMove::Side, facets.views[c].flatness, c, one });
    }
    else
    {
      queue.offer({ CollapseMove::Single, -facets.area(c, one), c, one });
    }
    for (int j = 0; j < i; ++j)
    {
      if (holds(free, j))
      {
        offerPair(shape, facets, c, static_cast<FacetSet>(one | 1 << j), queue);
      }
    }
  }
}

class Guide
{
public:
  Guide(ShapeComplex& shapeComplex, const std::vector<Point>& centersOfPoints)
    : shape(shapeComplex)
    , centers(centersOfPoints)
    , facets(shapeComplex, centersOfPoints)
    , queue(count(shapeComplex.tetrahedra))
    , flapEdge(shapeComplex.triangles.size(), None)
  {
  }

  void run(const Execution& execution)
  {
    for (Index c = 0; c < count(this->shape.tetrahedra); ++c)
    {
      execution.pollAt(c);
      offerMoves(this->shape, this->facets, c, this->queue);
    }
    for (Index turn = 0; !this->queue.empty(); ++turn)
    {
      execution.pollAt(turn);
      const CollapseCandidate next = this->queue.take();
      if (this->shape.hasTetrahedron(next.tetrahedron) && this->areFree(next))
      {
        this->make(next);
      }
    }
  }

private:
  bool areFree(const CollapseCandidate& candidate) const
  {
    return (this->facets.free(candidate.tetrahedron) & candidate.facets) == candidate.facets;
  }

  void make(const CollapseCandidate& candidate)
  {
    const Index c = candidate.tetrahedron;
    switch (candidate.move)
    {
      case CollapseMove::Side:
        this->takeSide(c, candidate.facets);
        break;
      case CollapseMove::BehindFins:
        this->removeFins(c, candidate.facets);
        this->takeSide(c, candidate.facets);
        break;
      case CollapseMove::Pair:
        this->takePair(c, candidate.facets);
        break;
      case CollapseMove::Single:
        this->takeSingle(c, candidate.facets);
    }
  }

  void takeSide(Index c, FacetSet side)
  {
    if (isSingle(side))
    {
      this->collapse(c, this->facets.first(c, side));
      return;
    }
    // If both sides can go, the larger one goes, so that the sheet is smooth.
    const FacetSet other = others(side);
    const bool bothCanGo = this->facets.free(c) == allFacets &&
      this->shape.triangleCount(this->facets.commonEdge(c, other)) == 2;
    this->takePair(c, bothCanGo && this->facets.isLarger(c, other) ? other : side);
  }

  void takePair(Index c, FacetSet pair)
  {
    const Index edge = this->facets.commonEdge(c, pair);
    if (this->shape.triangleCount(edge) == 2)
    {
      const Index second = this->facets.last(c, pair);
      this->collapse(c, this->facets.first(c, pair));
      this->collapse({ second, edge });
    }
  }

  /// Removes what stands on the common edge of two free triangles of a tetrahedron, if it is fins alone.
  void removeFins(Index c, FacetSet pair)
  {
    const Index edge = this->facets.commonEdge(c, pair);
    for (const Index t : this->shape.trianglesAt(edge))
    {
      if (this->shape.hasTriangle(t) && this->shape.onlyTetrahedron(t) != c)
      {
        const std::vector<TriangleCollapse> fin = finCollapses(this->shape, this->centers, t, edge);
        std::for_each(
          fin.begin(), fin.end(), [this](const TriangleCollapse& step) { this->collapse(step); });
        if (fin.empty())
        {
          return;
        }
      }
    }
  }

  void takeSingle(Index c, FacetSet facet)
  {
    const FacetSet side = this->facets.sideWith(c, facet);
    const FacetSet rest = static_cast<FacetSet>(side & ~facet);
    const Index edge = this->facets.commonEdge(c, isSingle(rest) ? side : rest);
    for (int i = 0; i < 4; ++i)
    {
      if (holds(rest, i))
      {
        this->flapEdge[this->shape.facets[c][i]] = edge;
      }
    }
    this->collapse(c, this->facets.first(c, facet));
    for (const Index t : this->shape.facets[c])
    {
      this->tryFlap(t);
    }
  }

  void tryFlap(Index t)
  {
    if (this->flapEdge[t] != None)
    {
      this->collapse({ t, this->flapEdge[t] });
    }
  }

  void collapse(Index c, Index triangle)
  {
    if (this->shape.collapseTetrahedron(c, triangle))
    {
      for (const Index t : this->shape.facets[c])
      {
        this->offerAt(t);
      }
      this->offerAround(triangle);
    }
  }

  void collapse(const TriangleCollapse& step)
  {
    if (this->shape.collapseTriangle(step.triangle, step.edge))
    {
      this->offerAround(step.triangle);
    }
  }

  /// After a triangle has gone: what can be done at its edges?
  void offerAround(Index triangle)
  {
    for (const Index e : this->shape.sides[triangle])
    {
      if (this->shape.hasEdge(e) && this->shape.triangleCount(e) <= fewTriangles)
      {
        const std::vector<Index> triangles = this->shape.trianglesAt(e);
        std::for_each(triangles.begin(), triangles.end(), [this](Index t) { this->offerAt(t); });
        if (triangles.size() == 1)
        {
          this->tryFlap(triangles[0]);
        }
      }
    }
  }

  /// Offers the tetrahedron to which a triangle is free.
  void offerAt(Index triangle)
  {
    const Index c =
      this->shape.hasTriangle(triangle) ? this->shape.onlyTetrahedron(triangle) : None;
    if (c != None)
    {
      offerMoves(this->shape, this->facets, c, this->queue);
    }
  }

  ShapeComplex& shape;
  const std::vector<Point>& centers;
  const ShapeFacets facets;
  CollapseQueue queue;
  std::vector<Index> flapEdge; ///< for each triangle: the edge through which it goes as a flap
};
}

void collapseToSheets(
  ShapeComplex& shape, const std::vector<Point>& centers, const Execution& execution)
{
  Guide(shape, centers).run(execution);
}
}
