// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/GapFilling.h"

#include "Axis/OutsideCounts.h"
#include "Axis/OutsideSearch.h"
#include "Base/DisjointSets.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <queue>
#include <utility>

// One bound of depth for the whole solid opens gaps in some places, where the samples are sparse, that a lower
// bound would not open; but that may close gaps elsewhere. So the set grows from its border, the deepest cell
// first, like water that rises, and each cell that would change the topology is looked at alone.
//
// What a cell shares with the outside of set and cell tells the change. Of n components of that, n - 1 are
// ways through the outside that the cell blocks: each fills a tunnel of the set, or cuts a void off. None at
// all: the cell fills a void. Around each loop of it the cell touches the set once more: that joins two
// pieces, or makes a tunnel. Union-find tells pieces; whether ways around the cell are connected elsewhere is searched for,
// but only where that can matter.
//
// No tunnel is made. A set with too few of them is wrong in more than gaps, and other tunnels than those that
// are missing would only make the numbers right.
//
// A cell is tested when it comes to the border and when a cell beside it has joined: O(n log n) for n cells,
// and the way around for each search, O(n) at most. Few cells join before the gaps of samples that are a little too sparse close.

namespace medial
{
namespace
{
class GapFiller
{
public:
  GapFiller(const SiteTriangulation& triangulation, const std::vector<Index>& pieces,
    const Betti& wanted, OpenSet& openSet)
    : sites(triangulation)
    , pieceOfBall(pieces)
    , target(wanted)
    , set(openSet)
    , outside(triangulation)
    , search(triangulation)
    , groups(count(openSet.cells))
    , shapePiece(openSet.cells.size(), None)
  {
    this->result.betti = bettiNumbers(triangulation, openSet);
    for (Index c = 0; c < count(openSet.cells); ++c)
    {
      if (openSet.cells[c])
      {
        this->join(c);
      }
    }
  }

  FilledGaps run(const Execution& execution)
  {
    for (Index turn = 0; !this->border.empty() && this->result.betti != this->target; ++turn)
    {
      execution.pollAt(turn);
      const Index cell = -this->border.top().second;
      this->border.pop();
      if (!this->set.cells[cell] && this->mayJoin(cell, execution))
      {
        this->set.cells[cell] = 1;
        this->join(cell);
      }
    }
    return this->result;
  }

private:
  /// What is known of a cell in the set: which cells are connected with it, what lies on the border.
  void join(Index cell)
  {
    this->outside.takeIn(cell);
    Index piece = this->sites.onBall[cell];
    piece = piece == None ? None : this->pieceOfBall[piece];
    for (const Index n : this->sites.mesh.neighbors[cell])
    {
      if (n != None && this->set.cells[n])
      {
        const Index other = this->shapePiece[this->groups.find(n)];
        piece = piece == None ? other : piece;
        this->groups.unite(cell, n);
      }
      else if (n != None)
      {
        this->border.emplace(this->sites.depth[n], -n); // the lowest cell wins a tie
      }
    }
    Index& known = this->shapePiece[this->groups.find(cell)];
    known = known == None ? piece : known;
  }

  /// Can the cell join the set so that each Betti number stays or comes nearer to its target? Updates these
  /// then.
  bool mayJoin(Index cell, const Execution& execution)
  {
    int openFacets = 4;
    std::vector<Index> touched; // connected groups of the set
    for (const Index n : this->sites.mesh.neighbors[cell])
    {
      if (n != None && this->set.cells[n])
      {
        --openFacets;
        touched.push_back(this->groups.find(n));
      }
    }
    const BoundaryPiece shared = this->outside.sharedWithOthers(cell, openFacets);
    if (shared.isContractible())
    {
      return true;
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    const Index contacts = shared.components == 0 ? 1 : 1 + shared.loops;
    if (contacts > count(touched) || !this->areInOnePiece(touched))
    {
      return false;
    }
    const Index blocked = std::max(shared.components - 1, 0);
    Index voidsMade = shared.components == 0 ? -1 : 0;
    if (blocked > 0)
    {
      if (!this->wantsFewer(1) && !this->wantsMore(2))
      {
        return false; // whether it fills a tunnel or makes a void
      }
      execution.poll();
      voidsMade = this->search.piecesAround(cell, this->set) - 1;
    }
    const Index tunnelsFilled = blocked - std::max(voidsMade, 0);
    return this->accept({ 1 - count(touched), -tunnelsFilled, voidsMade });
  }

  bool wantsFewer(int i) const { return this->result.betti[i] > this->target[i]; }
  bool wantsMore(int i) const { return this->result.betti[i] < this->target[i]; }

  /// Are groups of the set in one connected piece of the power shape, as far as that is known?
  bool areInOnePiece(const std::vector<Index>& touched) const
  {
    Index piece = None;
    for (const Index group : touched)
    {
      const Index own = this->shapePiece[group];
      if (piece != None && own != None && own != piece)
      {
        return false;
      }
      piece = piece == None ? own : piece;
    }
    return true;
  }

  /// Makes a change of the Betti numbers if no number overshoots its target or goes away from it.
  bool accept(const Betti& change)
  {
    Betti after = this->result.betti;
    for (int i = 0; i < 3; ++i)
    {
      after[i] += change[i];
      if (std::abs(after[i] - this->target[i]) + std::abs(change[i]) !=
        std::abs(this->result.betti[i] - this->target[i]))
      {
        return false;
      }
    }
    this->result.betti = after;
    ++this->result.places;
    return true;
  }

  const SiteTriangulation& sites;
  const std::vector<Index>& pieceOfBall;
  const Betti target;
  OpenSet& set;
  FilledGaps result;
  OutsideCounts outside;
  OutsideSearch search;
  DisjointSets groups; ///< of cells in the set, over shared facets
  std::vector<Index>
    shapePiece; ///< for the lowest cell of each group: its piece of the power shape
  /// Cells beside the set, with their depths; some are in it by now.
  std::priority_queue<std::pair<double, Index>> border;
};
}

FilledGaps fillGaps(const SiteTriangulation& sites, const std::vector<Index>& pieceOfBall,
  const Betti& target, OpenSet& set, const Execution& execution)
{
  return GapFiller(sites, pieceOfBall, target, set).run(execution);
}
}
