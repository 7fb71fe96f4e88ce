// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/SheetMerging.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{
// A set keeps a map of its bonds under one of its members, its name. When two become one, the entries of the
// smaller map move to the larger one, whose name stays: each entry moves O(log n) times.
class Merging
{
public:
  Merging(DisjointSets& theSets, const std::vector<Bond>& bonds)
    : sets(theSets)
  {
    for (const Bond& bond : bonds)
    {
      const Index a = this->sets.find(bond.a), b = this->sets.find(bond.b);
      if (a != b)
      {
        this->bondsOf[a][b] += bond.strength;
        this->bondsOf[b][a] += bond.strength;
        this->weight[a] += std::abs(bond.strength);
        this->weight[b] += std::abs(bond.strength);
      }
    }
    for (const auto& [name, others] : this->bondsOf)
    {
      for (const auto& [other, strength] : others)
      {
        if (name < other)
        {
          this->offer(name, other, strength);
        }
      }
    }
  }

  void run(const Execution& execution)
  {
    for (Index turn = 0; !this->strongest.empty(); turn = (turn + 1) % 4096)
    {
      execution.pollAt(turn);
      const auto [weakness, low, high, a, b] = this->strongest.top();
      this->strongest.pop();
      const auto set = this->bondsOf.find(a);
      if (set != this->bondsOf.end())
      {
        const auto bond = set->second.find(b);
        if (bond != set->second.end() && bond->second == -weakness &&
          this->isStrong(a, b, -weakness))
        {
          this->unite(a, b);
        }
      }
    }
  }

private:
  using Bonds = std::map<Index, double>;

  void offer(Index a, Index b, double strength)
  {
    if (strength > 0)
    {
      const Index first = this->sets.find(a), second = this->sets.find(b);
      this->strongest.push({ -strength, std::min(first, second), std::max(first, second), a, b });
    }
  }

  /// Is it more than a gap in the border of the set with the shorter one?
  bool isStrong(Index a, Index b, double strength)
  {
    constexpr double least = 0.1;
    return strength > least * std::min(this->weight[a], this->weight[b]);
  }

  void unite(Index a, Index b)
  {
    if (this->bondsOf[a].size() < this->bondsOf[b].size())
    {
      std::swap(a, b);
    }
    this->sets.unite(a, b);
    this->weight[a] += this->weight[b];
    Bonds& kept = this->bondsOf[a];
    kept.erase(b);
    const Bonds moved = std::move(this->bondsOf[b]);
    this->bondsOf.erase(b);
    for (const auto& [other, strength] : moved)
    {
      if (other != a)
      {
        const double sum = kept[other] += strength;
        this->bondsOf[other].erase(b);
        this->bondsOf[other][a] = sum;
        this->offer(a, other, sum);
      }
    }
  }

  DisjointSets& sets;
  std::map<Index, Bonds> bondsOf; ///< by names of sets, in both directions
  std::map<Index, double> weight; ///< by names of sets: the amounts of all their bonds
  using Offer = std::tuple<double, Index, Index, Index, Index>; // -strength, lowest members, names
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> strongest;
};
}

void mergeByBonds(DisjointSets& sets, const std::vector<Bond>& bonds, const Execution& execution)
{
  Merging(sets, bonds).run(execution);
}
}
