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

/// The regular triangulation of some balls.
struct Cells
{
  std::vector<Tetrahedron> cells;
  Betti betti; ///< of the simplices with inner corners
};

class Search
{
public:
  Search(const LabelledBalls& labelledBalls, const Execution& ofSearch)
    : all(labelledBalls)
    , execution(ofSearch)
  {
  }

  std::vector<ContradictedRegion> regions(const std::vector<Tetrahedron>& with,
    const std::vector<Tetrahedron>& without, const Balls& removed) const
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
  Balls neededIn(const ChangedRegion& region) const
  {
    const Balls kept = difference(region.balls, region.removed);
    const Cells with = this->cellsOf(region.balls), without = this->cellsOf(kept);
    if (with.betti == without.betti || region.removed.size() == 1)
    {
      return with.betti == without.betti ? Balls{} : region.removed;
    }
    const auto [first, second] = this->halves(region.removed);
    const Cells withFirst = this->cellsOf(unionOf(kept, first));
    if (withFirst.betti == with.betti)
    {
      return this->neededOf(withFirst, without, first);
    }
    const Cells withSecond = this->cellsOf(unionOf(kept, second));
    if (withSecond.betti == with.betti)
    {
      return this->neededOf(withSecond, without, second);
    }
    const Balls ofSecond = this->neededOf(with, withFirst, second);
    const Balls keptNow = unionOf(kept, ofSecond);
    const Cells withNeeded = this->cellsOf(keptNow);
    return withNeeded.betti == with.betti
      ? ofSecond
      : unionOf(
          ofSecond, this->neededOf(this->cellsOf(unionOf(keptNow, first)), withNeeded, first));
  }

  /// Of balls that change the topology; all where no region alone does.
  Balls neededOf(const Cells& with, const Cells& without, const Balls& removed) const
  {
    Balls result;
    for (const ContradictedRegion& found : this->regions(with.cells, without.cells, removed))
    {
      result = unionOf(result, found.needed);
    }
    return result.empty() ? removed : result;
  }

  Cells cellsOf(const Balls& chosen) const
  {
    LabelledBalls these;
    for (const Index ball : chosen)
    {
      these.balls.push_back(this->all.balls[ball]);
      these.inner.push_back(this->all.inner[ball]);
    }
    RegularTriangulation triangulation;
    triangulation.insert(these.balls);
    const Tetrahedra mesh = triangulation.tetrahedra();
    return { renumbered(mesh.cells, chosen), markedBetti(mesh, these.inner) };
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
};
}

std::vector<ContradictedRegion> contradictedRegions(const LabelledBalls& balls,
  const std::vector<Tetrahedron>& with, const std::vector<Tetrahedron>& without,
  const std::vector<Index>& removed, const Execution& execution)
{
  return Search(balls, execution).regions(with, without, removed);
}
}
