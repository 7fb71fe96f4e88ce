// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/ShapeFacets.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace medial
{
ShapeFacets::ShapeFacets(const ShapeComplex& shapeComplex, const std::vector<Point>& centers)
  : shape(shapeComplex)
{
  for (const Triangle& t : this->shape.triangles)
  {
    const Point& a = centers[t[0]];
    this->areas.push_back((centers[t[1]] - a).cross(centers[t[2]] - a).norm());
  }
  for (const Tetrahedron& t : this->shape.tetrahedra)
  {
    this->views.push_back(
      flatTetrahedron({ centers[t[0]], centers[t[1]], centers[t[2]], centers[t[3]] }));
  }
}

FacetSet ShapeFacets::free(Index tetrahedron) const
{
  int result = 0;
  for (int i = 0; i < 4; ++i)
  {
    const Index t = this->shape.facets[tetrahedron][i];
    if (this->shape.hasTriangle(t) && this->shape.onlyTetrahedron(t) == tetrahedron)
    {
      result |= 1 << i;
    }
  }
  return static_cast<FacetSet>(result);
}

Index ShapeFacets::first(Index tetrahedron, FacetSet facets) const
{
  int i = 0;
  while (!holds(facets, i))
  {
    ++i;
  }
  return this->shape.facets[tetrahedron][i];
}

Index ShapeFacets::last(Index tetrahedron, FacetSet facets) const
{
  int i = 3;
  while (!holds(facets, i))
  {
    --i;
  }
  return this->shape.facets[tetrahedron][i];
}

Index ShapeFacets::commonEdge(Index tetrahedron, FacetSet pair) const
{
  const Triangle& a = this->shape.sides[this->first(tetrahedron, pair)];
  const Triangle& b = this->shape.sides[this->last(tetrahedron, pair)];
  return *std::find_first_of(a.begin(), a.end(), b.begin(), b.end());
}

double ShapeFacets::area(Index tetrahedron, FacetSet facets) const
{
  double sum = 0;
  for (int i = 0; i < 4; ++i)
  {
    sum += holds(facets, i) ? this->areas[this->shape.facets[tetrahedron][i]] : 0;
  }
  return sum;
}

FacetSet ShapeFacets::sideWith(Index tetrahedron, FacetSet facet) const
{
  const FacetSet side = this->views[tetrahedron].side;
  return (side & facet) != 0 ? side : others(side);
}

bool ShapeFacets::isSide(Index tetrahedron, FacetSet facets) const
{
  const FacetSet side = this->views[tetrahedron].side;
  return facets == side || facets == others(side);
}
}
