// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/ClearanceFilling.h"

#include "Balls/MarkedBetti.h"
#include "Crust/ShrinkingShape.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace medial
{
std::vector<char> UntouchedCells::contain(const std::vector<Tetrahedron>& asked) const
{
  using Asked = std::pair<Tetrahedron, Index>; // corners ascending; where it is in `asked`
  std::vector<Asked> order;
  std::vector<char> isAsked; // about a cell with this corner
  for (Index i = 0; i < count(asked); ++i)
  {
    Tetrahedron cell = asked[i];
    const auto isNew = [this](Index ball) { return ball >= count(this->ids); };
    if (std::any_of(cell.begin(), cell.end(), isNew))
    {
      continue; // the ball was added by the filling
    }
    for (Index& ball : cell)
    {
      ball = this->ids[ball];
      isAsked.resize(std::max<std::size_t>(isAsked.size(), ball + 1), 0);
      isAsked[ball] = 1;
    }
    std::sort(cell.begin(), cell.end());
    order.push_back({ cell, i });
  }
  std::sort(order.begin(), order.end());
  std::vector<char> result(asked.size(), 0);
  for (Tetrahedron cell : this->cells)
  {
    if (std::all_of(cell.begin(), cell.end(),
          [&](Index ball) { return ball < count(isAsked) && isAsked[ball]; }))
    {
      std::sort(cell.begin(), cell.end());
      const auto found = std::lower_bound(order.begin(), order.end(), Asked(cell, 0));
      if (found != order.end() && found->first == cell)
      {
        result[found->second] = 1;
      }
    }
  }
  return result;
}

namespace
{
/// The distance of each power vertex on the crust to the union of the inner balls; 0 inside, for a
/// sample, and for vertices that are not on the crust. A value up to `limit` may be too large, but
/// not larger than `limit`.
std::vector<double> clearances(
  const PowerDiagram& diagram, const BallTree& innerBalls, double limit, const Execution& execution)
{
  std::vector<double> result(diagram.dual.cells.size(), 0);
  execution.forEach(count(result), [&](Index c) {
    const Tetrahedron& cell = diagram.dual.cells[c];
    if (!isMixed(diagram, cell) || diagram.sampleOfVertex[c] != None)
    {
      return;
    }
    // Mostly one of the vertex's own balls is near enough, and no search is needed.
    double least = std::numeric_limits<double>::infinity();
    for (const Index b : cell)
    {
      if (diagram.inner[b])
      {
        const Ball& ball = diagram.balls[b];
        least = std::min(least, (diagram.vertices[c] - ball.center).norm() - ball.radius);
      }
    }
    least = least > limit ? innerBalls.distance(diagram.vertices[c], limit) : least;
    result[c] = std::max(0.0, least);
  });
  return result;
}

/// Balls about the vertices with a clearance above `limit`, with the clearance as their radius.
/// Largest first; none is centred in another one, so that few balls fill much.
std::vector<Ball> fillingBalls(
  const PowerDiagram& diagram, const std::vector<double>& clearances, double limit)
{
  std::vector<Index> order;
  for (Index c = 0; c < count(clearances); ++c)
  {
    if (clearances[c] > limit)
    {
      order.push_back(c);
    }
  }
  std::stable_sort(
    order.begin(), order.end(), [&](Index a, Index b) { return clearances[a] > clearances[b]; });
  constexpr std::size_t roundLimit = 5000; // each is compared with all of its round
  std::vector<Ball> result;
  for (const Index c : order)
  {
    if (result.size() == roundLimit)
    {
      break;
    }
    const Point& center = diagram.vertices[c];
    if (std::none_of(result.begin(), result.end(),
          [&](const Ball& ball) { return (center - ball.center).norm() < ball.radius; }))
    {
      result.push_back({ center, clearances[c] });
    }
  }
  return result;
}

class ClearanceFilling
{
public:
  ClearanceFilling(const FillingGoal& fillingGoal, const Betti& now,
    RegularTriangulation& regularTriangulation, PowerDiagram& powerDiagram,
    const Execution& ofRounds)
    : goal(fillingGoal)
    , triangulation(regularTriangulation)
    , diagram(powerDiagram)
    , execution(ofRounds)
    , defect(bettiDistance(now, fillingGoal.topology))
  {
  }

  Filling fill(const UntouchedCells& untouched, const BallTree& innerBalls)
  {
    for (bool changed = true; changed && this->filling.rounds < this->goal.maximumRounds;)
    {
      const std::vector<Ball> balls = this->missingBalls(untouched, innerBalls);
      this->filling.refused = 0;
      const Index before = this->filling.inserted;
      this->insert(balls);
      changed = this->filling.inserted > before;
      if (changed)
      {
        const std::vector<Index> numbersBefore = this->triangulation.numbersBefore();
        findVertices(this->triangulation.tetrahedra(this->execution), this->diagram,
          this->execution, numbersBefore);
        ++this->filling.rounds;
      }
    }
    return this->filling;
  }

private:
  std::vector<Ball> missingBalls(const UntouchedCells& untouched, const BallTree& innerBalls) const
  {
    const double limit = this->goal.clearance;
    std::vector<double> distances = clearances(this->diagram, innerBalls, limit, this->execution);
    std::vector<Index> far;
    std::vector<Tetrahedron> cells;
    for (Index c = 0; c < count(distances); ++c)
    {
      if (distances[c] > limit)
      {
        far.push_back(c);
        cells.push_back(this->diagram.dual.cells[c]);
      }
    }
    // What was as far away before pruning is the surface of the whole solid: a sharp corner of a
    // box is far from every ball, and is to stay.
    const std::vector<char> stays = untouched.contain(cells);
    for (Index i = 0; i < count(far); ++i)
    {
      distances[far[i]] = stays[i] ? 0 : distances[far[i]];
    }
    return fillingBalls(this->diagram, distances, limit);
  }

  /// Inserts the balls that keep the topology. Where it isn't the one wanted yet, tries the others, too.
  void insert(const std::vector<Ball>& balls)
  {
    std::vector<Ball> others;
    for (const Ball& ball : balls)
    {
      this->execution.poll();
      if (shrinksByCollapses(this->triangulation.replacedBy(ball), this->diagram.inner))
      {
        this->triangulation.insert({ ball });
        this->add({ ball });
      }
      else
      {
        others.push_back(ball);
      }
    }
    if (this->defect > 0)
    {
      this->insertIfBetter(others);
    }
    else
    {
      this->filling.refused += count(others);
    }
  }

  /// Inserts all the balls if that brings the topology nearer to the one wanted. Else tries the halves of
  /// the list, one after the other, and so on down to single balls.
  void insertIfBetter(const std::vector<Ball>& balls)
  {
    if (balls.empty())
    {
      return;
    }
    RegularTriangulation trial = this->triangulation.copy();
    trial.insert(balls, this->execution);
    std::vector<char> inner = this->diagram.inner;
    inner.resize(inner.size() + balls.size(), 0);
    const Index trialDefect =
      bettiDistance(markedBetti(trial.tetrahedra(this->execution), inner), this->goal.topology);
    if (trialDefect <= this->defect)
    {
      this->defect = trialDefect;
      this->triangulation = std::move(trial);
      this->add(balls);
    }
    else if (balls.size() == 1)
    {
      ++this->filling.refused;
    }
    else
    {
      const auto middle = balls.begin() + static_cast<std::ptrdiff_t>(balls.size() / 2);
      this->insertIfBetter({ balls.begin(), middle });
      this->insertIfBetter({ middle, balls.end() });
    }
  }

  /// Adds to the diagram what the triangulation has already.
  void add(const std::vector<Ball>& balls)
  {
    this->filling.inserted += count(balls);
    for (const Ball& ball : balls)
    {
      this->diagram.balls.push_back(ball);
      this->diagram.inner.push_back(0);
      this->diagram.samples.close(); // it has none
    }
  }

  const FillingGoal& goal;
  RegularTriangulation& triangulation;
  PowerDiagram& diagram;
  const Execution& execution;
  Index defect; ///< by how much the Betti numbers miss the goal's
  Filling filling;
};
}

Filling fillClearance(const FillingGoal& goal, const Betti& now, const UntouchedCells& untouched,
  const BallTree& innerBalls, RegularTriangulation& triangulation, PowerDiagram& diagram,
  const Execution& execution)
{
  return ClearanceFilling(goal, now, triangulation, diagram, execution).fill(untouched, innerBalls);
}
}
