// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Tetrahedra.h"

#include "Base/Errors.h"
#include "Base/Lists.h"

#include <algorithm>
#include <array>
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
  Index middle, highest, where;
  bool isTurned; ///< are its corners in descending order around it, seen from the cell?
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

/// A corner of a cell and its place there, 0 ... 3, in one number.
struct Corner
{
  std::int64_t both;
  Index id() const { return static_cast<Index>(both >> 2); }
  Index place() const { return static_cast<Index>(both & 3); }
};

/// The corners of a cell in the order of their ids.
struct Ordered
{
  std::array<Corner, 4> corners;
  bool isTurned; ///< would the cell be oriented negatively in this order?
};

/// By a network, since a sort would be most of the time.
Ordered ordered(const Tetrahedron& cell)
{
  Ordered result{ {}, false };
  for (int i = 0; i < 4; ++i)
  {
    result.corners[i].both = static_cast<std::int64_t>(cell[i]) << 2 | i;
  }
  const auto order = [&result](int first, int second) {
    Corner &a = result.corners[first], &b = result.corners[second];
    result.isTurned ^= a.both > b.both;
    const auto [low, high] = std::minmax({ a.both, b.both });
    a.both = low, b.both = high;
  };
  order(0, 1);
  order(2, 3);
  order(0, 2);
  order(1, 3);
  order(1, 2);
  return result;
}

/// The triangles of all cells, in lists by their lowest corner.
Lists<TriangleOfCell> trianglesByLowest(const std::vector<Tetrahedron>& cells)
{
  return listsByKey<TriangleOfCell>(highestCorner(cells) + 1, [&cells](const auto& add) {
    for (Index c = 0; c < count(cells); ++c)
    {
      const auto [corners, isTurned] = ordered(cells[c]);
      const auto [a, b, d, e] = corners;
      const auto opposite = [c](const Corner& corner) { return 4 * c + corner.place(); };
      add(a.id(), TriangleOfCell{ b.id(), d.id(), opposite(e), isTurned });
      add(a.id(), TriangleOfCell{ b.id(), e.id(), opposite(d), !isTurned });
      add(a.id(), TriangleOfCell{ d.id(), e.id(), opposite(b), isTurned });
      add(b.id(), TriangleOfCell{ d.id(), e.id(), opposite(a), !isTurned });
    }
  });
}

/// A triangle without its lowest corner: the upper two, and whether it is turned. Turned and not, the same triangle
/// comes twice in a row in a sorted list.
std::uint64_t packed(const Corner& middle, const Corner& highest, bool isTurned)
{
  return static_cast<std::uint64_t>(middle.id()) << 32 |
    static_cast<std::uint64_t>(highest.id()) << 1 | static_cast<std::uint64_t>(isTurned);
}

Triangle unpacked(Index lowest, std::uint64_t triangle)
{
  const Index middle = static_cast<Index>(triangle >> 32),
              highest = static_cast<Index>((triangle & 0xffffffff) >> 1);
  return (triangle & 1) ? Triangle{ lowest, highest, middle } : Triangle{ lowest, middle, highest };
}

/// The triangles of all cells, in lists by their lowest corner.
Lists<std::uint64_t> packedByLowest(const std::vector<Tetrahedron>& cells)
{
  return listsByKey<std::uint64_t>(highestCorner(cells) + 1, [&cells](const auto& add) {
    for (const Tetrahedron& cell : cells)
    {
      const auto [corners, isTurned] = ordered(cell);
      const auto [a, b, d, e] = corners;
      add(a.id(), packed(b, d, isTurned));
      add(a.id(), packed(b, e, !isTurned));
      add(a.id(), packed(d, e, isTurned));
      add(b.id(), packed(d, e, !isTurned));
    }
  });
}

