// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/Measures.h"

#include "Base/BallTree.h"
#include "Parts/BallShares.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace medial
{
namespace
{
using Values = std::vector<double>;

/// For each part fold(value, cell) over its cells, from 0.
template <typename Fold>
Values overCells(const Partition& partition, const Fold& fold)
{
  Values result(partition.cells.size(), 0);
  for (Index part = 0; part < count(result); ++part)
  {
    for (const Index cell : partition.cells[part])
    {
      result[part] = fold(result[part], cell);
    }
  }
  return result;
}

/// For each part the largest value(cell) of its cells.
template <typename Value>
Values largestOfCells(const Partition& partition, const Value& value)
{
  return overCells(
    partition, [&value](double most, Index cell) { return std::max(most, value(cell)); });
}

/// Calls body(part, point) for each point of each part once. Notes for each point the last part that met
/// it, so that no set is needed: linear in the number of cells.
template <typename Body>
void forEachPoint(const MedialAxis& axis, const Partition& partition, const Body& body)
{
  std::vector<Index> last(axis.points.size(), None);
  for (Index part = 0; part < partition.cells.size(); ++part)
  {
    for (const Index cell : partition.cells[part])
    {
      forPoints(axis.cells, cell, [&](Index p) {
        if (last[p] != part)
        {
          last[p] = part;
          body(part, p);
        }
      });
    }
  }
}

Values sizesOfCells(const MedialAxis& axis)
{
  const std::vector<Point>& points = axis.points;
  Values sizes(axis.cells.vertices.size(), 1);
  sizes.reserve(axis.cells.size());
  for (const Edge& edge : axis.cells.edges)
  {
    sizes.push_back((points[edge[1]] - points[edge[0]]).norm());
  }
  for (const Triangle& t : axis.cells.triangles)
  {
    sizes.push_back(triangleArea(axis, t));
  }
  return sizes;
}

Values triangleCounts(const PartMeasures&, const Partition& partition, const Execution&)
{
  return overCells(partition, [](double sum, Index) { return sum + 1; });
}

Values areas(const PartMeasures& measures, const Partition& partition, const Execution&)
{
  const Index firstTriangle = measures.axis.cells.firstTriangle();
  return overCells(partition, [&](double sum, Index cell) {
    return cell < firstTriangle ? sum : sum + measures.sizes[cell];
  });
}

Values relativeVolumes(
  const PartMeasures& measures, const Partition& partition, const Execution& execution)
{
  const MedialAxis& axis = measures.axis;
  Values result(partition.cells.size(), 0), owned(axis.ballOwner.size(), 0);
  for (Index b = 0; b < count(owned); ++b)
  {
    if (axis.ballOwner[b] != None && measures.solidVolume > 0)
    {
      owned[axis.ballOwner[b]] += axis.ballVolumes[b] / measures.solidVolume;
    }
  }
  const Lists<BallShare> shares = ballShares(
    axis, partition.partOfCell, areas(measures, partition, execution), measures.cellsOfPoint);
  for (Index b = 0; b < count(owned); ++b)
  {
    for (const BallShare& held : shares[b])
    {
      result[held.part] += owned[b] * held.share;
    }
  }
  return result;
}

Values relativePoleVolumes(
  const PartMeasures& measures, const Partition& partition, const Execution&)
{
  const MedialAxis& axis = measures.axis;
  Values result(partition.cells.size(), 0);
  std::vector<Index> last(
    axis.poleVolumes.size(), None); // a ball can be at several points of a part
  forEachPoint(axis, partition, [&](Index part, Index p) {
    const Index ball = axis.ballOfPoint[p];
    if (ball != None && last[ball] != part && measures.solidVolume > 0)
    {
      last[ball] = part;
      result[part] += axis.poleVolumes[ball] / measures.solidVolume;
    }
  });
  return result;
}

/// Adds up from the lowest point to the highest, so that the order of the cells doesn't matter.
Values meanRadii(const PartMeasures& measures, const Partition& partition, const Execution&)
{
  Values result(partition.cells.size(), 0), counts(result);
  forEachPoint(measures.axis, partition, [&counts](Index part, Index) { ++counts[part]; });
  std::vector<Index> parts;
  for (Index p = 0; p < measures.cellsOfPoint.size(); ++p)
  {
    distinctPartsOf(measures.cellsOfPoint[p], partition.partOfCell, parts);
    for (const Index part : parts)
    {
      result[part] += measures.axis.radii[p] / counts[part];
    }
  }
  return result;
}

Values maximumRadii(const PartMeasures& measures, const Partition& partition, const Execution&)
{
  return overCells(partition, [&](double most, Index cell) {
    forPoints(
      measures.axis.cells, cell, [&](Index p) { most = std::max(most, measures.axis.radii[p]); });
    return most;
  });
}

Values objectAngles(const PartMeasures& measures, const Partition& partition, const Execution&)
{
  Values means = overCells(partition, [&](double sum, Index cell) {
    return sum + measures.sizes[cell] * measures.axis.siteViews[cell].objectAngle;
  });
  const Values sums =
    overCells(partition, [&](double sum, Index cell) { return sum + measures.sizes[cell]; });
  // A part without a size, of flat triangles alone, sees nothing.
  std::transform(means.begin(), means.end(), sums.begin(), means.begin(),
    [](double mean, double sum) { return sum > 0 ? mean / sum : 0; });
  return means;
}

Values lambdas(const PartMeasures& measures, const Partition& partition, const Execution&)
{
  return largestOfCells(
    partition, [&](Index cell) { return measures.axis.siteViews[cell].lambda; });
}

Values erosionThicknesses(
  const PartMeasures& measures, const Partition& partition, const Execution&)
{
  return largestOfCells(partition, [&](Index cell) { return measures.axis.cellErosion[cell]; });
}

/// The balls on the axis, each with the only part that holds it, or the number of parts if several do.
struct HeldBalls
{
  std::vector<Ball> balls;
  std::vector<Index> parts;
};

HeldBalls heldBalls(const MedialAxis& axis, const Partition& partition)
{
  const Index shared = partition.cells.size();
  std::vector<Index> partOf(axis.ballOwner.size(), None), pointOf(partOf);
  forEachPoint(axis, partition, [&](Index part, Index p) {
    const Index ball = axis.ballOfPoint[p];
    if (ball != None)
    {
      partOf[ball] = partOf[ball] == None || partOf[ball] == part ? part : shared;
      pointOf[ball] = p;
    }
  });
  HeldBalls result;
  for (Index b = 0; b < count(partOf); ++b)
  {
    if (partOf[b] != None)
    {
      result.balls.push_back({ axis.points[pointOf[b]], axis.radii[pointOf[b]] });
      result.parts.push_back(partOf[b]);
    }
  }
  return result;
}

/// For each ball of a part the tree finds the ball of another part that covers it best; groups are parts.
/// A ball that several parts share stays when one of them goes, so it is in a group of its own. The search
/// stops at what cannot raise the part's largest value: O(n log n) for n balls, in practice.
Values hausdorffDistances(
  const PartMeasures& measures, const Partition& partition, const Execution& execution)
{
  const HeldBalls held = heldBalls(measures.axis, partition);
  const double diagonal = boundingDiagonal(held.balls);
  const BallTree tree(held.balls, held.parts);
  const IndexLists ballsOf = listsByKey(partition.cells.size() + 1, [&held](const auto& add) {
    for (Index i = 0; i < count(held.balls); ++i)
    {
      add(held.parts[i], i);
    }
  });
  Values result(partition.cells.size(), 0);
  execution.forEach(count(result), [&](Index part) {
    for (const Index i : ballsOf[part])
    {
      const double protrusion = tree.protrusion(held.balls[i], part, result[part]);
      result[part] = std::max(result[part], std::min(diagonal, protrusion));
    }
  });
  return result;
}

/// Counts the triangles at an edge that still live: after pruning, what was a seam may be free.
Values boundaryLengths(const PartMeasures& measures, const Partition& partition, const Execution&)
{
  Values result(partition.cells.size(), 0);
  for (Index e = 0; e < measures.edges.triangles.size(); ++e)
  {
    Index triangles = 0, last = None;
    for (const Index t : measures.edges.triangles[e])
    {
      const Index part = partition.partOfCell[measures.axis.cells.firstTriangle() + t];
      triangles += part != None;
      last = part != None ? part : last;
    }
    if (triangles == 1)
    {
      const Edge& ends = measures.edges.points[e];
      result[last] += (measures.axis.points[ends[1]] - measures.axis.points[ends[0]]).norm();
    }
  }
  return result;
}
}

const std::vector<MeasureTraits>& allMeasures()
{
  static const std::vector<MeasureTraits> all{
    { Measure::TriangleCount, "TriangleCount", "TriangleCount", 't', Unit::Count, true, true,
      "[TH03] 4.2", "number of triangles (lines, vertices)", triangleCounts },
    { Measure::RelativeVolume, "RelativeVolume", "RelativeVolume", 'v', Unit::Share, true, true,
      "[TH03] 4.2", "share of the solid's volume", relativeVolumes },
    { Measure::RelativePoleVolume, "RelativePoleVolume", "RelativePoleVolume", 'p', Unit::Share,
      true, true, "[TH03] 4.2", "the same on its poles alone, as in the paper",
      relativePoleVolumes },
    { Measure::Area, "Area", "PartArea", 'a', Unit::Area, true, false, "", "area", areas },
    { Measure::MeanRadius, "MeanRadius", "PartMeanRadius", 'm', Unit::Length, false, true, "",
      "mean radius of the maximal balls", meanRadii },
    { Measure::MaximumRadius, "MaximumRadius", "PartMaximumRadius", 'r', Unit::Length, false, true,
      "", "maximum radius of the maximal balls", maximumRadii },
    { Measure::ObjectAngle, "ObjectAngle", "PartObjectAngle", 'o', Unit::Degrees, false, true, "",
      "mean object angle, in degrees", objectAngles },
    { Measure::Lambda, "Lambda", "PartLambda", 'l', Unit::Length, false, true, "[CL05]",
      "lambda: largest distance of two sites", lambdas },
    { Measure::ErosionThickness, "ErosionThickness", "PartErosionThickness", 'e', Unit::Length,
      false, true, "[YSC16]", "erosion thickness", erosionThicknesses },
    { Measure::HausdorffDistance, "HausdorffDistance", "PartHausdorffDistance", 'h', Unit::Length,
      true, true, "", "Hausdorff distance: how far the solid recedes", hausdorffDistances },
    { Measure::BoundaryLength, "BoundaryLength", "PartBoundaryLength", 'b', Unit::Length, true,
      false, "", "length of the free border", boundaryLengths },
  };
  return all;
}

const MeasureTraits& traitsOf(Measure measure)
{
  return allMeasures()[static_cast<int>(measure)];
}

const MeasureTraits* findMeasure(int number)
{
  const std::vector<MeasureTraits>& all = allMeasures();
  return number >= 0 && number < count(all) ? &all[number] : nullptr;
}

const MeasureTraits* findMeasure(const std::string& name)
{
  const std::vector<MeasureTraits>& all = allMeasures();
  const auto found = std::find_if(
    all.begin(), all.end(), [&name](const MeasureTraits& traits) { return traits.name == name; });
  return found == all.end() ? nullptr : &*found;
}

const char* unitName(Unit unit)
{
  switch (unit)
  {
    case Unit::Count:
      return "count";
    case Unit::Share:
      return "share of the volume";
    case Unit::Length:
      return "length";
    case Unit::Area:
      return "area";
    case Unit::Degrees:
      return "degrees";
  }
  return "";
}

double largestThreshold(Unit unit)
{
  switch (unit)
  {
    case Unit::Share:
      return 1;
    case Unit::Degrees:
      return 180;
    default:
      return std::numeric_limits<double>::max();
  }
}

std::string noMeasure(const std::string& measure)
{
  std::string names;
  for (const MeasureTraits& traits : allMeasures())
  {
    names += (names.empty() ? "" : ", ") + std::string(traits.name);
  }
  return "there is no measure " + measure + " for the schedule; use one of " + names;
}

double together(Measure measure, double a, double b)
{
  return traitsOf(measure).addsUp ? a + b : std::max(a, b);
}

PartMeasures::PartMeasures(const MedialAxis& medialAxis, const LivingCells& cells)
  : axis(medialAxis)
  , edges(cells.edges)
  , cellsOfPoint(cells.cellsOfPoint())
  , solidVolume(std::accumulate(medialAxis.ballVolumes.begin(), medialAxis.ballVolumes.end(), 0.0))
  , sizes(sizesOfCells(medialAxis))
{
}

std::vector<double> PartMeasures::significance(
  Measure measure, const Partition& partition, const Execution& execution) const
{
  return traitsOf(measure).formula(*this, partition, execution);
}
}
