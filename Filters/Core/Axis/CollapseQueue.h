// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_CollapseQueue_h
#define medial_CollapseQueue_h

#include "Axis/FlatTetrahedron.h"
#include "Base/Types.h"

#include <cstdint>
#include <queue>
#include <tuple>
#include <vector>

namespace medial
{
/// How a tetrahedron can go, the best way first.
enum class CollapseMove
{
  Side,       ///< with one of its two sides, the flattest tetrahedron first
  BehindFins, ///< the same after fins on the common edge have gone
  Pair,       ///< with any two triangles that are larger than the other two
  Single      ///< through one triangle, the largest first
};

struct CollapseCandidate
{
  CollapseMove move;
  double cost;
  Index tetrahedron;
  FacetSet facets; ///< that go

  bool operator<(const CollapseCandidate& other) const // the last one comes first out of a queue
  {
    return std::tie(other.move, other.cost, other.tetrahedron, other.facets) <
      std::tie(this->move, this->cost, this->tetrahedron, this->facets);
  }
};

/// Candidates in the order of moves and, within them, of costs; the lowest numbers win a tie. Each is in it
/// at most once, however often it is offered.
class CollapseQueue
{
public:
  explicit CollapseQueue(Index tetrahedronCount)
    : isQueued(tetrahedronCount, 0)
  {
  }

  bool empty() const { return this->queue.empty(); }

  void offer(const CollapseCandidate& candidate)
  {
    if ((this->isQueued[candidate.tetrahedron] & bitOf(candidate)) == 0)
    {
      this->isQueued[candidate.tetrahedron] |= bitOf(candidate);
      this->queue.push(candidate);
    }
  }

  CollapseCandidate take()
  {
    const CollapseCandidate next = this->queue.top();
    this->queue.pop();
    this->isQueued[next.tetrahedron] ^= bitOf(next);
    return next;
  }

private:
  /// Another one for each candidate of a tetrahedron. Some triangles can go in two ways: behind fins, or
  /// without.
  static std::uint32_t bitOf(const CollapseCandidate& candidate)
  {
    return 1u << (candidate.facets + (candidate.move == CollapseMove::BehindFins ? 16 : 0));
  }

  std::vector<std::uint32_t> isQueued; ///< for each tetrahedron: the bits of its candidates
  std::priority_queue<CollapseCandidate> queue;
};
}

#endif
