// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/Sides.h"

#include "Balls/SideCut.h"
#include "Balls/SideLinks.h"
#include "Base/Frame.h"
#include "Base/Lists.h"

#include <algorithm>
#include <cmath>
#include <queue>

// The balls are the nodes of a graph. A link joins two balls that intersect (they have the same side,
// with the strength of their intersection) or the two poles of a sample (they have opposite sides,
// with the strength of the angle between them). Each ball carries a belief, 0 ... 1, in either side.
// The balls whose side is known start with 1.
//
// As in Dijkstra's algorithm, the most decided ball is taken from a queue, its side is fixed, and it
// passes its belief times the strength of the link on to each neighbour, where the larger belief
// counts. Invariant: the side of a ball that was taken never changes, and no belief is larger than
// the one it came from. With m balls and e links this costs O((m + e) log e) time; both numbers are
// proportional to the number of samples in practice. Then cutSides() decides anew where links contradict each
// other.
namespace medial
{
namespace
{
/// Evidence about another ball: does it have the same side or the opposite one, and how surely?
struct Link
{
  Index ball;
  float strength; ///< 0 ... 1
  bool same;
};

using Links = Lists<Link>;

Links linksOfBalls(const std::vector<SideLink>& links, Index ballCount)
{
  return listsByKey<Link>(ballCount, [&links](const auto& add) {
    for (const SideLink& link : links)
    {
      add(link.a, Link{ link.b, link.strength, link.same });
      add(link.b, Link{ link.a, link.strength, link.same });
    }
  });
}

/// Belief of each ball in either side, and how decided it is.
struct Beliefs
{
  std::vector<std::array<float, 2>> of; ///< outer, inner

  /// What the queue is ordered by. Unlike [ACK01], a ball with evidence for both sides doesn't come after
  /// all others: strong evidence against a little of the other kind is better than a little alone.
  float priority(Index ball) const { return std::abs(this->of[ball][1] - this->of[ball][0]); }
};

/// Fixes the sides of the balls that chains of links connect with a ball whose side is known.
/// @param known  for each ball: is its side known?
void spread(const Links& links, const std::vector<char>& known, std::vector<Side>& sides)
{
  using Entry = std::pair<float, Index>; // priority, and minus the ball: lowest first among equals
  std::priority_queue<Entry> queue;
  Beliefs beliefs{ std::vector<std::array<float, 2>>(sides.size(), { 0, 0 }) };
  for (Index b = 0; b < count(sides); ++b)
  {
    if (known[b])
    {
      beliefs.of[b][static_cast<int>(sides[b])] = 1;
      queue.push({ beliefs.priority(b), -b });
    }
  }
  std::vector<char> done(sides.size(), 0);
  while (!queue.empty())
  {
    const auto [priority, negative] = queue.top();
    const Index b = -negative;
    queue.pop();
    // A ball is in the queue once for each of its beliefs; only the entry of the latest counts.
    if (done[b] || priority != beliefs.priority(b))
    {
      continue;
    }
    done[b] = 1;
    if (!known[b])
    {
      sides[b] = beliefs.of[b][1] > beliefs.of[b][0] ? Side::Inner : Side::Outer;
    }
    const int side = static_cast<int>(sides[b]);
    const float certainty = beliefs.of[b][side];
    for (const Link& link : links[b])
    {
      float& belief = beliefs.of[link.ball][link.same ? side : 1 - side];
      if (!done[link.ball] && certainty * link.strength > belief)
      {
        belief = certainty * link.strength;
        queue.push({ beliefs.priority(link.ball), -link.ball });
      }
    }
  }
}

/// A ball in no cell of the regular triangulation is hidden.
void hideUnused(const std::vector<Edge>& edges, std::vector<Side>& sides)
{
  std::vector<char> visible(sides.size(), 0);
  for (const auto& [a, b] : edges)
  {
    visible[a] = visible[b] = 1;
  }
  for (std::size_t b = 0; b < sides.size(); ++b)
  {
    sides[b] = visible[b] ? sides[b] : Side::Hidden;
  }
}
}

std::vector<char> surelyOutside(const SideInput& input)
{
  const Eigen::AlignedBox3d box = boundingBox(input.samples);
  std::vector<char> result(input.balls.size());
  for (std::size_t b = 0; b < result.size(); ++b)
  {
    result[b] = input.touchesGuard[b] || !box.contains(input.balls[b].center);
  }
  return result;
}

std::vector<Side> sides(
  const SideInput& input, const Execution& execution, const std::vector<Index>& votes)
{
  std::vector<Side> result(input.balls.size(), Side::Outer);
  std::vector<char> known = surelyOutside(input);
  for (std::size_t b = 0; b < votes.size(); ++b)
  {
    if (!known[b] && votes[b] != 0)
    {
      known[b] = 1;
      result[b] = votes[b] < 0 ? Side::Inner : Side::Outer;
    }
  }
  const std::vector<SideLink> links = sideLinks(input);
  spread(linksOfBalls(links, count(input.balls)), known, result);
  execution.report(0.5);
  cutSides(links, known, result, execution.between(0.5, 1));
  hideUnused(input.edges, result);
  execution.report(1);
  return result;
}

std::vector<Side> sidesIn(
  const SurfaceTree& solid, const Frame& frame, const SideInput& input, const Execution& execution)
{
  std::vector<Side> result(input.balls.size(), Side::Outer);
  execution.forEach(count(result), [&](Index b) {
    if (!input.touchesGuard[b] && solid.encloses(frame.toWorld(input.balls[b].center)))
    {
      result[b] = Side::Inner;
    }
  });
  hideUnused(input.edges, result);
  execution.report(1);
  return result;
}
}
