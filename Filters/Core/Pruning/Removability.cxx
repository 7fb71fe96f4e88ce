// SPDX-License-Identifier: BSD-3-Clause
#include "Pruning/Removability.h"

#include "Parts/TopologyGraph.h"

#include <algorithm>
#include <unordered_map>

namespace medial
{
namespace
{
using Effect = PartCollapse::Effect;

/// What the paper's graph says about removing parts. A part is an edge between the nodes that it
/// touches. With one node it is on no loop and connects nothing. With more it is on a loop, or it
/// connects the nodes.
Effect graphEffect(const PruneRound& round, const std::vector<Index>& parts)
{
  if (parts.size() > 1)
  {
    return Effect::Changes; // the graph tells of single parts only
  }
  const TopologyGraph graph = topologyGraph(round.contacts, round.gone);
  const Index nodes = graph.nodesOfPart[parts[0]].size();
  return nodes == 0 ? Effect::Isolated : nodes == 1 ? Effect::None : Effect::Changes;
}

/// Searches the pieces that are connected without a part, each from a neighbor of the part.
///
/// Idea: without the part, its surroundings fall apart into pieces. All but the largest make the branch
/// with it. Walking through the largest, which is usually nearly the whole axis, would be too slow, so
/// a walk stops once its piece is surely too large: above the threshold, or with a protected part.
/// Invariant: each visited part is the part itself, in a small piece that was walked to its end, or in
/// the large rest. So a walk that meets what an earlier walk has seen is in the large rest too: a small
/// piece has no neighbors outside.
/// Cost: each walk visits at most `largestPiece` parts and their neighbors, whatever the size of the
/// axis; often only a few parts, as the threshold stops it first.
class BranchSearch
{
public:
  BranchSearch(
    PruneRounds& pruneRounds, const PruneRound& pruneRound, double branchThreshold, Index stem)
    : rounds(pruneRounds)
    , round(pruneRound)
    , threshold(branchThreshold)
    , root(stem)
    , unit{ stem }
    , sum(pruneRound.significance[stem])
    , visited{ { stem, 0 } }
  {
  }

  std::vector<Index> branch()
  {
    bool restIsLarge = false;
    for (const Index start : this->rounds.neighbors(this->round, this->root))
    {
      if (!this->round.gone[start] && !this->visited.count(start))
      {
        restIsLarge = !this->addSmallPiece(start) || restIsLarge;
      }
    }
    return restIsLarge && this->unit.size() > 1 ? this->unit : std::vector<Index>();
  }

private:
  /// A piece of more parts than this counts as large, whatever their significance.
  static constexpr std::size_t largestPiece = 1000;

  /// Walks through the piece of a part. @return  false: it is large, nothing was added
  bool addSmallPiece(Index start)
  {
    const std::size_t earlier = this->visited.size();
    this->visited.emplace(start, earlier);
    std::vector<Index> piece{ start };
    double pieceSum = 0;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      pieceSum = together(this->round.measure, pieceSum, this->round.significance[piece[i]]);
      const bool isLarge = piece.size() > largestPiece || this->round.isProtected[piece[i]] ||
        together(this->round.measure, this->sum, pieceSum) > this->threshold;
      // What only this walk has seen stays visited: the next walk that meets it stops there.
      if (isLarge || this->meetsEarlierWalk(piece, piece[i], earlier))
      {
        return false;
      }
    }
    this->sum = together(this->round.measure, this->sum, pieceSum);
    this->unit.insert(this->unit.end(), piece.begin(), piece.end());
    return true;
  }

  /// Adds the new neighbors of a part to its piece.
  /// @param earlier  parts visited before the walk through this piece
  /// @return  is one of the neighbors of an earlier walk, hence in the large rest?
  bool meetsEarlierWalk(std::vector<Index>& piece, Index part, std::size_t earlier)
  {
    bool meets = false;
    for (const Index next : this->rounds.neighbors(this->round, part))
    {
      const auto known = this->visited.find(next);
      if (known != this->visited.end())
      {
        meets = meets || (next != this->root && known->second < earlier);
      }
      else if (!this->round.gone[next])
      {
        this->visited.emplace(next, this->visited.size());
        piece.push_back(next);
      }
    }
    return meets;
  }

  PruneRounds& rounds;
  const PruneRound& round;
  const double threshold;
  const Index root;
  std::vector<Index> unit;                        ///< the branch so far
  double sum;                                     ///< its significance
  std::unordered_map<Index, std::size_t> visited; ///< parts, with the order in which they were met
};
}

Removability::Removability(
  const LivingCells& livingCells, PruneRounds& pruneRounds, const PruneOptions& pruneOptions)
  : living(livingCells)
  , rounds(pruneRounds)
  , options(pruneOptions)
  , collapse(livingCells)
{
}

std::optional<KeepReason> Removability::refusal(
  const PruneRound& round, const std::vector<Index>& parts)
{
  const auto isProtected = [&round](Index part) { return round.isProtected[part]; };
  if (std::any_of(parts.begin(), parts.end(), isProtected))
  {
    return KeepReason::Protected;
  }
  const std::vector<Index> cells = cellsOf(round, parts);
  Effect effect = Effect::None;
  switch (this->options.topology)
  {
    case Topology::None: // something must stay
      effect = count(cells) < this->living.size() ? Effect::None : Effect::Isolated;
      break;
    case Topology::PaperGraph:
      effect = graphEffect(round, parts);
      break;
    case Topology::Collapse:
      effect = this->collapse.effectOfRemoving(cells);
  }
  return effect == Effect::None ? std::optional<KeepReason>()
    : effect == Effect::Changes ? KeepReason::Topology
                                : KeepReason::Isolated;
}

std::vector<Index> Removability::branch(const PruneRound& round, Index part, double threshold)
{
  return BranchSearch(this->rounds, round, threshold, part).branch();
}
}
