// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_ShapeFacets_h
#define medial_ShapeFacets_h

#include "Axis/FlatTetrahedron.h"
#include "Axis/ShapeComplex.h"
#include "Base/Types.h"

#include <vector>

namespace medial
{
/// Is it one triangle?
inline bool isSingle(FacetSet facets)
{
  return (facets & (facets - 1)) == 0;
}

/// The triangles of a shape's tetrahedra, by their place in the tetrahedron.
class ShapeFacets
{
public:
  /// @param shapeComplex  must outlive this
  /// @param centers       of its points
  ShapeFacets(const ShapeComplex& shapeComplex, const std::vector<Point>& centers);

  std::vector<FlatTetrahedron> views; ///< for each tetrahedron

  /// The triangles of a tetrahedron that are in no other one. None if it is gone.
  FacetSet free(Index tetrahedron) const;

  // For a set that is not empty.
  Index first(Index tetrahedron, FacetSet facets) const; ///< number of its first triangle
  Index last(Index tetrahedron, FacetSet facets) const;

  /// The edge that two triangles of a tetrahedron share.
  Index commonEdge(Index tetrahedron, FacetSet pair) const;

  /// Twice the area of some triangles of a tetrahedron, in the square of the centres' unit.
  double area(Index tetrahedron, FacetSet facets) const;

  /// Are some triangles larger than the others?
  bool isLarger(Index tetrahedron, FacetSet facets) const
  {
    return this->area(tetrahedron, facets) > this->area(tetrahedron, others(facets));
  }

  /// Of the two sides of a tetrahedron the one that holds a triangle.
  FacetSet sideWith(Index tetrahedron, FacetSet facet) const;

  bool isSide(Index tetrahedron, FacetSet facets) const;

private:
  const ShapeComplex& shape;
  std::vector<double> areas; ///< of the shape's triangles, doubled
};
}

#endif
