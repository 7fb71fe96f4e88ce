// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_DisjointSets_h
#define medial_DisjointSets_h

#include "Base/Types.h"

#include <numeric>
#include <vector>

namespace medial
{
/// Union-find. A set is known by its lowest member, whatever the order of the unions. Paths are halved
/// by each search, so that a union costs O(log n) on average.
class DisjointSets
{
public:
  explicit DisjointSets(Index size)
    : parent(size)
  {
    std::iota(this->parent.begin(), this->parent.end(), 0);
  }
  Index find(Index i)
  {
    while (this->parent[i] != i)
    {
      i = this->parent[i] = this->parent[this->parent[i]];
    }
    return i;
  }
  /// @return  were they in different sets?
  bool unite(Index a, Index b)
  {
    a = this->find(a);
    b = this->find(b);
    if (a == b)
    {
      return false;
    }
    this->parent[std::max(a, b)] = std::min(a, b);
    return true;
  }

private:
  std::vector<Index> parent;
};
}

#endif
