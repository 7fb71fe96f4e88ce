// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/PowerCrust.h"

#include "Balls/MarkedBetti.h"
#include "Base/BallTree.h"
#include "Base/BettiWords.h"
#include "Base/Errors.h"
#include "Base/Frame.h"
#include "Base/Triangulations.h"
#include "Crust/ChosenBalls.h"
#include "Crust/ClearanceFilling.h"
#include "Crust/PowerDiagram.h"
#include "Crust/PuttingBack.h"
#include "Crust/Slivers.h"

#include <algorithm>
#include <limits>

namespace medial
{
namespace
{
void requireValid(
  const PolarBalls& polarBalls, const std::vector<char>& keep, const CrustOptions& options)
{
  if (!keep.empty() && keep.size() != polarBalls.balls.size())
  {
    throw InvalidInput("the axis belongs to other balls: it knows ", keep.size(), ", there are ",
      polarBalls.balls.size(), "; give the balls that the axis was made of");
  }
  if (!(polarBalls.spacing > 0))
  {
    throw InvalidInput("the balls have no sample spacing; give the output of Polar Balls");
  }
  if (!(options.clearance > 0) || options.maximumRounds < 0)
  {
    throw InvalidInput("the clearance must be larger than 0 sample spacings, and the number of "
                       "rounds not negative");
  }
}

/// Betti numbers of the power shape of the kept balls.
Betti topologyOf(const PolarBalls& polarBalls, const std::vector<char>& keep)
{
  std::vector<char> kept(polarBalls.balls.size());
  for (std::size_t b = 0; b < kept.size(); ++b)
  {
    kept[b] = polarBalls.sides[b] == Side::Inner && (keep.empty() || keep[b]);
  }
  return markedBetti(polarBalls.triangulation, kept);
}

/// Largest distance of the points that are no samples to the union of the inner balls, 0 inside.
///
/// The distance to the ball behind a triangle is an upper bound for its corners. Points are asked in
/// the order of these bounds, until no bound left is larger than the largest distance found: usually
/// few searches are made.
double largestClearance(const PowerDiagram& diagram, const BallTree& innerBalls,
  const CrustSurface& surface, const Execution& execution)
{
  std::vector<double> bound(surface.points.size(), std::numeric_limits<double>::infinity());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Ball& ball = diagram.balls[surface.innerBall[t]];
    for (const Index p : surface.triangles[t])
    {
      bound[p] = surface.sampleOfPoint[p] != None
        ? 0
        : std::min(bound[p], (surface.points[p] - ball.center).norm() - ball.radius);
    }
  }
  std::vector<Index> heap; // the largest bound first
  for (Index p = 0; p < count(bound); ++p)
  {
    bound[p] > 0 ? heap.push_back(p) : void();
  }
  const auto isLess = [&bound](Index a, Index b) { return bound[a] < bound[b]; };
  std::make_heap(heap.begin(), heap.end(), isLess);
  double largest = 0;
  while (!heap.empty() && bound[heap.front()] > largest)
  {
    execution.report(0.9);
    largest = std::max(largest, innerBalls.distance(surface.points[heap.front()], largest));
    std::pop_heap(heap.begin(), heap.end(), isLess);
    heap.pop_back();
  }
  return largest;
}

/// That the surface contradicts the axis, if it does.
Warnings topologyWarnings(
  const Crust& crust, const std::optional<Betti>& topology, const std::optional<Point>& place)
{
  if (!topology || crust.betti == *topology)
  {
    return {};
  }
  return { { "crust_topology",
    "The surface encloses a solid of " + inWords(crust.betti) + ", but its axis has " +
      inWords(*topology) + ". Prune less there, or give more samples with less noise.",
    bettiDistance(crust.betti, *topology), place } };
}

/// None where all balls are kept: then the surface goes through the samples.
SampleDistances movedSamples(const PolarBalls& polarBalls, const ChosenBalls& chosen,
  const CrustSurface& surface, const Execution& execution)
{
  return chosen.all ? SampleDistances{} : sampleDistances(polarBalls.samples, surface, execution);
}

/// Balls that were added, and those that were not.
void noteAddedBalls(const PuttingBack& back, const Filling& filling, Crust& crust)
{
  crust.putBackBalls = back.balls;
  crust.insertedBalls = filling.inserted;
  crust.refusedBalls = filling.refused;
  crust.rounds = filling.rounds;
}

/// From the diagram's frame and numbers of balls to those of `polarBalls`. Samples stay exact.
void toWorld(
  const PolarBalls& polarBalls, const Frame& frame, const std::vector<Index>& ballIds, Crust& crust)
{
  crust.volume /= frame.scale * frame.scale * frame.scale;
  for (std::size_t p = 0; p < crust.points.size(); ++p)
  {
    const Index sample = crust.sampleOfPoint[p];
    crust.points[p] = sample != None ? polarBalls.samples[sample] : frame.toWorld(crust.points[p]);
  }
  const auto original = [&ballIds](
                          Index& ball) { ball = ball < count(ballIds) ? ballIds[ball] : None; };
  std::for_each(crust.innerBall.begin(), crust.innerBall.end(), original);
  std::for_each(crust.outerBall.begin(), crust.outerBall.end(), original);
}
}

