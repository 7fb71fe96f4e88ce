// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Tetrahedra.h"

#include "Base/Errors.h"
#include "Base/Lists.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace medial
{
namespace
{
// Equal triangles of two cells, and equal edges of many, are found in lists by their lowest corner, which are
// made in linear time: a sort of all simplices would cost n log n.

/// A triangle's upper corners and where it comes from: 4 * cell + i.
struct TriangleOfCell
{
  std::uint64_t upper; ///< the middle corner, then the highest one
  Index where;
  bool operator<(const TriangleOfCell& other) const
  {
    return this->upper != other.upper ? this->upper < other.upper : this->where < other.where;
  }
};

/// An edge's upper corner and where it comes from: 6 * cell + k.
struct EdgeOfCell
{
  Index upper, where;
};

Index highestCorner(const std::vector<Tetrahedron>& cells)
{
  Index highest = None;
  for (const Tetrahedron& cell : cells)
  {
    highest = std::max(highest, *std::max_element(cell.begin(), cell.end()));
  }
  return highest;
}
}

void sortCells(std::vector<Tetrahedron>& cells)
{
  for (Tetrahedron& cell : cells)
  {
    std::sort(cell.begin(), cell.end());
  }
  Lists<Tetrahedron> byLowest =
    listsByKey<Tetrahedron>(highestCorner(cells) + 2, [&cells](const auto& add) {
      for (const Tetrahedron& cell : cells)
      {
        add(cell[0] + 1, cell); // a corner may be None, which is -1
      }
    });
  byLowest.sortEach();
  cells = std::move(byLowest.items);
}

std::vector<Tetrahedron> renumbered(
  std::vector<Tetrahedron> cells, const std::vector<Index>& numbers)
{
  for (Tetrahedron& cell : cells)
  {
    for (Index& corner : cell)
    {
      corner = numbers[corner];
    }
  }
  return cells;
}

Tetrahedra withNeighbors(std::vector<Tetrahedron> cells)
{
  const auto addTriangles = [&cells](const auto& add) {
    for (Index c = 0; c < count(cells); ++c)
    {
      for (int i = 0; i < 4; ++i)
      {
        Triangle t = facet(cells[c], i);
        std::sort(t.begin(), t.end());
        add(t[0],
          TriangleOfCell{
            static_cast<std::uint64_t>(t[1]) << 32 | static_cast<std::uint32_t>(t[2]), 4 * c + i });
      }
    }
  };
  Lists<TriangleOfCell> lists = listsByKey<TriangleOfCell>(highestCorner(cells) + 1, addTriangles);
  lists.sortEach();
  Tetrahedra result;
  result.neighbors.assign(cells.size(), { None, None, None, None });
  for (Index p = 0; p < lists.size(); ++p)
  {
    for (Index i = 0; i + 1 < lists[p].size(); ++i)
    {
      const TriangleOfCell &a = lists[p][i], &b = lists[p][i + 1];
      if (a.upper != b.upper)
      {
        continue;
      }
      if (result.neighbors[a.where / 4][a.where % 4] != None)
      {
        throw InvalidInput("the tetrahedra of the balls are no triangulation: a triangle has more "
                           "than two of them; give the output of Polar Balls, with all its cells");
      }
      result.neighbors[a.where / 4][a.where % 4] = b.where / 4;
      result.neighbors[b.where / 4][b.where % 4] = a.where / 4;
    }
  }
  result.cells = std::move(cells);
  return result;
}

EdgeNumbers edgeNumbers(const std::vector<Tetrahedron>& cells, Index pointCount)
{
  // The edges of all cells in lists by their lower corner.
  const Lists<EdgeOfCell> lists = listsByKey<EdgeOfCell>(pointCount, [&](const auto& add) {
    for (Index c = 0; c < count(cells); ++c)
    {
      for (int k = 0; k < 6; ++k)
      {
        const Index a = cells[c][cellEdges[k][0]], b = cells[c][cellEdges[k][1]];
        add(std::min(a, b), EdgeOfCell{ std::max(a, b), 6 * c + k });
      }
    }
  });
  EdgeNumbers result;
  result.ofCell.resize(cells.size());
  std::vector<Index> lower(pointCount, None),
    number(pointCount, None); // of the edge to each upper corner
  std::vector<Index> upper;
  for (Index p = 0; p < pointCount; ++p)
  {
    upper.clear();
    for (const EdgeOfCell& edge : lists[p])
    {
      if (lower[edge.upper] != p)
      {
        lower[edge.upper] = p;
        upper.push_back(edge.upper);
      }
    }
    std::sort(upper.begin(), upper.end());
    for (const Index q : upper)
    {
      number[q] = count(result.edges);
      result.edges.push_back({ p, q });
    }
    for (const EdgeOfCell& edge : lists[p])
    {
      result.ofCell[edge.where / 6][edge.where % 6] = number[edge.upper];
    }
  }
  return result;
}
}
