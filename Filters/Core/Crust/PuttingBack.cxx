// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/PuttingBack.h"

#include "Balls/MarkedBetti.h"
#include "Base/Lists.h"
#include "Crust/NeededBalls.h"

#include <algorithm>

namespace medial
{
namespace
{
using Regions = std::vector<ContradictedRegion>;

/// All balls, in the frame of the chosen ones and as they are in triangulations.
LabelledBalls labelledBalls(const PolarBalls& polarBalls, const Frame& frame)
{
  LabelledBalls result;
  for (Index b = 0; b < count(polarBalls.balls); ++b)
  {
    result.balls.push_back(jittered(frame.toLocal(polarBalls.balls[b]), b));
    result.inner.push_back(polarBalls.sides[b] == Side::Inner);
  }
  return result;
}

/// The inner balls that were not chosen, ascending.
std::vector<Index> removedBalls(const PolarBalls& polarBalls, const ChosenBalls& chosen)
{
  std::vector<Index> result;
  for (Index b = 0; b < count(polarBalls.balls); ++b)
  {
    if (polarBalls.sides[b] == Side::Inner &&
      !std::binary_search(chosen.ids.begin(), chosen.ids.end(), b))
    {
      result.push_back(b);
    }
  }
  return result;
}

class Attempts
{
public:
  Attempts(const Betti& wanted, const LabelledBalls& labelledBalls, const IndexLists& samplesOfBall,
    ChosenBalls& chosenBalls, RegularTriangulation& regularTriangulation, const Betti& now,
    const Execution& ofAttempts)
    : topology(wanted)
    , all(labelledBalls)
    , samples(samplesOfBall)
    , chosen(chosenBalls)
    , triangulation(regularTriangulation)
    , betti(now)
    , execution(ofAttempts)
  {
  }

  Betti bettiNow() const { return this->betti; }

  /// Puts the needed balls of regions back if all contradictions are gone then. If not, tries the
  /// halves of the list, and so on down to single regions, which have only to do good: a
  /// region may be contradicted because pruning was to change it.
  void attempt(const Regions& regions)
  {
    constexpr int attemptLimit = 100; // else hundreds of triangulations for a hopeless case
    if (regions.empty() || this->defect(this->betti) == 0 || ++this->attempts > attemptLimit)
    {
      return;
    }
    if (this->tryAll(regions) || regions.size() == 1)
    {
      return;
    }
    const auto middle = regions.begin() + static_cast<std::ptrdiff_t>(regions.size() / 2);
    this->attempt({ regions.begin(), middle });
    this->attempt({ middle, regions.end() });
  }

private:
  Index defect(const Betti& now) const { return bettiDistance(now, this->topology); }

  /// @return  were the balls put back?
  bool tryAll(const Regions& regions)
  {
    std::vector<Index> ids;
    for (const ContradictedRegion& region : regions)
    {
      ids.insert(ids.end(), region.needed.begin(), region.needed.end());
    }
    std::vector<Ball> balls;
    balls.reserve(ids.size());
    for (const Index id : ids)
    {
      balls.push_back(this->all.balls[id]);
    }
    RegularTriangulation trial = this->triangulation.copy();
    trial.insert(balls, this->execution);
    std::vector<char> inner = this->chosen.diagram.inner;
    inner.resize(inner.size() + balls.size(), 1);
    const Betti then = markedBetti(trial.tetrahedra(), inner);
    if (this->defect(then) > (regions.size() == 1 ? this->defect(this->betti) - 1 : 0))
    {
      return false;
    }
    this->betti = then;
    this->triangulation = std::move(trial);
    PowerDiagram& diagram = this->chosen.diagram;
    diagram.inner = std::move(inner);
    diagram.balls.insert(diagram.balls.end(), balls.begin(), balls.end());
    for (const Index id : ids)
    {
      this->chosen.ids.push_back(id);
      diagram.samples.append(this->samples[id]);
    }
    return true;
  }

  const Betti& topology;
  const LabelledBalls& all;
  const IndexLists& samples;
  ChosenBalls& chosen;
  RegularTriangulation& triangulation;
  Betti betti;
  const Execution& execution;
  int attempts = 0;
};

/// The first removed ball of a region of which none was put back.
std::optional<Point> placeLeft(
  const Regions& regions, const PolarBalls& polarBalls, const ChosenBalls& chosen)
{
  for (const ContradictedRegion& region : regions)
  {
    if (std::find(chosen.ids.begin(), chosen.ids.end(), region.needed.front()) == chosen.ids.end())
    {
      return polarBalls.balls[region.needed.front()].center;
    }
  }
  return std::nullopt;
}
}

PuttingBack putBack(const Betti& topology, const Betti& now, const PolarBalls& polarBalls,
  const Frame& frame, ChosenBalls& chosen, RegularTriangulation& triangulation,
  const Execution& execution)
{
  const Index before = count(chosen.ids);
  const LabelledBalls all = labelledBalls(polarBalls, frame);
  const Regions regions = contradictedRegions(all, polarBalls.triangulation.cells,
    renumbered(triangulation.tetrahedra().cells, chosen.ids), removedBalls(polarBalls, chosen),
    execution);
  Attempts attempts(topology, all, polarBalls.ballSamples, chosen, triangulation, now, execution);
  attempts.attempt(regions);
  PuttingBack result{ count(chosen.ids) - before, attempts.bettiNow(), std::nullopt };
  if (result.betti != topology)
  {
    result.place = placeLeft(regions, polarBalls, chosen);
  }
  return result;
}
}
