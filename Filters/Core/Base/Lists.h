// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Lists_h
#define medial_Lists_h

#include "Base/Types.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace medial
{
/// Several lists in one array: list i is items[offsets[i]] ... items[offsets[i + 1] - 1].
///
/// A vector of vectors would allocate memory for each list.
template <typename Item>
struct Lists
{
  std::vector<Index> offsets{ 0 };
  std::vector<Item> items;

  /// One list, for a range-based for loop.
  struct View
  {
    const Item* first;
    const Item* last;
    const Item* begin() const { return first; }
    const Item* end() const { return last; }
    Index size() const { return static_cast<Index>(last - first); }
    const Item& operator[](Index i) const { return first[i]; }
  };

  /// Number of lists.
  Index size() const { return static_cast<Index>(offsets.size()) - 1; }
  View operator[](Index i) const
  {
    return { items.data() + offsets[i], items.data() + offsets[i + 1] };
  }
  /// Ends the list that was being appended to `items`.
  void close() { offsets.push_back(static_cast<Index>(items.size())); }

  /// Appends a list.
  template <typename Container>
  void append(const Container& list)
  {
    items.insert(items.end(), list.begin(), list.end());
    this->close();
  }

  /// Sorts each list.
  void sortEach()
  {
    for (Index i = 0; i < this->size(); ++i)
    {
      std::sort(items.begin() + offsets[i], items.begin() + offsets[i + 1]);
    }
  }
};

using IndexLists = Lists<Index>;

/// Groups items by a key with a counting sort, in linear time: list k holds the items that come with
/// the key k, in their order.
/// @param forAll  calls its argument(key, item) for all items, the same in each of two calls
template <typename Item = Index, typename ForAll>
Lists<Item> listsByKey(Index keyCount, const ForAll& forAll)
{
  Lists<Item> result;
  result.offsets.assign(keyCount + 1, 0);
  forAll([&result](Index key, const Item&) { ++result.offsets[key + 1]; });
  std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
  result.items.resize(result.offsets.back());
  std::vector<Index> next = result.offsets;
  forAll([&](Index key, const Item& item) { result.items[next[key]++] = item; });
  return result;
}

/// The lowest item that all four of the chosen lists hold, or None.
/// @param lists  ascending
inline Index lowestCommonItem(const IndexLists& lists, const Tetrahedron& chosen)
{
  // The shortest list is walked through: some have most items of all.
  Tetrahedron order = chosen;
  std::swap(order[0], *std::min_element(order.begin(), order.end(), [&](Index a, Index b) {
    return lists[a].size() < lists[b].size();
  }));
  for (const Index item : lists[order[0]])
  {
    const auto hasItem = [&](Index number) {
      const IndexLists::View list = lists[number];
      return std::binary_search(list.begin(), list.end(), item);
    };
    if (hasItem(order[1]) && hasItem(order[2]) && hasItem(order[3]))
    {
      return item;
    }
  }
  return None;
}

/// The middle one of the values in order, the upper one of two.
/// @param values  not empty
inline double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Sorts values and drops repeats.
template <typename Value>
void sortUnique(std::vector<Value>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}
}

#endif
