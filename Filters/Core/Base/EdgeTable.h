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
/// A number for each of many directed edges, in two arrays: a std::unordered_map would allocate memory
/// for each edge. An edge is looked up in constant time on average.
class EdgeTable
{
public:
  /// @param expected  how many edges will come; more may
  explicit EdgeTable(std::size_t expected = 0) { this->resize(expected); }

  /// Gives an edge a number, unless it has one.
  /// @return  was the edge new?
  bool insert(Index from, Index to, Index number)
  {
    if (2 * (this->used + 1) > this->numbers.size())
    {
      this->resize(2 * this->used + 1);
    }
    const std::size_t place = this->placeOf(key(from, to));
    if (this->numbers[place] != None)
    {
      return false;
    }
    this->keys[place] = key(from, to);
    this->numbers[place] = number;
    ++this->used;
    return true;
  }

  /// The number of an edge; None if the edge is not in the table.
  Index find(Index from, Index to) const { return this->numbers[this->placeOf(key(from, to))]; }

private:
  static std::uint64_t key(Index from, Index to)
  {
    return static_cast<std::uint64_t>(from) << 32 | static_cast<std::uint32_t>(to);
  }

  /// Where a key is, or the empty place where it belongs.
  std::size_t placeOf(std::uint64_t key) const
  {
    constexpr std::uint64_t golden =
      0x9E3779B97F4A7C15; // 2^64 / the golden ratio, spreads the keys
    std::size_t place = (key * golden) >> this->shift;
    while (this->numbers[place] != None && this->keys[place] != key)
    {
      place = (place + 1) & (this->numbers.size() - 1);
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
    const std::vector<std::uint64_t> oldKeys = std::move(this->keys);
    const std::vector<Index> oldNumbers = std::move(this->numbers);
    this->shift = 64 - bits;
    this->keys.assign(std::size_t(1) << bits, 0);
    this->numbers.assign(std::size_t(1) << bits, None);
    for (std::size_t i = 0; i < oldNumbers.size(); ++i)
    {
      if (oldNumbers[i] != None)
      {
        const std::size_t place = this->placeOf(oldKeys[i]);
        this->keys[place] = oldKeys[i];
        this->numbers[place] = oldNumbers[i];
      }
    }
  }

  std::vector<std::uint64_t> keys;
  std::vector<Index> numbers; ///< None: the place is empty
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
}

#endif
