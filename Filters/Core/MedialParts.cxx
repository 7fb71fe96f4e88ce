// SPDX-License-Identifier: BSD-3-Clause
#include "MedialParts.h"

#include "AxisEdges.h"
#include "Partition.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>

namespace medial
{
namespace
{
/// The points of a cell.
std::vector<Index> corners(const AxisCells& cells, Index cell)
{
  if (cell < cells.firstEdge())
  {
    return { cells.vertices[cell] };
  }
  if (cell < cells.firstTriangle())
  {
    const Edge& e = cells.edges[cell - cells.firstEdge()];
    return { e[0], e[1] };
  }
  const Triangle& t = cells.triangles[cell - cells.firstTriangle()];
  return { t[0], t[1], t[2] };
}

double triangleArea(const MedialAxis& axis, Index cell)
{
  const Triangle& t = axis.cells.triangles[cell - axis.cells.firstTriangle()];
  const Point& a = axis.points[t[0]];
  return 0.5 * (axis.points[t[1]] - a).cross(axis.points[t[2]] - a).norm();
}

MedialPart measured(const MedialAxis& axis, const Partition& partition, Index part)
{
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
      result.area += triangleArea(axis, cell);
    }
    const std::vector<Index> own = corners(axis.cells, cell);
    points.insert(points.end(), own.begin(), own.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
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

void addVolumes(const MedialAxis& axis, MedialParts& result)
{
  const std::vector<Index> parts = partOfBall(axis, result.partOfCell);
  double total = 0;
  for (std::size_t b = 0; b < parts.size(); ++b)
  {
    if (parts[b] != None)
    {
      result.parts[parts[b]].volume += axis.ballVolumes[b];
      total += axis.ballVolumes[b];
    }
  }
  for (MedialPart& part : result.parts)
  {
    part.relativeVolume = total > 0 ? part.volume / total : 0;
  }
}

/// The edges along which the axis is no surface, with the parts that meet there.
struct ContactEdges
{
  std::vector<Index> edges;
  std::map<Index, std::vector<Index>> parts;   ///< of each edge
  std::map<Index, std::vector<Index>> atPoint; ///< the edges at each point
};

ContactEdges contactEdges(
  const MedialAxis& axis, const AxisEdges& edges, const Partition& partition)
{
  ContactEdges result;
  for (Index e = 0; e < count(edges.points); ++e)
  {
    if (edges.triangles[e].size() < 3)
    {
      continue;
    }
    std::vector<Index>& parts = result.parts[e];
    for (const Index t : edges.triangles[e])
    {
      parts.push_back(partition.partOfCell[axis.cells.firstTriangle() + t]);
    }
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
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
}

std::vector<Index> partOfBall(const MedialAxis& axis, const std::vector<Index>& partOfCell)
{
  std::vector<std::vector<Index>> votes(axis.points.size());
  for (Index c = 0; c < axis.cells.size(); ++c)
  {
    if (partOfCell[c] != None)
    {
      for (const Index p : corners(axis.cells, c))
      {
        votes[p].push_back(partOfCell[c]);
      }
    }
  }
  std::vector<Index> part(axis.ballOwner.size(), None), most(axis.ballOwner.size(), 0);
  for (Index p = 0; p < count(axis.points); ++p)
  {
    const Index ball = axis.ballOfPoint[p];
    std::sort(votes[p].begin(), votes[p].end());
    for (auto i = votes[p].begin(); i != votes[p].end() && ball != None;)
    {
      const auto end = std::upper_bound(i, votes[p].end(), *i);
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

std::vector<char> keptBalls(const MedialAxis& axis)
{
  const std::vector<Index> one(axis.cells.size(), 0);
  const std::vector<Index> parts = partOfBall(axis, one);
  std::vector<char> result(parts.size());
  std::transform(
    parts.begin(), parts.end(), result.begin(), [](Index part) { return part != None; });
  return result;
}

MedialParts decompose(const MedialAxis& axis, int maximumLevel, const Execution& execution)
{
  const AxisEdges edges = axisEdges(axis.cells);
  const Partition groups = partition(axis.cells, edges, {}, maximumLevel);
  execution.report(0.5);
  MedialParts result;
  result.partOfCell = groups.partOfCell;
  result.parts.resize(groups.dimension.size());
  execution.forEach(
    count(result.parts), [&](Index part) { result.parts[part] = measured(axis, groups, part); });
  addVolumes(axis, result);
  result.contacts = contactCurves(edges, contactEdges(axis, edges, groups));
  for (const ContactCurve& curve : result.contacts)
  {
    for (const Index part : curve.parts)
    {
      ++result.parts[part].contacts;
    }
  }
  execution.report(1);
  return result;
}
}
