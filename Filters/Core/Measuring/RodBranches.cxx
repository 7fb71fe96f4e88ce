// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/RodBranches.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <set>
#include <utility>

namespace medial
{
namespace
{
/// A chain of lines between two places where the skeleton is cut.
struct Chain
{
  std::vector<Index> points;
  double length = 0;
  bool inJunction = false; ///< short, between places of one junction

  Index end(int which) const { return which == 0 ? points.front() : points.back(); }
};

/// The length of a polyline in strides of at least the radii of its points.
double strideLength(const std::vector<Ball>& chain)
{
  double result = 0, since = 0;
  std::size_t last = 0;
  for (std::size_t i = 1; i < chain.size(); ++i)
  {
    since += (chain[i].center - chain[i - 1].center).norm();
    if (since >= chain[i].radius || i + 1 == chain.size())
    {
      result += (chain[i].center - chain[last].center).norm();
      last = i;
      since = 0;
    }
  }
  return result;
}

/// The largest ball that contains a point of the skeleton in the double ball about p.
Index largestNear(Index p, const MedialAxis& axis, const std::vector<Edge>& lines,
  const IndexLists& linesAt, const std::vector<Index>& covering)
{
  const double reach = 2 * axis.radii[covering[p]];
  Index result = covering[p];
  std::set<Index> seen{ p };
  std::vector<Index> left{ p };
  while (!left.empty())
  {
    const Index at = left.back();
    left.pop_back();
    const Index ball = covering[at];
    result = axis.radii[ball] > axis.radii[result] ? ball : result;
    for (const Index line : linesAt[at])
    {
      const Index next = lines[line][0] == at ? lines[line][1] : lines[line][0];
      const double distance = (axis.points[next] - axis.points[p]).norm();
      if (distance < reach && seen.insert(next).second)
      {
        left.push_back(next);
      }
    }
  }
  return result;
}

/// Walks along all lines of a skeleton.
class Walking
{
public:
  Walking(const std::vector<Edge>& skeletonLines, const IndexLists& linesAtPoints,
    const std::vector<char>& isAnchor)
    : lines(skeletonLines)
    , linesAt(linesAtPoints)
    , anchor(isAnchor)
    , walked(skeletonLines.size(), 0)
  {
    this->walkChains();
  }

  std::vector<Chain> chains;

private:
  bool isPlace(Index p) const { return this->linesAt[p].size() != 2 || this->anchor[p]; }

  /// Chains from all places, then the rings that have none.
  void walkChains()
  {
    for (const bool rings : { false, true })
    {
      for (Index i = 0; i < count(this->lines); ++i)
      {
        for (const Index start : this->lines[i])
        {
          if (!this->walked[i] && (rings || this->isPlace(start)))
          {
            this->walk(start, i);
          }
        }
      }
    }
  }

  void walk(Index p, Index line)
  {
    const Index start = p;
    Chain chain;
    chain.points.push_back(p);
    while (line != None)
    {
      this->walked[line] = 1;
      p = this->lines[line][0] == p ? this->lines[line][1] : this->lines[line][0];
      chain.points.push_back(p);
      line = None;
      if (p != start && !this->isPlace(p))
      {
        for (const Index next : this->linesAt[p])
        {
          line = this->walked[next] ? line : next;
        }
      }
    }
    this->chains.push_back(std::move(chain));
  }

  const std::vector<Edge>& lines;
  const IndexLists& linesAt;
  const std::vector<char>& anchor;
  std::vector<char> walked; ///< for each line
};

/// The chains of a skeleton, and which of the places where they end are one junction.
class Network
{
public:
  Network(const MedialAxis& medialAxis, const RodSkeleton& skeleton,
    const std::vector<char>& isAnchor, const std::vector<Index>& coveringBalls)
    : axis(medialAxis)
    , lines(skeleton.edges)
    , anchor(isAnchor)
    , covering(coveringBalls)
    , places(count(medialAxis.points))
  {
    this->linesAt = listsByKey(count(this->axis.points), [this](const auto& add) {
      for (Index i = 0; i < count(this->lines); ++i)
      {
        add(this->lines[i][0], i);
        add(this->lines[i][1], i);
      }
    });
    this->chains = Walking(this->lines, this->linesAt, this->anchor).chains;
    for (Chain& chain : this->chains)
    {
      chain.length = strideLength(this->balls(chain));
    }
    this->contract();
  }

