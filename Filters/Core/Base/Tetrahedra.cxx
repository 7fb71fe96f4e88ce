// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Tetrahedra.h"

#include "Base/Errors.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{
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

/// All simplices grouped by their lowest corner; each group is sorted, so equal ones are neighbours.
struct Groups
{
  std::vector<Index> offsets;
  std::vector<Place> places;
};

/// @param simplex  simplex(cell, k): lowest corner and Place of simplex k of `perCell` of a cell
template <typename Simplex>
Groups grouped(Index cellCount, int perCell, Index pointCount, const Simplex& simplex)
{
  Groups groups;
  groups.offsets.assign(pointCount + 1, 0);
  for (Index c = 0; c < cellCount; ++c)
  {
    for (int k = 0; k < perCell; ++k)
    {
      ++groups.offsets[simplex(c, k).first + 1];
    }
  }
  for (Index p = 0; p < pointCount; ++p)
  {
    groups.offsets[p + 1] += groups.offsets[p];
  }
  groups.places.resize(groups.offsets.back());
  std::vector<Index> next(groups.offsets.begin(), groups.offsets.end() - 1);
  for (Index c = 0; c < cellCount; ++c)
  {
    for (int k = 0; k < perCell; ++k)
    {
      const std::pair<Index, Place> entry = simplex(c, k);
      groups.places[next[entry.first]++] = entry.second;
    }
  }
  for (Index p = 0; p < pointCount; ++p)
  {
    std::sort(
      groups.places.begin() + groups.offsets[p], groups.places.begin() + groups.offsets[p + 1]);
  }
  return groups;
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

Tetrahedra withNeighbors(std::vector<Tetrahedron> cells)
{
  const auto triangle = [&cells](Index c, int i) {
    Triangle t = facet(cells[c], i);
    std::sort(t.begin(), t.end());
    return std::make_pair(t[0], Place{ t[1], t[2], 4 * c + i });
  };
  const Groups groups = grouped(count(cells), 4, highestCorner(cells) + 1, triangle);
  Tetrahedra result;
  result.neighbors.assign(cells.size(), { None, None, None, None });
  for (std::size_t p = 0; p + 1 < groups.offsets.size(); ++p)
  {
    for (Index i = groups.offsets[p]; i + 1 < groups.offsets[p + 1]; ++i)
    {
      const Place &a = groups.places[i], &b = groups.places[i + 1];
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
  const Groups groups = grouped(count(cells), 6, pointCount, edge);
  EdgeNumbers result;
  result.ofCell.resize(cells.size());
  for (Index p = 0; p < pointCount; ++p)
  {
    for (Index i = groups.offsets[p]; i < groups.offsets[p + 1]; ++i)
    {
      const Place& place = groups.places[i];
      if (i == groups.offsets[p] || place.second != groups.places[i - 1].second)
      {
        result.edges.push_back({ p, place.second });
      }
      result.ofCell[place.where / 6][place.where % 6] = count(result.edges) - 1;
    }
  }
  return result;
}
}