/// Finds equal triangles without sorting: those of one lowest corner become chains by their middle corner, and along a
/// chain each leaves a mark at its highest corner, where an equal one finds it.
class Matching
{
public:
  Matching(const std::vector<Tetrahedron>& cells, bool checkSides)
    : areSidesChecked(checkSides)
    , byLowest(trianglesByLowest(cells))
    , chains(this->byLowest.size(), { None, None })
    , marks(this->byLowest.size(), { None, None })
    , next(this->byLowest.items.size(), None)
    , found(cells.size(), { None, None, None, None })
  {
  }

  std::vector<Tetrahedron> neighbors()
  {
    std::vector<Index> middles;
    for (Index lowest = 0; lowest < this->byLowest.size(); ++lowest)
    {
      middles.clear();
      for (Index t = this->byLowest.offsets[lowest]; t < this->byLowest.offsets[lowest + 1]; ++t)
      {
        Entry& chain = this->chains[this->byLowest.items[t].middle];
        if (chain.owner != lowest)
        {
          chain = { lowest, None };
          middles.push_back(this->byLowest.items[t].middle);
        }
        this->next[t] = std::exchange(chain.triangle, t);
      }
      for (const Index middle : middles)
      {
        this->matchChain(this->chains[middle].triangle);
      }
    }
    return std::move(this->found);
  }

private:
  /// Valid while its owner is what is looked at.
  struct Entry
  {
    Index owner, triangle;
  };

  /// @param first  triangle, which stands for its chain
  void matchChain(Index first)
  {
    for (Index t = first; t != None; t = this->next[t])
    {
      Entry& mark = this->marks[this->byLowest.items[t].highest];
      if (mark.owner != first)
      {
        mark = { first, t };
        continue;
      }
      this->match(this->byLowest.items[mark.triangle], this->byLowest.items[t]);
    }
  }

  void match(const TriangleOfCell& one, const TriangleOfCell& other)
  {
    const Index a = one.where, b = other.where;
    if (this->found[a / 4][a % 4] != None)
    {
      throw InvalidInput("the tetrahedra of the balls are no triangulation: a triangle has more "
                         "than two of them; give the output of Polar Balls, with all its cells");
    }
    if (this->areSidesChecked && one.isTurned == other.isTurned)
    {
      throw InvalidInput("the tetrahedra ", std::min(a, b) / 4, " and ", std::max(a, b) / 4,
        " lie on the same side of a triangle: give the output of Polar Balls, with all its cells");
    }
    this->found[a / 4][a % 4] = b / 4;
    this->found[b / 4][b % 4] = a / 4;
  }

  bool areSidesChecked;
  Lists<TriangleOfCell> byLowest;
  std::vector<Entry> chains; ///< for each middle corner
  std::vector<Entry> marks;  ///< for each highest corner
  std::vector<Index> next;   ///< for each triangle in its chain
  std::vector<Tetrahedron> found;
};
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
  std::vector<Tetrahedron> neighbors = Matching(cells, false).neighbors();
  return { std::move(cells), std::move(neighbors) };
}

Tetrahedra orientedWithNeighbors(std::vector<Tetrahedron> cells)
{
  std::vector<Tetrahedron> neighbors = Matching(cells, true).neighbors();
  return { std::move(cells), std::move(neighbors) };
}

std::optional<std::vector<Triangle>> hullOf(const std::vector<Tetrahedron>& cells)
{
  Lists<std::uint64_t> triangles = packedByLowest(cells);
  triangles.sortEach();
  std::vector<Triangle> result;
  for (Index lowest = 0; lowest < triangles.size(); ++lowest)
  {
    const auto list = triangles[lowest];
    for (Index i = 0; i < list.size(); ++i)
    {
      const auto isSame = [&](Index k) { return k < list.size() && list[i] >> 1 == list[k] >> 1; };
      if (!isSame(i + 1))
      {
        result.push_back(unpacked(lowest, list[i]));
      }
      else if (list[i] == list[i + 1] || isSame(i + 2))
      {
        return std::nullopt;
      }
      else
      {
        ++i;
      }
    }
  }
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
