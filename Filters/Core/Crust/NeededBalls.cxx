// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/NeededBalls.h"

#include "Balls/MarkedBetti.h"
#include "Base/Lists.h"
#include "Base/Triangulations.h"

#include <algorithm>
#include <iterator>

namespace medial
{
namespace
{
using Balls = std::vector<Index>; ///< ascending

Balls unionOf(const Balls& a, const Balls& b)
{
  Balls result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

Balls difference(const Balls& a, const Balls& b)
{
  Balls result;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

using Cells = std::vector<Tetrahedron>; ///< as in ChangedRegion

class Search
{
public:
  Search(const LabelledBalls& labelledBalls, const Execution& ofSearch)
    : all(labelledBalls)
    , execution(ofSearch)
    , number(labelledBalls.balls.size(), None)
  {
  }

  std::vector<ContradictedRegion> regions(
    const Cells& with, const Cells& without, const Balls& removed)
  {
    std::vector<ContradictedRegion> result;
    for (ChangedRegion& region : changedRegions(with, without, removed))
    {
      this->execution.report(0);
      Balls needed = this->neededIn(region);
      if (!needed.empty())
      {
        result.push_back({ std::move(region), std::move(needed) });
      }
    }
    return result;
  }

private:
  /// None where the topology doesn't change.
  Balls neededIn(const ChangedRegion& region)
  {
    const Betti wanted = this->bettiOf(region.with);
    if (this->bettiOf(region.without) == wanted)
    {
      return {};
    }
    if (region.removed.size() == 1)
    {
      return { region.removed.front() };
    }
    const auto [first, second] = this->halves(region.removed);
    const Cells withFirst = this->cellsWith(first, region);
    if (this->bettiOf(withFirst) == wanted)
    {
      return this->neededOf(withFirst, region.without, first);
    }
    const Cells withSecond = this->cellsWith(second, region);
    if (this->bettiOf(withSecond) == wanted)
    {
      return this->neededOf(withSecond, region.without, second);
    }
    const Balls ofSecond = this->neededOf(region.with, withFirst, second);
    const Cells withNeeded = this->cellsWith(ofSecond, region);
    return this->bettiOf(withNeeded) == wanted
      ? ofSecond
      : unionOf(ofSecond,
          this->neededOf(this->cellsWith(unionOf(ofSecond, first), region), withNeeded, first));
  }

  /// Of balls that change the topology; all where no region alone does.
  Balls neededOf(const Cells& with, const Cells& without, const Balls& removed)
  {
    Balls result;
    for (const ContradictedRegion& found : this->regions(with, without, removed))
    {
      result = unionOf(result, found.needed);
    }
    return result.empty() ? removed : result;
  }

  /// The cells that fill a region where some of its removed balls are back. The others around it have been there
  /// without those balls.
  Cells cellsWith(const Balls& back, const ChangedRegion& region) const
  {
    const Balls chosen = unionOf(difference(region.balls, region.removed), back);
    std::vector<Ball> these;
    these.reserve(chosen.size());
    for (const Index ball : chosen)
    {
      these.push_back(this->all.balls[ball]);
    }
    RegularTriangulation triangulation;
    triangulation.insert(these, this->execution);
    Cells result = renumbered(triangulation.tetrahedra().cells, chosen);
    sortCells(result);
    const auto isAround = [&](const Tetrahedron& cell) {
      return std::none_of(cell.begin(), cell.end(),
               [&](Index ball) { return std::binary_search(back.begin(), back.end(), ball); }) &&
        !std::binary_search(region.without.begin(), region.without.end(), cell);
    };
    result.erase(std::remove_if(result.begin(), result.end(), isAround), result.end());
    return result;
  }

  /// Of the simplices with inner corners in some cells, as if all space around was in one piece.
  Betti bettiOf(Cells cells)
  {
    std::vector<Index> corners;
    std::vector<char> inner;
    for (Tetrahedron& cell : cells)
    {
      for (Index& ball : cell)
      {
        Index& known = this->number[ball];
        if (known == None)
        {
          known = count(corners);
          corners.push_back(ball);
          inner.push_back(this->all.inner[ball]);
        }
        ball = known;
      }
    }
    for (const Index ball : corners)
    {
      this->number[ball] = None;
    }
    this->execution.report(0);
    return markedBetti(withNeighbors(std::move(cells)), inner);
  }

  /// On two sides of a plane across the direction in which the balls' centres spread most.
  std::array<Balls, 2> halves(Balls balls) const
  {
    Point lowest = this->all.balls[balls[0]].center, highest = lowest;
    for (const Index ball : balls)
    {
      lowest = lowest.cwiseMin(this->all.balls[ball].center);
      highest = highest.cwiseMax(this->all.balls[ball].center);
    }
    Eigen::Index axis;
    (highest - lowest).maxCoeff(&axis);
    const auto place = [&](Index ball) { return this->all.balls[ball].center[axis]; };
    std::stable_sort(
      balls.begin(), balls.end(), [&](Index a, Index b) { return place(a) < place(b); });
    const auto middle = balls.begin() + static_cast<std::ptrdiff_t>(balls.size() / 2);
    std::array<Balls, 2> result{ Balls(balls.begin(), middle), Balls(middle, balls.end()) };
    sortUnique(result[0]);
    sortUnique(result[1]);
    return result;
  }

  const LabelledBalls& all;
  const Execution& execution;
  std::vector<Index> number; ///< scratch: of each ball in some cells, or None
};
}

std::vector<ContradictedRegion> contradictedRegions(const LabelledBalls& balls,
  const std::vector<Tetrahedron>& with, const std::vector<Tetrahedron>& without,
  const std::vector<Index>& removed, const Execution& execution)
{
  return Search(balls, execution).regions(with, without, removed);
}
}
