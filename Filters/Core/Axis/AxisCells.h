// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_AxisCells_h
#define medial_AxisCells_h

#include "Base/Types.h"

#include <vector>

namespace medial
{
/// The cells of a medial axis: triangles, and the edges and vertices in no higher cell.
///
/// Cells are numbered vertices first, then edges, then triangles, as in a vtkPolyData.
struct AxisCells
{
  std::vector<Index> vertices;
  std::vector<Edge> edges;
  std::vector<Triangle> triangles;

  Index size() const { return this->firstTriangle() + count(this->triangles); }
  Index firstEdge() const { return count(this->vertices); }
  Index firstTriangle() const { return count(this->vertices) + count(this->edges); }
};

/// Calls body(point) for the corners of a cell.
template <typename Body>
void forPoints(const AxisCells& cells, Index cell, const Body& body)
{
  if (cell >= cells.firstTriangle())
  {
    const Triangle& corners = cells.triangles[cell - cells.firstTriangle()];
    body(corners[0]), body(corners[1]), body(corners[2]);
  }
  else if (cell >= cells.firstEdge())
  {
    const Edge& ends = cells.edges[cell - cells.firstEdge()];
    body(ends[0]), body(ends[1]);
  }
  else
  {
    body(cells.vertices[cell]);
  }
}
}

#endif
