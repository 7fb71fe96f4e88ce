// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/MedialAxis.h"

#include "Axis/AxisBetti.h"
#include "Axis/Carving.h"
#include "Axis/DualComplex.h"
#include "Axis/Erosion.h"
#include "Axis/GapFilling.h"
#include "Axis/PieceRepair.h"
#include "Axis/RimTrimming.h"
#include "Axis/ShapeCollapse.h"
#include "Axis/SingularPoints.h"
#include "Axis/SiteTriangulation.h"
#include "Balls/PowerShape.h"
#include "Base/Frame.h"
#include "Base/Lists.h"
#include "Base/Neighbors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace medial
{
namespace
{
/// How deep candidates must be, in the order tried: the first that gives the right topology
/// counts. Smaller values may close gaps that are in the solid, larger ones open gaps that are not.
constexpr double kappas[] = { 0.2, 0.1, 0.05, 0, 0.3, 0.5, 0.8 };

/// An axis of which nothing else is known yet.
MedialAxis axisOf(AxisComplex complex)
{
  MedialAxis axis{};
  static_cast<AxisComplex&>(axis) = std::move(complex);
  return axis;
}

/// Makes the axis from the singular points.
class SiteAxes
{
public:
  SiteAxes(const PolarBalls& balls, const PowerShape& powerShape, const Execution& outer)
    : polarBalls(balls)
    , shape(powerShape)
    , execution(outer)
    , frame(frameOf(balls.samples))
    , points(singularPoints(balls, powerShape, outer.between(0, 0.1)))
    , sites(siteTriangulation(balls, powerShape, points, frame, outer.between(0.1, 0.7)))
  {
  }

  /// The axis whose Betti numbers are the shape's, or come nearest.
  MedialAxis best() const
  {
    std::optional<MedialAxis> result;
    for (const double kappa : kappas)
    {
      this->execution.poll();
      OpenSet set = insideCells(this->sites, kappa);
      if (bettiNumbers(this->sites, set) == this->shape.betti)
      {
        takeBetter(this->carved(std::move(set), kappa), result);
      }
      if (isRight(result))
      {
        return *result;
      }
    }
    takeBetter(this->withFilledGaps(), result);
    return *result;
  }

private:
  bool isRight(const std::optional<MedialAxis>& axis) const
  {
    return axis && axis->betti == this->shape.betti;
  }

  /// The axis of the first choice of candidates, with the gaps in it filled.
  MedialAxis withFilledGaps() const
  {
    const std::vector<Index> pieces = piecesOfBalls(this->polarBalls);
    OpenSet set = insideCells(this->sites, kappas[0]);
    const FilledGaps gaps = fillGaps(this->sites, pieces, this->shape.betti, set, this->execution);
    MedialAxis axis = this->carved(std::move(set), kappas[0]);
    axis.filledGaps = gaps.places;
    return axis;
  }

  /// The axis of a set of cells. Carving keeps the topology.
  MedialAxis carved(OpenSet set, double kappa) const
  {
    carve(this->sites, set, this->execution.between(0.7, 0.9));
    MedialAxis axis = axisOf(
      dualComplex(this->polarBalls, this->points, this->sites, set, this->frame, this->execution));
    axis.kappa = kappa;
    axis.betti = bettiNumbers(axis.cells);
    return axis;
  }

  void takeBetter(MedialAxis axis, std::optional<MedialAxis>& best) const
  {
    if (!best ||
      bettiDistance(axis.betti, this->shape.betti) < bettiDistance(best->betti, this->shape.betti))
    {
      best = std::move(axis);
    }
  }

  const PolarBalls& polarBalls;
  const PowerShape& shape;
  const Execution execution;
  const Frame frame;
  const SingularPoints points;
  const SiteTriangulation sites;
};

/// The inner balls that share a sample with each of some inner balls.
IndexLists neighbors(const PolarBalls& polarBalls, const std::vector<Index>& innerBalls)
{
  const std::vector<std::vector<Index>> ballsOfSample = innerBallsOfSamples(polarBalls);
  IndexLists result;
  std::vector<Index> near;
  for (const Index ball : innerBalls)
  {
    near.clear();
    for (const Index s : polarBalls.ballSamples[ball])
    {
      near.insert(near.end(), ballsOfSample[s].begin(), ballsOfSample[s].end());
    }
    sortUnique(near);
    result.append(near);
  }
  return result;
}

/// The inner balls next to each of some in the power diagram.
IndexLists adjacent(const PolarBalls& polarBalls, const std::vector<Index>& innerBalls)
{
  std::vector<Index> place(polarBalls.balls.size(), None);
  for (Index i = 0; i < count(innerBalls); ++i)
  {
    place[innerBalls[i]] = i;
  }
  return listsByKey(count(innerBalls), [&](const auto& add) {
    for (const Tetrahedron& cell : polarBalls.triangulation.cells)
    {
      for (const Index a : cell)
      {
        for (const Index b : cell)
        {
          if (place[a] != None && a != b && polarBalls.sides[b] == Side::Inner)
          {
            add(place[a], b);
          }
        }
      }
    }
  });
}

/// The inner balls that have no owner yet.
std::vector<Index> unowned(const PolarBalls& polarBalls, const std::vector<Index>& owner)
{
  std::vector<Index> result;
  for (Index b = 0; b < count(owner); ++b)
  {
    if (owner[b] == None && polarBalls.sides[b] == Side::Inner)
    {
      result.push_back(b);
    }
  }
  return result;
}

/// Gives balls the owner of that ball around them which they intersect most deeply, as far as owners reach; those far
/// off take several rounds.
void spreadOwners(const PolarBalls& polarBalls, const std::vector<Index>& todo,
  const IndexLists& around, std::vector<Index>& owner, const Execution& execution)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    execution.poll();
    const std::vector<Index> before = owner;
    for (Index i = 0; i < count(todo); ++i)
    {
      double deepest = -std::numeric_limits<double>::infinity();
      for (const Index n : around[i])
      {
        const double d = intersectionDepth(polarBalls.balls[todo[i]], polarBalls.balls[n]);
        if (before[todo[i]] == None && before[n] != None && d > deepest)
        {
          deepest = d;
          owner[todo[i]] = before[n];
          changed = true;
        }
      }
    }
  }
}

