// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/ThinPlaces.h"

#include "Axis/AxisEdges.h"
#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Base/Lists.h"
#include "Base/Neighbors.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace medial
{
namespace
{
/// Do some walls hold a ball from opposite sides? Then a mean of their normals is short: that of two that differ by 150
/// degrees is as long as `most`, and of three around a rod it can be zero. It is found by Gilbert's algorithm: one goes
/// from the mean so far towards the wall that faces it most, as far as the mean gets shorter.
bool holdFromOppositeSides(const std::vector<SampleWall>& walls, const IndexLists::View& samples)
{
  constexpr double most = 0.259; // cosine of 75 degrees
  constexpr int turns = 50;
  std::vector<Point> normals;
  for (const Index s : samples)
  {
    if (!walls[s].normal.isZero()) // else it isn't known
    {
      normals.push_back(walls[s].normal);
    }
  }
  if (normals.empty())
  {
    return false;
  }
  Point mean = normals.front();
  for (int turn = 0; turn < turns && mean.norm() > most; ++turn)
  {
    const Point& next = *std::min_element(normals.begin(), normals.end(),
      [&](const Point& a, const Point& b) { return a.dot(mean) < b.dot(mean); });
    if (next.dot(mean) > most * mean.norm())
    {
      return false; // all normals are beyond a plane at that distance
    }
    const Point step = next - mean;
    mean += std::clamp(-mean.dot(step) / step.squaredNorm(), 0.0, 1.0) * step;
  }
  return mean.norm() <= most;
}

/// Points in the order of their thickness: the rank of each.
struct Ranks
{
  std::vector<Index> points; ///< the thinnest first
  std::vector<Index> ofPoint;
};

Ranks ranks(const std::vector<double>& thickness)
{
  Ranks result{ std::vector<Index>(thickness.size()), std::vector<Index>(thickness.size()) };
  std::iota(result.points.begin(), result.points.end(), 0);
  std::stable_sort(result.points.begin(), result.points.end(),
    [&](Index a, Index b) { return thickness[a] < thickness[b]; });
  for (Index rank = 0; rank < count(result.points); ++rank)
  {
    result.ofPoint[result.points[rank]] = rank;
  }
  return result;
}

/// For each rank the lower ranks next to it.
IndexLists lowerNeighbors(const AxisCells& cells, const Ranks& ranking)
{
  const std::vector<Edge> edges = axisEdges(cells).points;
  return listsByKey(count(ranking.points), [&](const auto& add) {
    for (const auto& [a, b] : edges)
    {
      const auto [low, high] = std::minmax(ranking.ofPoint[a], ranking.ofPoint[b]);
      add(high, low);
    }
  });
}

/// For each rank the lowest rank of its basin: that which the way down leads to, and beyond, over rises less than `depth`.
std::vector<Index> basins(
  const IndexLists& lower, const std::vector<double>& thicknessOfRank, double depth)
{
  DisjointSets flooded(lower.size()), basins(lower.size());
  for (Index rank = 0; rank < lower.size(); ++rank)
  {
    const IndexLists::View below = lower[rank];
    if (below.size() > 0)
    {
      basins.unite(rank, *std::min_element(below.begin(), below.end()));
    }
    for (const Index other : below)
    {
      const auto [kept, ended] = std::minmax({ flooded.find(rank), flooded.find(other) });
      if (kept != ended && thicknessOfRank[rank] < (1 + depth) * thicknessOfRank[ended])
      {
        basins.unite(rank, ended);
        basins.unite(rank, other);
      }
      flooded.unite(kept, ended);
    }
  }
  std::vector<Index> result(lower.size());
  for (Index rank = 0; rank < lower.size(); ++rank)
  {
    result[rank] = basins.find(rank);
  }
  return result;
}

/// For each rank: is its point at a wall, or leads the way down to a wall?
std::vector<char> countingRanks(const std::vector<char>& isWall, const IndexLists& lower,
  const std::vector<double>& thicknessOfRank, double depth)
{
  const std::vector<Index> basin = basins(lower, thicknessOfRank, depth);
  std::vector<char> endsAtWall(isWall.size(), 0), result(isWall.size());
  for (Index rank = 0; rank < lower.size(); ++rank)
  {
    const Index bottom = basin[rank];
    if (isWall[rank] && thicknessOfRank[rank] <= (1 + depth) * thicknessOfRank[bottom])
    {
      endsAtWall[bottom] = 1;
    }
  }
  for (Index rank = 0; rank < lower.size(); ++rank)
  {
    result[rank] = isWall[rank] || endsAtWall[basin[rank]] ? 1 : 0;
  }
  return result;
}

/// The values of points by rank.
template <typename Value>
std::vector<Value> byRank(const std::vector<Value>& ofPoint, const Ranks& ranking)
{
  std::vector<Value> result;
  result.reserve(ofPoint.size());
  for (const Index point : ranking.points)
  {
    result.push_back(ofPoint[point]);
  }
  return result;
}

/// The places without those in the ball of a thinner one: next to sharp edges a wall falls to pieces.
std::vector<ThinPlace> apart(const std::vector<ThinPlace>& places, const std::vector<Point>& points)
{
  std::vector<Point> at;
  at.reserve(places.size());
  for (const ThinPlace& place : places)
  {
    at.push_back(points[place.point]);
  }
  const Neighbors neighbors(at);
  std::vector<char> isLeftOut(places.size(), 0);
  std::vector<ThinPlace> result;
  for (Index i = 0; i < count(places); ++i)
  {
    if (!isLeftOut[i])
    {
      result.push_back(places[i]);
      neighbors.forEachWithin(
        at[i], places[i].thickness / 2, [&](Index other) { isLeftOut[other] = 1; });
    }
  }
  return result;
}
}

AxisThickness axisThickness(const AxisComplex& axis, const PolarBalls& balls,
  const std::vector<SampleWall>& walls, const std::vector<double>& distances,
  const Execution& execution)
{
  constexpr double least = 2.5; // local spacings
  const Neighbors neighbors(balls.samples);
  const std::vector<double> spacings = meanDistances(balls.samples, neighbors, execution);
  AxisThickness result;
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    const Index ball = axis.ballOfPoint[i];
    result.ofPoint.push_back(2 * (ball == None ? axis.radii[i] : distances[ball]));
    double widest = std::numeric_limits<double>::infinity();
    if (ball != None && holdFromOppositeSides(walls, balls.ballSamples[ball]))
    {
      widest = 0;
      for (const Index s : balls.ballSamples[ball])
      {
        widest = std::max(widest, spacings[s]);
      }
    }
    result.isWall.push_back(result.ofPoint.back() >= least * widest ? 1 : 0);
  }
  return result;
}

