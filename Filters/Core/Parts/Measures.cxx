// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/Measures.h"

#include "Base/BallTree.h"
#include "Base/Lists.h"
#include "Parts/MedialParts.h"

#include <algorithm>
#include <numeric>

namespace medial
{
namespace
{
/// For each part fold(value, cell) over its cells, from 0.
template <typename Fold>
std::vector<double> overCells(const Partition& partition, const Fold& fold)
{
  std::vector<double> result(partition.cells.size(), 0);
  for (Index part = 0; part < count(result); ++part)
  {
    for (const Index cell : partition.cells[part])
    {
      result[part] = fold(result[part], cell);
    }
  }
  return result;
}

/// Calls body(part, point) for each point of each part once.
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

std::vector<double> sizesOfCells(const MedialAxis& axis)
{
  const std::vector<Point>& points = axis.points;
  std::vector<double> sizes(axis.cells.vertices.size(), 1);
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

std::vector<double> meanRadii(const MedialAxis& axis, const Partition& partition)
{
  std::vector<double> sums(partition.cells.size(), 0), counts(sums.size(), 0);
  forEachPoint(axis, partition, [&](Index part, Index p) {
    sums[part] += axis.radii[p];
    ++counts[part];
  });
  std::transform(sums.begin(), sums.end(), counts.begin(), sums.begin(), std::divides<>());
  return sums;
}
}

const std::vector<MeasureTraits>& allMeasures()
{
  static const std::vector<MeasureTraits> all{
    { Measure::TriangleCount, "TriangleCount", "1", true },
    { Measure::RelativeVolume, "RelativeVolume", "1", true },
    { Measure::PoleVolume, "PoleVolume", "1", true },
    { Measure::Area, "Area", "area", true },
    { Measure::MeanRadius, "MeanRadius", "length", false },
    { Measure::MaximumRadius, "MaximumRadius", "length", false },
    { Measure::ObjectAngle, "ObjectAngle", "degrees", false },
    { Measure::Lambda, "Lambda", "length", false },
    { Measure::ErosionThickness, "ErosionThickness", "length", false },
    { Measure::HausdorffDistance, "HausdorffDistance", "length", true },
  };
  return all;
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

std::string measureNames()
{
  std::string names;
  for (const MeasureTraits& traits : allMeasures())
  {
    names += (names.empty() ? "" : ", ") + std::string(traits.name);
  }
  return names;
}

double together(Measure measure, double a, double b)
{
  return findMeasure(static_cast<int>(measure))->addsUp ? a + b : std::max(a, b);
}

PartMeasures::PartMeasures(const MedialAxis& theAxis, const IndexLists& cellsOfItsPoints)
  : axis(theAxis)
  , solidVolume(std::accumulate(theAxis.ballVolumes.begin(), theAxis.ballVolumes.end(), 0.0))
  , sizes(sizesOfCells(theAxis))
  , cellsOfPoint(cellsOfItsPoints)
{
}

std::vector<double> PartMeasures::ofVolumes(const Partition& partition) const
{
  std::vector<double> result(partition.cells.size(), 0);
  const std::vector<Index> partOf =
    partOfBall(this->axis, partition.partOfCell, this->cellsOfPoint);
  for (Index b = 0; b < count(partOf); ++b)
  {
    if (partOf[b] != None && this->solidVolume > 0)
    {
      result[partOf[b]] += this->axis.ballVolumes[b] / this->solidVolume;
    }
  }
  return result;
}

std::vector<double> PartMeasures::poleVolumes(const Partition& partition) const
{
  std::vector<double> result(partition.cells.size(), 0);
  std::vector<Index> last(this->axis.poleVolumes.size(), None); // a ball can be at several points
  forEachPoint(this->axis, partition, [&](Index part, Index p) {
    const Index ball = this->axis.ballOfPoint[p];
    if (ball != None && last[ball] != part && this->solidVolume > 0)
    {
      last[ball] = part;
      result[part] += this->axis.poleVolumes[ball] / this->solidVolume;
    }
  });
  return result;
}

std::vector<double> PartMeasures::hausdorffDistances(
  const Partition& partition, const Execution& execution) const
{
  const Index shared = partition.cells.size();
  std::vector<Index> partOf(this->axis.ballOwner.size(), None); // the only one that holds it
  std::vector<Index> pointOf(partOf.size(), None);
  forEachPoint(this->axis, partition, [&](Index part, Index p) {
    const Index ball = this->axis.ballOfPoint[p];
    if (ball != None)
    {
      partOf[ball] = partOf[ball] == None || partOf[ball] == part ? part : shared;
      pointOf[ball] = p;
    }
  });
  std::vector<Ball> balls;
  std::vector<Index> groups;
  for (Index b = 0; b < count(partOf); ++b)
  {
    if (partOf[b] != None)
    {
      balls.push_back({ this->axis.points[pointOf[b]], this->axis.radii[pointOf[b]] });
      groups.push_back(partOf[b]);
    }
  }
  const double diagonal = boundingDiagonal(balls);
  const BallTree tree(balls, groups);
  std::vector<std::vector<Index>> ballsOf(partition.cells.size() + 1);
  for (Index i = 0; i < count(balls); ++i)
  {
    ballsOf[groups[i]].push_back(i);
  }
  std::vector<double> result(partition.cells.size(), 0);
  execution.forEach(count(result), [&](Index part) {
    for (const Index i : ballsOf[part])
    {
      const double protrusion = tree.protrusion(balls[i], part, result[part]);
      result[part] = std::max(result[part], std::min(diagonal, protrusion));
    }
  });
  return result;
}

std::vector<double> PartMeasures::objectAngles(const Partition& partition) const
{
  std::vector<double> means = overCells(partition, [&](double sum, Index cell) {
    return sum + this->sizes[cell] * this->axis.siteViews[cell].objectAngle;
  });
  const std::vector<double> sums =
    overCells(partition, [&](double sum, Index cell) { return sum + this->sizes[cell]; });
  // A part without a size, of flat triangles alone, sees nothing.
  std::transform(means.begin(), means.end(), sums.begin(), means.begin(),
    [](double mean, double sum) { return sum > 0 ? mean / sum : 0; });
  return means;
}

std::vector<double> PartMeasures::significance(
  Measure measure, const Partition& partition, const Execution& execution) const
{
  const Index firstTriangle = this->axis.cells.firstTriangle();
  switch (measure)
  {
    case Measure::TriangleCount:
      return overCells(partition, [](double sum, Index) { return sum + 1; });
    case Measure::RelativeVolume:
      return this->ofVolumes(partition);
    case Measure::Area:
      return overCells(partition, [&](double sum, Index cell) {
        return cell < firstTriangle ? sum : sum + this->sizes[cell];
      });
    case Measure::MeanRadius:
      return meanRadii(this->axis, partition);
    case Measure::MaximumRadius:
      return overCells(partition, [&](double most, Index cell) {
        forPoints(
          this->axis.cells, cell, [&](Index p) { most = std::max(most, this->axis.radii[p]); });
        return most;
      });
    case Measure::ObjectAngle:
      return this->objectAngles(partition);
    case Measure::Lambda:
      return overCells(partition,
        [&](double most, Index cell) { return std::max(most, this->axis.siteViews[cell].lambda); });
    case Measure::PoleVolume:
      return this->poleVolumes(partition);
    case Measure::ErosionThickness:
      return overCells(partition,
        [&](double most, Index cell) { return std::max(most, this->axis.cellErosion[cell]); });
    case Measure::HausdorffDistance:
      return this->hausdorffDistances(partition, execution);
  }
  return {};
}
}