/// Each ball on the axis owns itself; an inner ball off it belongs to one that shares a sample with it and has an
/// owner. Where samples are regular, balls share none: these belong to one next to them in the power diagram.
std::vector<Index> owners(
  const PolarBalls& polarBalls, const std::vector<Index>& ballOfPoint, const Execution& execution)
{
  std::vector<Index> owner(polarBalls.balls.size(), None);
  for (const Index b : ballOfPoint)
  {
    if (b != None)
    {
      owner[b] = b;
    }
  }
  std::vector<Index> todo = unowned(polarBalls, owner);
  spreadOwners(polarBalls, todo, neighbors(polarBalls, todo), owner, execution);
  todo = unowned(polarBalls, owner);
  if (!todo.empty())
  {
    spreadOwners(polarBalls, todo, adjacent(polarBalls, todo), owner, execution);
  }
  return owner;
}

/// How far samples are apart at each cell: at its sites, or else at the samples nearest to its corners, which the maximal
/// balls there touch; the smallest.
std::vector<double> spacingsAtCells(
  const AxisComplex& axis, const PolarBalls& polarBalls, const Execution& execution)
{
  const Neighbors neighbors(polarBalls.samples);
  const std::vector<double> spacings = meanDistances(polarBalls.samples, neighbors, execution);
  std::vector<double> result(axis.cells.size(), std::numeric_limits<double>::infinity());
  execution.forEach(axis.cells.size(), [&](Index c) {
    const auto take = [&](Index sample) {
      result[c] = sample == None ? result[c] : std::min(result[c], spacings[sample]);
    };
    std::for_each(axis.samplesOfCell[c].begin(), axis.samplesOfCell[c].end(), take);
    if (std::isinf(result[c]))
    {
      forPoints(
        axis.cells, c, [&](Index p) { take(neighbors.nearest(axis.points[p], 1).front()); });
    }
  });
  return result;
}
}

MedialAxis withCells(MedialAxis axis, const std::vector<Index>& cells, const Betti& betti)
{
  // In place: what stays moves down.
  const auto keep = [&cells](auto& values, Index begin, Index end) {
    Index next = 0;
    for (auto cell = std::lower_bound(cells.begin(), cells.end(), begin);
         cell != cells.end() && *cell < end; ++cell)
    {
      values[next++] = values[*cell - begin];
    }
    values.resize(next);
  };
  const Index firstEdge = axis.cells.firstEdge(), firstTriangle = axis.cells.firstTriangle();
  const Index end = axis.cells.size();
  keep(axis.polygonOfCell, 0, end);
  keep(axis.samplesOfCell, 0, end);
  keep(axis.siteViews, 0, end);
  keep(axis.cellErosion, 0, end);
  keep(axis.cells.vertices, 0, firstEdge);
  keep(axis.cells.edges, firstEdge, firstTriangle);
  keep(axis.cells.triangles, firstTriangle, end);
  axis.betti = betti;
  axis.certificate = betti == axis.powerShapeBetti;
  return axis;
}

MedialAxis medialAxis(
  const PolarBalls& polarBalls, const AxisOptions& options, const Execution& execution)
{
  if (std::find(polarBalls.sides.begin(), polarBalls.sides.end(), Side::Inner) ==
    polarBalls.sides.end())
  {
    throw InvalidInput(
      "no ball is inside the solid: the samples don't enclose one, or there are too "
      "few of them to tell");
  }
  if (!(options.trim >= 0))
  {
    throw InvalidInput("the trim must be 0 or more, it is ", options.trim);
  }
  const PowerShape shape = powerShape(polarBalls, execution.between(0, 0.1));
  MedialAxis axis = SiteAxes(polarBalls, shape, execution.between(0.1, 0.9)).best();
  if (axis.betti != shape.betti && options.fallback == AxisFallback::Collapse)
  {
    const AxisComplex exact = collapsedShape(polarBalls, execution);
    axis = axisOf(repairedPieces(axis, exact, piecesOfBalls(polarBalls)));
    axis.betti = bettiNumbers(axis.cells);
    axis.fallback = true;
    axis.kappa = -1;
    axis.filledGaps = 0;
  }
  Erosion thickness = erosion(axis, execution);
  if (options.trim > 0)
  {
    static_cast<AxisComplex&>(axis) = trimmedRims(
      axis, thickness, spacingsAtCells(axis, polarBalls, execution), options.trim, execution);
    axis.betti = bettiNumbers(axis.cells);
    thickness = erosion(axis, execution);
  }
  axis.sampleDiagonal = boundingBox(polarBalls.samples).diagonal().norm();
  axis.sampleSpacing = polarBalls.spacing;
  axis.powerShapeBetti = shape.betti;
  axis.certificate = axis.betti == shape.betti;
  axis.ballOwner = owners(polarBalls, axis.ballOfPoint, execution);
  axis.ballVolumes = polarBalls.volumes;
  axis.poleVolumes = polarBalls.poleVolumes;
  axis.erosion = std::move(thickness.ofPoint);
  axis.cellErosion = std::move(thickness.ofCell);
  execution.report(1);
  return axis;
}
}
