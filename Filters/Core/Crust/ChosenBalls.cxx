// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/ChosenBalls.h"

#include "Base/Errors.h"
#include "Base/Triangulations.h"

#include <algorithm>

namespace medial
{
namespace
{
/// For each ball: is it the outer ball of a sample whose inner ball is removed? Balls that touch the
/// guard don't count: they bound the space around the solid and always stay.
std::vector<char> outerBallsOfRemoved(const PolarBalls& polarBalls, const std::vector<char>& keep)
{
  std::vector<char> result(polarBalls.balls.size(), 0);
  for (std::size_t s = 0; s < polarBalls.samples.size(); ++s)
  {
    const Index inner = polarBalls.innerBall[s], outer = polarBalls.outerBall[s];
    if (inner != None && outer != None && !keep[inner] && !polarBalls.touchesGuard[outer])
    {
      result[outer] = 1;
    }
  }
  return result;
}
}

ChosenBalls chosenBalls(
  const PolarBalls& polarBalls, const std::vector<char>& keep, CrustRule rule, const Frame& frame)
{
  std::vector<char> dropped(polarBalls.balls.size(), 0);
  if (rule == CrustRule::InnerAndOuter && !keep.empty())
  {
    dropped = outerBallsOfRemoved(polarBalls, keep);
  }
  ChosenBalls result{ {}, {}, true };
  PowerDiagram& diagram = result.diagram;
  for (Index b = 0; b < count(polarBalls.balls); ++b)
  {
    if (polarBalls.sides[b] == Side::Hidden)
    {
      continue;
    }
    const bool inner = polarBalls.sides[b] == Side::Inner;
    const bool removed = inner ? !keep.empty() && !keep[b] : dropped[b] != 0;
    if (removed)
    {
      result.all = false;
      continue;
    }
    result.ids.push_back(b);
    // With the same change of the radius as in the triangulation of Polar Balls, since the power
    // vertices belong to the cells that were found with it.
    diagram.balls.push_back(jittered(frame.toLocal(polarBalls.balls[b]), b));
    diagram.inner.push_back(inner);
    diagram.samples.append(polarBalls.ballSamples[b]);
  }
  if (std::find(diagram.inner.begin(), diagram.inner.end(), 1) == diagram.inner.end())
  {
    throw InvalidInput(
      "no inner ball is left, so there is no surface: prune less, and give the axis "
      "that was made of these balls");
  }
  for (const Point& sample : polarBalls.samples)
  {
    diagram.positions.push_back(frame.toLocal(sample));
  }
  return result;
}

Tetrahedra cellsOfAll(const PolarBalls& polarBalls, const std::vector<Index>& ids)
{
  std::vector<Index> number(polarBalls.balls.size(), None);
  for (Index i = 0; i < count(ids); ++i)
  {
    number[ids[i]] = i;
  }
  return { renumbered(polarBalls.triangulation.cells, number), polarBalls.triangulation.neighbors };
}
}
