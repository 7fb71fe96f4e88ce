// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/ContactCurves.h"

#include "Axis/AxisEdges.h"
#include "Base/Lists.h"

#include <algorithm>
#include <map>

namespace medial
{
namespace
{
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

/// The next edge of a contact curve beyond its point, or None where the curve ends: at a point with one or
/// more than two contact edges, and where other parts meet along the next edge.
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
}

std::vector<ContactCurve> contacts(const LivingCells& living, const Partition& partition)
{
  const ContactEdges along = contactEdges(living, partition);
  std::vector<ContactCurve> result = contactCurves(living.edges, along);
  const std::vector<ContactCurve> points = contactPoints(living, partition, along);
  result.insert(result.end(), points.begin(), points.end());
  return result;
}
}
