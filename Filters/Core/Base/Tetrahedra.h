// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Tetrahedra_h
#define medial_Tetrahedra_h

#include "Base/Types.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace medial
{
/// A triangulation of the convex hull of points, as arrays.
struct Tetrahedra
{
  std::vector<Tetrahedron> cells;     ///< corners, positively oriented
  std::vector<Tetrahedron> neighbors; ///< the cell opposite to each corner; None across the hull
};

/// The three corners of a positively oriented cell opposite to corner i (0 ... 3), counter-clockwise
/// seen from corner i.
inline Triangle facet(const Tetrahedron& cell, int i)
{
  static constexpr int corners[4][3] = { { 1, 3, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 2 } };
  return { cell[corners[i][0]], cell[corners[i][1]], cell[corners[i][2]] };
}

/// Sorts the corners of each cell, then the cells: the same cells become the same list.
void sortCells(std::vector<Tetrahedron>& cells);

/// The cells with numbers[corner] for each corner.
std::vector<Tetrahedron> renumbered(
  std::vector<Tetrahedron> cells, const std::vector<Index>& numbers);

/// The six edges of a cell as pairs of corner numbers.
constexpr int cellEdges[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 }, { 2, 3 } };

/// Is the edge cellEdges[k] in the facet opposite to corner i?
constexpr bool isInFacet(int k, int i)
{
  return cellEdges[k][0] != i && cellEdges[k][1] != i;
}

/// The cells with their neighbours found from shared triangles, in linear time.
/// @throw InvalidInput  a triangle has more than two cells
Tetrahedra withNeighbors(std::vector<Tetrahedron> cells);

/// The same of cells that say that they are positively oriented.
/// @throw InvalidInput  also where two cells lie on the same side of a triangle
Tetrahedra orientedWithNeighbors(std::vector<Tetrahedron> cells);

/// The triangles of the hull, counter-clockwise seen from their cells, by their lowest corners. Nothing where
/// orientedWithNeighbors() would throw. Takes half as long, since no neighbours are kept.
std::optional<std::vector<Triangle>> hullOf(const std::vector<Tetrahedron>& cells);

/// A number for each edge: entry [cell][k] is the number of the cell's edge cellEdges[k].
struct EdgeNumbers
{
  std::vector<std::array<Index, 6>> ofCell;
  std::vector<Edge> edges; ///< corners, ascending
};
EdgeNumbers edgeNumbers(const std::vector<Tetrahedron>& cells, Index pointCount);

/// Walks around an edge: calls body(cell, leave) for each cell, which the walk leaves across the facet opposite to
/// its corner number `leave`.
/// @param start  a cell at the edge, the first one
/// @param leave  0 ... 3, one of the two corners that are not on the edge; which one decides
///               the direction of the walk
/// @return  did it come around? Else it came to the hull
template <typename Body>
bool forCellsAround(
  const Tetrahedra& mesh, const Edge& edge, Index start, int leave, const Body& body)
{
  const auto placeOf = [&mesh](Index cell, Index corner) {
    const Tetrahedron& corners = mesh.cells[cell];
    return static_cast<int>(std::find(corners.begin(), corners.end(), corner) - corners.begin());
  };
  Index cell = start;
  do
  {
    body(cell, leave);
    // The last corner is shared with the next cell, where it is opposite to the facet to cross.
    const int last = 6 - placeOf(cell, edge[0]) - placeOf(cell, edge[1]) - leave;
    const Index pivot = mesh.cells[cell][last];
    cell = mesh.neighbors[cell][leave];
    if (cell == None)
    {
      return false;
    }
    leave = placeOf(cell, pivot);
  }
  while (cell != start);
  return true;
}
}

#endif
