// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/MedialParts.h"

#include "Axis/AxisEdges.h"
#include "Base/Lists.h"
#include "Parts/Partition.h"
#include "Parts/Thresholds.h"
#include "Parts/TopologyGraph.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numeric>

namespace medial
{
namespace
{
/// The mean of a part's cells, weighted by their sizes; unweighted where all sizes are 0.
/// @param corners  of each cell
Point centroid(const PartMeasures& measures, IndexLists::View cells, int corners)
{
  const MedialAxis& axis = measures.axis;
  Point sum = Point::Zero(), mean = Point::Zero();
  double size = 0;
  for (const Index cell : cells)
  {
    Point middle = Point::Zero();
    forPoints(axis.cells, cell, [&](Index p) { middle += axis.points[p] / corners; });
    const double weight = measures.sizes[cell];
    sum += weight * middle;
    mean += middle / cells.size();
    size += weight;
  }
  return size > 0 ? Point(sum / size) : mean;
}

/// The sides of a box are sqrt(12) times the standard deviations within it.
Point principalLengths(
  const PartMeasures& measures, IndexLists::View cells, int corners, const Point& center)
{
  const MedialAxis& axis = measures.axis;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  double size = 0;
  for (const Index cell : cells)
  {
    Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
    Point sum = Point::Zero();
    forPoints(axis.cells, cell, [&](Index p) {
      const Point arm = axis.points[p] - center;
      own += arm * arm.transpose();
      sum += arm;
    });
    own += sum * sum.transpose();
    const double weight = measures.sizes[cell];
    moments += weight / (corners * (corners + 1)) * own; // of a simplex
    size += weight;
  }
  if (!(size > 0))
  {
    return Point::Zero();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
    moments / size, Eigen::EigenvaluesOnly);
  return (12 * solver.eigenvalues().reverse().cwiseMax(0)).cwiseSqrt();
}

MedialPart described(const PartMeasures& measures, const Partition& partition, Index part)
{
  const MedialAxis& axis = measures.axis;
  const double infinity = std::numeric_limits<double>::infinity();
  MedialPart result{};
  result.dimension = partition.dimension[part];
  result.level = partition.level[part];
  result.minimumRadius = infinity;
  result.lower = Point::Constant(infinity);
  result.upper = -result.lower;
  for (const Index cell : partition.cells[part])
  {
    forPoints(axis.cells, cell, [&](Index p) {
      result.minimumRadius = std::min(result.minimumRadius, axis.radii[p]);
      result.lower = result.lower.cwiseMin(axis.points[p]);
      result.upper = result.upper.cwiseMax(axis.points[p]);
    });
  }
  const int corners = result.dimension + 1;
  result.centroid = centroid(measures, partition.cells[part], corners);
  result.principalLengths =
    principalLengths(measures, partition.cells[part], corners, result.centroid);
  return result;
}

/// Fills the volumes of the parts, and makes the relative volumes relative to the parts that are there.
void shareVolume(double solidVolume, MedialParts& result)
{
  std::vector<double>& shares = result.values[static_cast<int>(Measure::RelativeVolume)];
  const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (std::size_t part = 0; part < shares.size(); ++part)
  {
    result.parts[part].volume = shares[part] * solidVolume;
    shares[part] = total > 0 ? shares[part] / total : 0;
  }
}

/// The suggested threshold of each measure, from the parts that may go.
/// @param significances  for each measure by its number, before shareVolume
std::vector<double> suggestedThresholds(
  const std::vector<std::vector<double>>& significances, const MedialParts& parts)
{
  std::vector<double> result;
  for (const std::vector<double>& values : significances)
  {
    std::vector<RankedPart> ranked;
    for (Index part = 0; part < count(values); ++part)
    {
      if (parts.parts[part].level == 1)
      {
        ranked.push_back({ values[part], parts.value(Measure::RelativeVolume, part) });
      }
    }
    result.push_back(suggestedThreshold(std::move(ranked)));
  }
  return result;
}

/// Fills what the contacts tell of the parts.
void addContacts(MedialParts& result)
{
  std::vector<Edge> touching;
  for (const ContactCurve& curve : result.contacts)
  {
    for (const Index part : curve.parts)
    {
      ++result.parts[part].contacts;
      for (const Index other : curve.parts)
      {
        touching.push_back({ part, other });
      }
    }
  }
  sortUnique(touching);
  for (const Edge& pair : touching)
  {
    result.parts[pair[0]].neighbors += pair[0] != pair[1];
  }
  const TopologyGraph graph =
    topologyGraph(result.contacts, std::vector<char>(result.parts.size(), 0));
  for (std::size_t part = 0; part < result.parts.size(); ++part)
  {
    result.parts[part].onLoop = graph.partOnLoop[part] != 0;
  }
}

}

MedialParts decompose(
  const MedialAxis& axis, int maximumLevel, const Execution& execution, double neckRatio)
{
  const AxisEdges edges = axisEdges(axis.cells);
  const Bodies limbs = neckRatio > 0 ? bodies(axis, edges, neckRatio) : Bodies{};
  LivingCells living(axis.cells, edges, limbs.ofCell);
  const PartMeasures measures(axis, living);
  return decompose(living, partition(living, maximumLevel), measures, execution, limbs);
}

MedialParts decompose(const LivingCells& living, const Partition& partition,
  const PartMeasures& measures, const Execution& execution, const Bodies& bodies)
{
  execution.report(0.5);
  MedialParts result;
  result.partOfCell = partition.partOfCell;
  result.parts.resize(partition.dimension.size());
  result.values.resize(allMeasures().size());
  // Contacts, measures and parts don't depend on each other: all at once, the longest first.
  const Index partCount = count(result.parts), measureCount = count(result.values);
  execution.forEach(1 + measureCount + partCount, [&](Index task) {
    if (task == 0)
    {
      result.contacts = contacts(living, partition);
    }
    else if (task <= measureCount)
    {
      const MeasureTraits& traits = allMeasures()[measureCount - task];
      result.values[measureCount - task] =
        measures.significance(traits.measure, partition, execution);
    }
    else
    {
      const Index part = task - measureCount - 1;
      const Index body = bodies.ofCell.empty() ? None : bodies.ofCell[partition.cells[part][0]];
      result.parts[part] = described(measures, partition, part);
      result.parts[part].neckRatio = body == None ? 1 : bodies.neckRatio[body];
    }
  });
  const std::vector<std::vector<double>> significances = result.values;
  shareVolume(measures.solidVolume, result);
  result.suggestedThresholds = suggestedThresholds(significances, result);
  addContacts(result);
  execution.report(1);
  return result;
}
}
