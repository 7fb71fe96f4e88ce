// SPDX-License-Identifier: BSD-3-Clause
#include "Pruning/PruneRound.h"

#include <algorithm>
#include <limits>

namespace medial
{
namespace
{
/// The contacts that are curves.
std::vector<ContactCurve> contactCurves(const LivingCells& living, const Partition& partition)
{
  std::vector<ContactCurve> result = contacts(living, partition);
  const auto isPoint = [](const ContactCurve& contact) { return contact.points.size() == 1; };
  result.erase(std::remove_if(result.begin(), result.end(), isPoint), result.end());
  return result;
}
}

std::vector<Index> candidates(const PruneRound& round, double threshold, int dimension)
{
  std::vector<Index> result;
  for (Index part = 0; part < count(round.significance); ++part)
  {
    if (round.partition->level[part] == 1 && round.partition->dimension[part] <= dimension &&
      round.significance[part] <= threshold)
    {
      result.push_back(part);
    }
  }
  std::stable_sort(result.begin(), result.end(),
    [&](Index a, Index b) { return round.significance[a] < round.significance[b]; });
  return result;
}

std::vector<Index> cellsOf(const PruneRound& round, const std::vector<Index>& parts)
{
  std::vector<Index> cells;
  for (const Index part : parts)
  {
    const IndexLists::View own = round.partition->cells[part];
    cells.insert(cells.end(), own.begin(), own.end());
  }
  return cells;
}

PruneRounds::PruneRounds(LivingCells& livingCells, const PartMeasures& partMeasures,
  const PruneOptions& pruneOptions, const Execution& roundExecution)
  : living(livingCells)
  , measures(partMeasures)
  , options(pruneOptions)
  , execution(roundExecution)
  , visitedIn(partMeasures.axis.points.size(), 0)
  , metIn(livingCells.cells.size(), 0)
{
}

PruneRound PruneRounds::next(Measure measure)
{
  if (!this->current)
  {
    // Only parts of level 1 can go, so the inner levels are not needed yet.
    this->current = std::make_shared<Partition>(partition(this->living, 1, this->execution));
    this->measured.reset();
  }
  if (this->measured != measure)
  {
    this->significance = this->measures.significance(measure, *this->current, this->execution);
    this->measured = measure;
    for (Index part = 0; part < count(this->significance); ++part)
    {
      if (this->current->dimension[part] < 2 && !traitsOf(measure).tellsOfCurves)
      {
        this->significance[part] = std::numeric_limits<double>::infinity();
      }
    }
  }
  PruneRound round;
  round.partition = this->current;
  round.measure = measure;
  round.significance = this->significance;
  this->addInheritance(round);
  round.gone.assign(round.significance.size(), 0);
  round.isProtected.assign(round.significance.size(), 0);
  for (const Index cell : this->options.cellsToProtect)
  {
    round.isProtected[round.partition->partOfCell[cell]] = 1;
  }
  if (this->options.topology == Topology::PaperGraph)
  {
    round.contacts = contactCurves(this->living, *round.partition);
  }
  round.knownNeighbors.resize(round.significance.size());
  return round;
}

void PruneRounds::addInheritance(PruneRound& round) const
{
  // Part numbers change from round to round, so an heir is known by a cell. If the heir itself was
  // removed, it has passed on all it had.
  for (const auto& [cell, amount] : this->inherited)
  {
    if (this->living.isLiving(cell))
    {
      double& value = round.significance[round.partition->partOfCell[cell]];
      value = together(round.measure, value, amount);
    }
  }
}

void PruneRounds::remove(
  PruneRound& round, const std::vector<Index>& parts, const std::vector<Index>& cells)
{
  this->living.remove(cells);
  this->current.reset();
  for (const Index part : parts)
  {
    round.gone[part] = 1;
  }
}

void PruneRounds::inherit(PruneRound& round, const std::vector<Index>& removed)
{
  double sum = 0;
  Index heir = None;
  for (const Index part : removed)
  {
    sum = together(round.measure, sum, round.significance[part]);
    for (const Index neighbor : this->neighbors(round, part))
    {
      if (!round.gone[neighbor] &&
        (heir == None || round.significance[neighbor] > round.significance[heir]))
      {
        heir = neighbor;
      }
    }
  }
  if (heir != None)
  {
    double& kept = this->inherited[round.partition->cells[heir][0]];
    round.significance[heir] = together(round.measure, round.significance[heir], sum);
    kept = together(round.measure, kept, sum);
  }
}

const std::vector<Index>& PruneRounds::neighbors(const PruneRound& round, Index part)
{
  if (round.knownNeighbors[part])
  {
    return *round.knownNeighbors[part];
  }
  std::vector<Index>& result = round.knownNeighbors[part].emplace();
  ++this->walks;
  const auto visit = [&](Index p) {
    for (const Index other : this->living.cellsOfPoint()[p])
    {
      const Index neighbor = round.partition->partOfCell[other];
      if (neighbor != None && neighbor != part && this->metIn[neighbor] != this->walks)
      {
        this->metIn[neighbor] = this->walks;
        result.push_back(neighbor);
      }
    }
  };
  for (const Index cell : round.partition->cells[part])
  {
    forPoints(this->living.cells, cell, [&](Index p) {
      if (this->visitedIn[p] != this->walks && this->living.cellsAtPoint(p) > 0)
      {
        this->visitedIn[p] = this->walks;
        visit(p);
      }
    });
  }
  std::sort(result.begin(), result.end());
  return result;
}

void PruneRounds::findAllLevels()
{
  medial::findAllLevels(this->living, *this->current);
}
}
