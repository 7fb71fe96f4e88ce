// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_FlatTetrahedron_h
#define medial_FlatTetrahedron_h

#include "Base/Types.h"

#include <array>

namespace medial
{
/// Some triangles of a tetrahedron: bit i stands for the one opposite to corner i.
using FacetSet = unsigned char;

constexpr FacetSet allFacets = 15;
inline bool holds(FacetSet facets, int i)
{
  return (facets >> i & 1) != 0;
}
inline FacetSet others(FacetSet facets)
{
  return static_cast<FacetSet>(allFacets & ~facets);
}

/// A tetrahedron seen from where its shadow is largest: across the direction in which it is thin. It
/// shows two of its triangles on each side, or one on one side and three on the other.
struct FlatTetrahedron
{
  FacetSet side;   ///< the triangles of one side; the others are on the other side
  double flatness; ///< thickness over width: volume / (area of the shadow)^1.5, up to a factor;
                   ///< 0 where the corners lie in a plane
};
FlatTetrahedron flatTetrahedron(const std::array<Point, 4>& corners);
}

#endif