  bool isPlace(Index p) const { return this->linesAt[p].size() != 2 || this->anchor[p]; }
  /// Makes places that are near one junction.
  void contract()
  {
    for (const Chain& chain : this->chains)
    {
      if (this->isShort(chain))
      {
        this->places.unite(chain.end(0), chain.end(1));
      }
    }
    this->anchored.assign(this->axis.points.size(), 0);
    this->largest = this->covering;
    for (Index p = 0; p < count(this->axis.points); ++p)
    {
      const Index place = this->places.find(p);
      this->anchored[place] |= this->anchor[p];
      const Index ball = this->linesAt[p].size() > 2
        ? largestNear(p, this->axis, this->lines, this->linesAt, this->covering)
        : None;
      if (ball != None && this->axis.radii[ball] > this->axis.radii[this->largest[place]])
      {
        this->largest[place] = ball;
      }
    }
    for (Chain& chain : this->chains)
    {
      chain.inJunction =
        this->isShort(chain) && this->places.find(chain.end(0)) == this->places.find(chain.end(1));
    }
  }

  bool isShort(const Chain& chain) const
  {
    const Index a = chain.end(0), b = chain.end(1);
    const auto isMeeting = [this](
                             Index p) { return this->linesAt[p].size() > 2 || this->anchor[p]; };
    const double radii = this->axis.radii[this->covering[a]] + this->axis.radii[this->covering[b]];
    return isMeeting(a) && isMeeting(b) && chain.length < std::max(radii, this->axis.sampleSpacing);
  }

  Ball ball(Index p) const { return { this->axis.points[p], this->axis.radii[p] }; }

  std::vector<Ball> balls(const Chain& chain) const
  {
    std::vector<Ball> result;
    for (const Index p : chain.points)
    {
      result.push_back(this->ball(p));
    }
    return result;
  }

  /// A chain that comes straight from the centres of the junctions at its ends, and goes straight to them.
  std::vector<Ball> trimmed(const Chain& chain)
  {
    std::vector<Ball> result = this->balls(chain);
    for (const int which : { 0, 1 })
    {
      const Index end = chain.end(which);
      if (this->linesAt[end].size() > 2 && !this->anchored[this->places.find(end)])
      {
        const Ball junction = this->ball(this->largest[this->places.find(end)]);
        // Within the diameter of a junction the skeleton may follow any of the sheets there.
        std::size_t first = result.size() / 2;
        while (
          first > 0 && (result[first - 1].center - junction.center).norm() > 2 * junction.radius)
        {
          --first;
        }
        result.erase(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(first));
        result.insert(result.begin(), junction);
      }
      std::reverse(result.begin(), result.end());
    }
    return result;
  }

  const MedialAxis& axis;
  const std::vector<Edge>& lines;
  const std::vector<char>& anchor;
  const std::vector<Index>& covering;
  IndexLists linesAt;
  std::vector<Chain> chains;
  DisjointSets places;        ///< points that are one place
  std::vector<Index> largest; ///< for each place the largest ball that contains a point of it
  std::vector<char> anchored; ///< for each place, by its lowest point: is an anchor in it?
};

/// Numbers rods and junctions.
class Cutting
{
public:
  explicit Cutting(Network& theNetwork)
    : net(theNetwork)
  {
  }