Crust powerCrust(const PolarBalls& polarBalls, const std::vector<char>& keep,
  const CrustOptions& options, const Execution& execution)
{
  requireValid(polarBalls, keep, options);
  execution.poll();
  const Frame frame = frameOf(polarBalls.samples);
  ChosenBalls chosen = chosenBalls(polarBalls, keep, options.rule, frame);
  execution.poll();
  PowerDiagram& diagram = chosen.diagram;
  const double spacing = polarBalls.spacing * frame.scale;
  RegularTriangulation triangulation;
  if (!chosen.all)
  {
    triangulation.insert(diagram.balls, execution.between(0, 0.6));
  }
  Tetrahedra mesh =
    chosen.all ? cellsOfAll(polarBalls, chosen.ids) : triangulation.tetrahedra(execution);
  const bool fills = !chosen.all && options.rule == CrustRule::Clearance;
  PuttingBack back;
  if (fills)
  {
    back.betti = markedBetti(mesh, diagram.inner);
    execution.poll();
    if (options.topology && *options.topology != back.betti)
    {
      back = putBack(*options.topology, back.betti, polarBalls, frame, chosen, triangulation,
        execution.between(0.6, 0.65));
      mesh = triangulation.tetrahedra(execution);
    }
  }
  findVertices(std::move(mesh), diagram, execution);
  execution.poll();
  const BallTree innerBalls = treeOfInnerBalls(diagram);
  execution.poll();
  Filling filling;
  if (fills)
  {
    const FillingGoal goal{ options.clearance * spacing, options.maximumRounds,
      options.topology ? *options.topology : topologyOf(polarBalls, keep) };
    execution.poll();
    const UntouchedCells untouched(polarBalls.triangulation.cells, chosen.ids);
    execution.poll();
    filling = fillClearance(goal, back.betti, untouched, innerBalls, triangulation, diagram,
      execution.between(0.65, 0.8));
  }
  triangulation = {}; // a quarter of all memory
  execution.report(0.8);
  Crust crust;
  static_cast<CrustSurface&>(crust) = crustSurface(diagram, execution);
  removeSlivers(crust, spacing, execution);
  static_cast<SolidMeasures&>(crust) = solidMeasures(crust.points, crust.triangles, execution);
  crust.warnings = topologyWarnings(crust, options.topology, back.place);
  noteAddedBalls(back, filling, crust);
  crust.maximumClearance = largestClearance(diagram, innerBalls, crust, execution) / spacing;
  toWorld(polarBalls, frame, chosen.ids, crust);
  crust.moved = movedSamples(polarBalls, chosen, crust, execution.between(0.95, 1));
  execution.report(1);
  return crust;
}
}
