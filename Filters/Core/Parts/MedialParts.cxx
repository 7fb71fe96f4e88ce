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
#include <iterator>
#include <limits>
#include <map>
#include <numeric>

namespace medial
{
namespace
{
/// Of the cells of a part by size; where they have none, the mean of their corners.
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

/// Each point once, in order. Marked where there are many, sorted where few.
std::vector<Index> ascending(std::vector<Index> points, Index pointCount)
{
  if (count(points) < pointCount)
  {
    sortUnique(points);
    return points;
  }
  std::vector<char> isThere(pointCount, 0);
  for (const Index p : points)
  {
    isThere[p] = 1;
  }
  points.clear();
  for (Index p = 0; p < pointCount; ++p)
  {
    if (isThere[p])
    {
      points.push_back(p);
    }
  }
  return points;
}

MedialPart measured(const PartMeasures& measures, const Partition& partition, Index part)
{
  const MedialAxis& axis = measures.axis;
  const double infinity = std::numeric_limits<double>::infinity();
  MedialPart result{};
  result.dimension = partition.dimension[part];
  result.level = partition.level[part];
  result.minimumRadius = infinity;
  result.lower = Point::Constant(infinity);
  result.upper = -result.lower;
  std::vector<Index> points;
  for (const Index cell : partition.cells[part])
  {
    if (result.dimension == 2)
    {
      ++result.triangles;
      result.area += measures.sizes[cell];
    }
    forPoints(axis.cells, cell, [&points](Index p) { points.push_back(p); });
  }
  const int corners = result.dimension + 1;
  result.centroid = centroid(measures, partition.cells[part], corners);
  result.principalLengths =
    principalLengths(measures, partition.cells[part], corners, result.centroid);
  points = ascending(std::move(points), count(axis.points));
  for (const Index p : points)
  {
    const double radius = axis.radii[p];
    result.meanRadius += radius / static_cast<double>(points.size());
    result.minimumRadius = std::min(result.minimumRadius, radius);
    result.maximumRadius = std::max(result.maximumRadius, radius);
    result.lower = result.lower.cwiseMin(axis.points[p]);
    result.upper = result.upper.cwiseMax(axis.points[p]);
  }
  return result;
}

/// @param shares  of the solid's volume, for each part
void addVolumes(const std::vector<double>& shares, double solidVolume, MedialParts& result)
{
  const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
  for (std::size_t part = 0; part < shares.size(); ++part)
  {
    result.parts[part].volume = shares[part] * solidVolume;
    result.parts[part].relativeVolume = total > 0 ? shares[part] / total : 0;
  }
}

/// @param significances  for each measure by its number
void addMeasures(const Partition& partition, const std::vector<std::vector<double>>& significances,
  MedialParts& result)
{
  const std::map<Measure, double MedialPart::*> members{
    { Measure::PoleVolume, &MedialPart::poleVolume },
    { Measure::ObjectAngle, &MedialPart::objectAngle },
    { Measure::Lambda, &MedialPart::lambda },
    { Measure::ErosionThickness, &MedialPart::erosionThickness },
    { Measure::HausdorffDistance, &MedialPart::hausdorffDistance },
  };
  for (const MeasureTraits& traits : allMeasures())
  {
    const std::vector<double>& values = significances[static_cast<int>(traits.measure)];
    const auto member = members.find(traits.measure);
    std::vector<RankedPart> ranked;
    for (std::size_t part = 0; part < values.size(); ++part)
    {
      if (member != members.end())
      {
        result.parts[part].*(member->second) = values[part];
      }
      if (partition.level[part] == 1)
      {
        ranked.push_back({ values[part], result.parts[part].relativeVolume });
      }
    }
    result.suggestedThresholds.push_back(suggestedThreshold(std::move(ranked)));
  }
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

/// The edges along which the axis is no surface, with the parts that meet there.
struct ContactEdges
{
  std::vector<Index> edges;
  std::map<Index, std::vector<Index>> parts;   ///< of each edge
  std::map<Index, std::vector<Index>> atPoint; ///< the edges at each point
};

ContactEdges contactEdges(const LivingCells& living, const Partition& partition)
{
  const AxisEdges& edges = living.edges;
  ContactEdges result;
  for (Index e = 0; e < count(edges.points); ++e)
  {
    if (!living.isContact(e))
    {
      continue;
    }
    std::vector<Index>& parts = result.parts[e];
    for (const Index t : edges.triangles[e])
    {
      const Index part = partition.partOfCell[living.cells.firstTriangle() + t];
      if (part != None)
      {
        parts.push_back(part);
      }
    }
    sortUnique(parts);
    result.edges.push_back(e);
    for (const Index p : edges.points[e])
    {
      result.atPoint[p].push_back(e);
    }
  }
  return result;
}

/// The next edge of a contact curve beyond its point, or None where the curve is broken.
Index continuation(const ContactEdges& contacts, Index edge, Index point)
{
  const std::vector<Index>& at = contacts.atPoint.at(point);
  if (at.size() != 2)
  {
    return None;
  }
  const Index other = at[0] == edge ? at[1] : at[0];
  return contacts.parts.at(other) == contacts.parts.at(edge) ? other : None;
}

std::vector<ContactCurve> contactCurves(const AxisEdges& edges, const ContactEdges& contacts)
{
  std::vector<ContactCurve> curves;
  std::map<Index, bool> done;
  const auto walk = [&](Index edge, Index point, std::vector<Index>& points) {
    for (Index e = continuation(contacts, edge, point); e != None && !done[e];
         e = continuation(contacts, e, point))
    {
      done[e] = true;
      point = edges.points[e][0] == point ? edges.points[e][1] : edges.points[e][0];
      points.push_back(point);
    }
  };
  for (const Index e : contacts.edges)
  {
    if (done[e])
    {
      continue;
    }
    done[e] = true;
    std::vector<Index> forward{ edges.points[e][1] }, backward{ edges.points[e][0] };
    walk(e, forward[0], forward);
    walk(e, backward[0], backward);
    std::reverse(backward.begin(), backward.end());
    backward.insert(backward.end(), forward.begin(), forward.end());
    curves.push_back({ backward, contacts.parts.at(e) });
  }
  return curves;
}

/// The points at which some part has no contact edge.
std::vector<ContactCurve> contactPoints(
  const LivingCells& living, const Partition& partition, const ContactEdges& contacts)
{
  std::vector<ContactCurve> result;
  std::vector<Index> parts;
  for (Index p = 0; p < living.cellsOfPoint().size(); ++p)
  {
    partsOf(living.cellsOfPoint()[p], partition.partOfCell, parts);
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    if (parts.size() < 2)
    {
      continue;
    }
    std::vector<Index> joined;
    const auto at = contacts.atPoint.find(p);
    for (std::size_t i = 0; at != contacts.atPoint.end() && i < at->second.size(); ++i)
    {
      const std::vector<Index>& along = contacts.parts.at(at->second[i]);
      joined.insert(joined.end(), along.begin(), along.end());
    }
    sortUnique(joined);
    if (joined != parts)
    {
      result.push_back({ { p }, parts });
    }
  }
  return result;
}

/// For each ball: is it or its owner at a point that is used?
std::vector<char> ballsAtPoints(const MedialAxis& axis, const std::vector<char>& isUsed)
{
  std::vector<char> isThere(axis.ballOwner.size(), 0), result(isThere);
  for (std::size_t p = 0; p < isUsed.size(); ++p)
  {
    if (isUsed[p] && axis.ballOfPoint[p] != None)
    {
      isThere[axis.ballOfPoint[p]] = 1;
    }
  }
  for (std::size_t b = 0; b < result.size(); ++b)
  {
    result[b] = axis.ballOwner[b] != None && isThere[axis.ballOwner[b]];
  }
  return result;
}
}

std::vector<Index> partOfBall(
  const MedialAxis& axis, const std::vector<Index>& partOfCell, const IndexLists& cellsOfPoint)
{
  std::vector<Index> part(axis.ballOwner.size(), None), most(axis.ballOwner.size(), 0);
  std::vector<Index> parts;
  for (Index p = 0; p < cellsOfPoint.size(); ++p)
  {
    const Index ball = axis.ballOfPoint[p];
    if (ball == None)
    {
      continue;
    }
    partsOf(cellsOfPoint[p], partOfCell, parts);
    for (auto i = parts.begin(); i != parts.end();)
    {
      const auto end = std::upper_bound(i, parts.end(), *i);
      if (end - i > most[ball])
      {
        most[ball] = static_cast<Index>(end - i);
        part[ball] = *i;
      }
      i = end;
    }
  }
  std::vector<Index> result(axis.ballOwner.size(), None);
  for (Index b = 0; b < count(result); ++b)
  {
    result[b] = axis.ballOwner[b] == None ? None : part[axis.ballOwner[b]];
  }
  return result;
}

std::vector<Index> partOfBall(const MedialAxis& axis, const std::vector<Index>& partOfCell)
{
  return partOfBall(axis, partOfCell, cellsOfPoints(axis.cells));
}

std::vector<ContactCurve> contacts(const LivingCells& living, const Partition& partition)
{
  const ContactEdges along = contactEdges(living, partition);
  std::vector<ContactCurve> result = contactCurves(living.edges, along);
  const std::vector<ContactCurve> points = contactPoints(living, partition, along);
  result.insert(result.end(), points.begin(), points.end());
  return result;
}

std::vector<char> keptBalls(const MedialAxis& axis)
{
  std::vector<char> isUsed(axis.points.size(), 0);
  for (Index c = 0; c < axis.cells.size(); ++c)
  {
    forPoints(axis.cells, c, [&isUsed](Index p) { isUsed[p] = 1; });
  }
  return ballsAtPoints(axis, isUsed);
}

std::vector<char> keptBalls(const MedialAxis& axis, const LivingCells& living)
{
  std::vector<char> isUsed(axis.points.size(), 0);
  for (Index p = 0; p < living.cellsOfPoint().size(); ++p)
  {
    isUsed[p] = living.cellsAtPoint(p) > 0;
  }
  return ballsAtPoints(axis, isUsed);
}

MedialParts decompose(
  const MedialAxis& axis, int maximumLevel, const Execution& execution, double neckRatio)
{
  const AxisEdges edges = axisEdges(axis.cells);
  const Bodies limbs = neckRatio > 0 ? bodies(axis, edges, neckRatio) : Bodies{};
  LivingCells living(axis.cells, edges, limbs.ofCell);
  const PartMeasures measures(axis, living.cellsOfPoint());
  return decompose(living, partition(living, maximumLevel), measures, execution, limbs);
}

MedialParts decompose(const LivingCells& living, const Partition& partition,
  const PartMeasures& measures, const Execution& execution, const Bodies& bodies)
{
  execution.report(0.5);
  MedialParts result;
  result.partOfCell = partition.partOfCell;
  result.parts.resize(partition.dimension.size());
  std::vector<std::vector<double>> significances(allMeasures().size());
  // All at once, the longest first.
  const Index partCount = count(result.parts), measureCount = count(significances);
  execution.forEach(1 + measureCount + partCount, [&](Index task) {
    if (task == 0)
    {
      result.contacts = contacts(living, partition);
    }
    else if (task <= measureCount)
    {
      const MeasureTraits& traits = allMeasures()[measureCount - task];
      significances[measureCount - task] =
        measures.significance(traits.measure, partition, execution);
    }
    else
    {
      const Index part = task - measureCount - 1;
      const Index body = bodies.ofCell.empty() ? None : bodies.ofCell[partition.cells[part][0]];
      result.parts[part] = measured(measures, partition, part);
      result.parts[part].neckRatio = body == None ? 1 : bodies.neckRatio[body];
    }
  });
  addVolumes(
    significances[static_cast<int>(Measure::RelativeVolume)], measures.solidVolume, result);
  addMeasures(partition, significances, result);
  addContacts(result);
  execution.report(1);
  return result;
}
}