  RodBranches result()
  {
    const Lists<Edge> endsAt = this->chainEnds();
    DisjointSets rods(count(this->net.chains));
    std::vector<double> gap(
      this->net.chains.size(), 0); // by chain, where its end goes on in another one
    for (Index place = 0; place < endsAt.size(); ++place)
    {
      const Lists<Edge>::View ends = endsAt[place];
      if (ends.size() == 2 && !this->net.anchored[place] && rods.unite(ends[0][0], ends[1][0]))
      {
        gap[ends[0][0]] += (this->placeOf(ends[0]) - this->placeOf(ends[1])).norm();
      }
    }
    RodBranches result;
    const std::vector<Index> rodOfChain = this->addRods(rods, gap, result);
    this->addJunctions(endsAt, rodOfChain, result);
    return result;
  }

private:
  const Point& placeOf(const Edge& chainEnd) const
  {
    return this->net.axis.points[this->net.chains[chainEnd[0]].end(chainEnd[1])];
  }

  /// For each place the chains that end there, and with which end. Rings have none.
  Lists<Edge> chainEnds()
  {
    return listsByKey<Edge>(count(this->net.axis.points), [this](const auto& add) {
      for (Index c = 0; c < count(this->net.chains); ++c)
      {
        const Chain& chain = this->net.chains[c];
        if (!chain.inJunction && this->net.isPlace(chain.end(0)))
        {
          add(this->net.places.find(chain.end(0)), Edge{ c, 0 });
          add(this->net.places.find(chain.end(1)), Edge{ c, 1 });
        }
      }
    });
  }

  /// @return  the rod of each chain, or None
  std::vector<Index> addRods(
    DisjointSets& rods, const std::vector<double>& gap, RodBranches& result)
  {
    std::vector<Index> rodOfChain(this->net.chains.size(), None);
    Index rodCount = 0;
    for (Index c = 0; c < count(this->net.chains); ++c)
    {
      if (!this->net.chains[c].inJunction)
      {
        const Index first = rods.find(c);
        rodOfChain[c] = first == c ? rodCount++ : rodOfChain[first];
      }
    }
    result.length.assign(rodCount, 0);
    result.points = listsByKey(rodCount, [&](const auto& add) {
      for (Index c = 0; c < count(this->net.chains); ++c)
      {
        for (std::size_t i = 0; rodOfChain[c] != None && i < this->net.chains[c].points.size(); ++i)
        {
          add(rodOfChain[c], this->net.chains[c].points[i]);
        }
      }
    });
    for (Index c = 0; c < count(this->net.chains); ++c)
    {
      if (rodOfChain[c] != None)
      {
        result.length[rodOfChain[c]] +=
          strideLength(this->net.trimmed(this->net.chains[c])) + gap[c];
      }
    }
    return rodOfChain;
  }

  void addJunctions(
    const Lists<Edge>& endsAt, const std::vector<Index>& rodOfChain, RodBranches& result)
  {
    const IndexLists pointsAt = listsByKey(count(this->net.axis.points), [this](const auto& add) {
      for (const Chain& chain : this->net.chains)
      {
        for (const int which : { 0, 1 })
        {
          add(this->net.places.find(chain.end(which)), chain.end(which));
        }
        for (std::size_t i = 0; chain.inJunction && i < chain.points.size(); ++i)
        {
          add(this->net.places.find(chain.end(0)), chain.points[i]);
        }
      }
    });
    for (Index place = 0; place < endsAt.size(); ++place)
    {
      if (endsAt[place].size() > 2 || (endsAt[place].size() > 0 && this->net.anchored[place]))
      {
        std::vector<Index> rods;
        for (const Edge& end : endsAt[place])
        {
          rods.push_back(rodOfChain[end[0]]);
        }
        sortUnique(rods);
        result.rodsAtJunction.append(rods);
        std::vector<Index> points(pointsAt[place].begin(), pointsAt[place].end());
        sortUnique(points);
        result.pointsAtJunction.append(points);
        for (const Index p : points)
        {
          if (this->net.anchor[p])
          {
            result.anchorsAtJunction.items.push_back(p);
          }
        }
        result.anchorsAtJunction.close();
      }
    }
  }

  Network& net;
};
}

RodBranches rodBranches(const MedialAxis& axis, const RodSkeleton& skeleton,
  const std::vector<char>& anchor, const std::vector<Index>& covering)
{
  Network network(axis, skeleton, anchor, covering);
  return Cutting(network).result();
}
}