// The axis is flooded by growing thickness. Each minimum has a set, known by its lowest rank: the minimum itself. Where two
// meet, the higher one ends.
std::vector<ThinPlace> thinPlaces(
  const AxisComplex& axis, const AxisThickness& thickness, double depth)
{
  if (!(depth >= 0))
  {
    throw InvalidInput("the depth of thin places is ", depth, "; give a share of 0 or more");
  }
  const Ranks ranking = ranks(thickness.ofPoint);
  const IndexLists lower = lowerNeighbors(axis.cells, ranking);
  const std::vector<double> thicknessOf = byRank(thickness.ofPoint, ranking);
  const std::vector<char> counts =
    countingRanks(byRank(thickness.isWall, ranking), lower, thicknessOf, depth);
  std::vector<ThinPlace> result;
  const auto add = [&](Index rank, double itsDepth) {
    if (itsDepth >= depth)
    {
      result.push_back({ ranking.points[rank], thicknessOf[rank], itsDepth });
    }
  };
  DisjointSets flooded(lower.size());
  for (Index rank = 0; rank < lower.size(); ++rank)
  {
    for (const Index other : lower[rank])
    {
      const auto [kept, ended] = std::minmax({ flooded.find(rank), flooded.find(other) });
      if (counts[rank] && counts[other] && flooded.unite(kept, ended) && ended != rank)
      {
        add(ended, thicknessOf[rank] / thicknessOf[ended] - 1);
      }
    }
  }
  for (Index rank = 0; rank < lower.size(); ++rank)
  {
    if (counts[rank] && flooded.find(rank) == rank)
    {
      add(rank, std::numeric_limits<double>::infinity());
    }
  }
  std::sort(result.begin(), result.end(), [&](const ThinPlace& a, const ThinPlace& b) {
    return ranking.ofPoint[a.point] < ranking.ofPoint[b.point];
  });
  return apart(result, axis.points);
}
}
