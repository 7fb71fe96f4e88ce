// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_EdgeTable_h
#define medial_EdgeTable_h

#include "Base/Types.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace medial
{
/// A number for each of many directed edges, in one array: a std::unordered_map would allocate memory
/// for each edge. An edge is looked up in constant time on average.
///
/// Edges from one corner are in a block, and corners with near numbers have near blocks. So most
/// edges that are looked up one after another, as along a surface, are in the processor's cache. What doesn't
/// fit into a block goes anywhere: a corner may have any number of edges.
class EdgeTable
{
public:
  /// @param expected  how many edges will come; more may
  explicit EdgeTable(std::size_t expected = 0) { this->resize(expected); }

  /// Gives an edge a number, unless it has one.
  /// @return  was the edge new?
  bool insert(Index from, Index to, Index number)
  {
    const std::size_t before = this->used;
    this->numberOf(from, to, number);
    return this->used > before;
  }

  /// The number of an edge, to be changed; of a new one `number`, which isn't None. It can be changed until
  /// the next edge comes.
  Index& numberOf(Index from, Index to, Index number)
  {
    if (2 * (this->used + 1) > this->entries.size())
    {
      this->resize(2 * this->used + 1);
    }
    Entry& entry = this->entries[this->placeOf(from, to)];
    if (entry.number == None)
    {
      entry = { from, to, number };
      ++this->used;
    }
    return entry.number;
  }

  /// The number of an edge; None if the edge is not in the table.
  Index find(Index from, Index to) const { return this->entries[this->placeOf(from, to)].number; }

private:
  struct Entry
  {
    Index from = None, to = None, number = None; ///< number None: the place is empty
  };
  static constexpr std::size_t blockSize = 8; ///< a surface has six edges at a corner on average

  bool endsAt(std::size_t place, Index from, Index to) const
  {
    const Entry& entry = this->entries[place];
    return entry.number == None || (entry.from == from && entry.to == to);
  }

  /// Where an edge is, or the empty place where it belongs.
  std::size_t placeOf(Index from, Index to) const
  {
    constexpr std::uint64_t golden =
      0x9E3779B97F4A7C15; // 2^64 / the golden ratio, spreads the keys
    const std::uint64_t spread =
      (static_cast<std::uint64_t>(from) << 32 | static_cast<std::uint32_t>(to)) * golden;
    const std::size_t last = this->entries.size() - 1; // a power of two less one
    const std::size_t block = (static_cast<std::uint32_t>(from) * blockSize) & last;
    for (std::size_t i = 0; i < blockSize; ++i)
    {
      const std::size_t place = block + ((spread >> 32) + i) % blockSize;
      if (this->endsAt(place, from, to))
      {
        return place;
      }
    }
    std::size_t place = spread >> this->shift;
    while (!this->endsAt(place, from, to))
    {
      place = (place + 1) & last;
    }
    return place;
  }

  /// At most half of the places are taken.
  void resize(std::size_t expected)
  {
    int bits = 4;
    while ((std::size_t(1) << bits) < 2 * expected)
    {
      ++bits;
    }
    const std::vector<Entry> old = std::move(this->entries);
    this->shift = 64 - bits;
    this->entries.assign(std::size_t(1) << bits, {});
    for (const Entry& entry : old)
    {
      if (entry.number != None)
      {
        this->entries[this->placeOf(entry.from, entry.to)] = entry;
      }
    }
  }

  std::vector<Entry> entries;
  std::size_t used = 0;
  int shift = 0;
};

/// Edges by their two corners, in either direction.
class EdgeSet
{
public:
  explicit EdgeSet(std::size_t expected = 0)
    : edges(expected)
  {
  }
  void insert(Index a, Index b) { this->edges.insert(std::min(a, b), std::max(a, b), 0); }
  bool contains(Index a, Index b) const
  {
    return this->edges.find(std::min(a, b), std::max(a, b)) != None;
  }

private:
  EdgeTable edges;
};

/// A number for each of many triangles, by their three corners in any order.
class TriangleTable
{
public:
  /// @param expected  how many triangles will come; more may
  explicit TriangleTable(std::size_t expected = 0)
    : lowEdges(expected)
    , triangles(expected)
  {
  }

  /// Gives a triangle a number, unless it has one.
  /// @return  was the triangle new?
  bool insert(const Triangle& corners, Index number)
  {
    const auto [edge, highest] = this->parts(corners);
    return this->triangles.insert(edge, highest, number);
  }

  /// The number of a triangle, to be changed, as EdgeTable::numberOf.
  Index& numberOf(const Triangle& corners, Index number)
  {
    const auto [edge, highest] = this->parts(corners);
    return this->triangles.numberOf(edge, highest, number);
  }

private:
  /// A number for the edge of the two lower corners, and the highest corner.
  Edge parts(Triangle corners)
  {
    std::sort(corners.begin(), corners.end());
    const Index edge = this->lowEdges.numberOf(corners[0], corners[1], this->edgeCount);
    this->edgeCount += edge == this->edgeCount;
    return { edge, corners[2] };
  }

  EdgeTable lowEdges;
  EdgeTable triangles; ///< by their parts
  Index edgeCount = 0;
};
}

#endif
