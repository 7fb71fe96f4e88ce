// SPDX-License-Identifier: BSD-3-Clause
#ifndef ShapeComplexes_h
#define ShapeComplexes_h

#include "Axis/ShapeComplex.h"
#include "Base/Triangulations.h"
#include "Shapes.h"
#include "Validators.h"

#include <vector>

/// Small shapes: triangulations of random points, some of which are marked.
namespace shapecomplexes
{
using medial::Index;
using medial::Point;
using medial::ShapeComplex;

struct MarkedMesh
{
  std::vector<Point> points;
  medial::Tetrahedra mesh;
  std::vector<char> marked;

  ShapeComplex complex() const { return { this->mesh, this->marked }; }
};

/// @param every  one point in so many is not marked
inline MarkedMesh markedMesh(std::vector<Point> points, unsigned seed, Index every)
{
  medial::Tetrahedra mesh = medial::delaunay(points);
  medial::sortCells(mesh.cells);
  mesh = medial::withNeighbors(std::move(mesh.cells));
  std::vector<char> marked;
  for (const Index place : shapes::shuffledOrder(points.size(), seed))
  {
    marked.push_back(place % every == 0 ? 0 : 1);
  }
  return { std::move(points), std::move(mesh), std::move(marked) };
}

inline MarkedMesh randomMesh(unsigned seed)
{
  const Index every = 2 + static_cast<Index>(seed % 4);
  return markedMesh(shapes::cloud(8 + 4 * static_cast<int>(seed % 9), seed), seed, every);
}

/// What is left, points without anything else included.
inline validators::Complex remaining(const ShapeComplex& shape, const std::vector<char>& marked)
{
  validators::Complex result;
  for (Index p = 0; p < medial::count(marked); ++p)
  {
    if (marked[p])
    {
      result.vertices.push_back(p);
    }
  }
  for (Index e = 0; e < medial::count(shape.edges); ++e)
  {
    if (shape.hasEdge(e))
    {
      result.edges.push_back(shape.edges[e]);
    }
  }
  for (Index t = 0; t < medial::count(shape.triangles); ++t)
  {
    if (shape.hasTriangle(t))
    {
      result.triangles.push_back(shape.triangles[t]);
    }
  }
  for (Index c = 0; c < medial::count(shape.tetrahedra); ++c)
  {
    if (shape.hasTetrahedron(c))
    {
      result.tetrahedra.push_back(shape.tetrahedra[c]);
    }
  }
  return result;
}

inline medial::Betti bettiOf(const ShapeComplex& shape, const std::vector<char>& marked)
{
  return validators::bettiNumbers(remaining(shape, marked));
}
}

#endif
