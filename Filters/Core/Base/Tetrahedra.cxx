// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Tetrahedra.h"

#include "Base/Errors.h"
#include "Base/Lists.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{
// Equal triangles of two cells, and equal edges of many, are found by sorting. A sort of all of them would
// cost n log n. Grouped by their lowest corner first, in linear time, only short lists are to be sorted.

/// A simplex's corners but the lowest, ascending, and where it comes from (4 * cell + i and such).
struct Place
{
  Index second, third, where;
  bool operator<(const Place& other) const
  {
    return std::tie(this->second, this->third, this->where) <
      std::tie(other.second, other.third, other.where);
  }
};

/// All simplices, in lists by their lowest corner. Each list is sorted, so that equal simplices follow
/// each other.
/// @param simplex  simplex(cell, k): lowest corner and Place of simplex k of `perCell` of a cell
template <typename Simplex>
Lists<Place> byLowestCorner(Index cellCount, int perCell, Index pointCount, const Simplex& simplex)
{
  Lists<Place> places = listsByKey<Place>(pointCount, [&](const auto& add) {
    for (Index c = 0; c < cellCount; ++c)
    {
      for (int k = 0; k < perCell; ++k)
      {
        const std::pair<Index, Place> entry = simplex(c, k);
        add(entry.first, entry.second);
      }
    }
  });
  places.sortEach();
  return places;
}

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
  std::sort(cells.begin(), cells.end());
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
  const auto triangle = [&cells](Index c, int i) {
    Triangle t = facet(cells[c], i);
    std::sort(t.begin(), t.end());
    return std::make_pair(t[0], Place{ t[1], t[2], 4 * c + i });
  };
  const Lists<Place> lists = byLowestCorner(count(cells), 4, highestCorner(cells) + 1, triangle);
  Tetrahedra result;
  result.neighbors.assign(cells.size(), { None, None, None, None });
  for (Index p = 0; p < lists.size(); ++p)
  {
    for (Index i = 0; i + 1 < lists[p].size(); ++i)
    {
      const Place &a = lists[p][i], &b = lists[p][i + 1];
      if (a.second != b.second || a.third != b.third)
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
  const auto edge = [&cells](Index c, int k) {
    const Index a = cells[c][cellEdges[k][0]], b = cells[c][cellEdges[k][1]];
    return std::make_pair(std::min(a, b), Place{ std::max(a, b), 0, 6 * c + k });
  };
  const Lists<Place> lists = byLowestCorner(count(cells), 6, pointCount, edge);
  EdgeNumbers result;
  result.ofCell.resize(cells.size());
  for (Index p = 0; p < pointCount; ++p)
  {
    Index last = None;
    for (const Place& place : lists[p])
    {
      if (place.second != last)
      {
        result.edges.push_back({ p, place.second });
        last = place.second;
      }
      result.ofCell[place.where / 6][place.where % 6] = count(result.edges) - 1;
    }
  }
  return result;
}

std::vector<Index> cellsAround(const Tetrahedra& mesh, const Edge& edge, Index start, int leave)
{
  std::vector<Index> ring;
  Index cell = start;
  do
  {
    ring.push_back(cell);
    const Tetrahedron& corners = mesh.cells[cell];
    Index pivot = None; // shared with the next cell, where it is opposite to the facet to cross
    for (int i = 0; i < 4; ++i)
    {
      if (i != leave && corners[i] != edge[0] && corners[i] != edge[1])
      {
        pivot = corners[i];
      }
    }
    cell = mesh.neighbors[cell][leave];
    if (cell == None)
    {
      return {};
    }
    const Tetrahedron& next = mesh.cells[cell];
    leave = static_cast<int>(std::find(next.begin(), next.end(), pivot) - next.begin());
  }
  while (cell != start);
  return ring;
}
}
