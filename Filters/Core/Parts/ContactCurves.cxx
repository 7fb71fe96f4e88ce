// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/ContactCurves.h"

#include "Axis/AxisEdges.h"
#include "Base/Lists.h"

#include <algorithm>
#include <utility>

namespace medial
{
namespace
{
/// The edges along which the axis is no surface, with the parts that meet there. A contact is the place of
/// such an edge in the list.
struct ContactEdges
{
  std::vector<Index> edges; ///< ascending
  IndexLists parts;         ///< of each contact, ascending
  IndexLists atPoint;       ///< the contacts at each point
};

ContactEdges contactEdges(const LivingCells& living, const Partition& partition)
{
  const AxisEdges& edges = living.edges;
  ContactEdges result;
  std::vector<Index> parts;
  for (Index e = 0; e < count(edges.points); ++e)
  {
    if (!living.isContact(e))
    {
      continue;
    }
    parts.clear();
    for (const Index t : edges.triangles[e])
    {
      const Index part = partition.partOfCell[living.cells.firstTriangle() + t];
      if (part != None)
      {
        parts.push_back(part);
      }
    }
    sortUnique(parts);
    result.parts.append(parts);
    result.edges.push_back(e);
  }
  result.atPoint = listsByKey(living.cellsOfPoint().size(), [&](const auto& add) {
    for (Index contact = 0; contact < count(result.edges); ++contact)
    {
      for (const Index p : edges.points[result.edges[contact]])
      {
        add(p, contact);
      }
    }
  });
  return result;
}

/// The next contact of a curve beyond its point, or None where the curve ends: at a point with one or
/// more than two contacts, and where other parts meet along the next one.
Index continuation(const ContactEdges& contacts, Index contact, Index point)
{
  const IndexLists::View at = contacts.atPoint[point];
  if (at.size() != 2)
  {
    return None;
  }
  const Index other = at[0] == contact ? at[1] : at[0];
  const IndexLists::View here = contacts.parts[contact], there = contacts.parts[other];
  return std::equal(here.begin(), here.end(), there.begin(), there.end()) ? other : None;
}

std::vector<ContactCurve> contactCurves(const AxisEdges& edges, const ContactEdges& contacts)
{
  std::vector<ContactCurve> curves;
  std::vector<char> done(contacts.edges.size(), 0);
  const auto ends = [&](Index contact) { return edges.points[contacts.edges[contact]]; };
  const auto walk = [&](Index contact, Index point, std::vector<Index>& points) {
    for (Index next = continuation(contacts, contact, point); next != None && !done[next];
         next = continuation(contacts, next, point))
    {
      done[next] = 1;
      point = ends(next)[0] == point ? ends(next)[1] : ends(next)[0];
      points.push_back(point);
    }
  };
  for (Index contact = 0; contact < count(done); ++contact)
  {
    if (done[contact])
    {
      continue;
    }
    done[contact] = 1;
    std::vector<Index> forward{ ends(contact)[1] }, backward{ ends(contact)[0] };
    walk(contact, forward[0], forward);
    walk(contact, backward[0], backward);
    std::reverse(backward.begin(), backward.end());
    backward.insert(backward.end(), forward.begin(), forward.end());
    const IndexLists::View parts = contacts.parts[contact];
    curves.push_back({ std::move(backward), { parts.begin(), parts.end() } });
  }
  return curves;
}

/// The points at which some part has no contact edge.
std::vector<ContactCurve> contactPoints(
  const LivingCells& living, const Partition& partition, const ContactEdges& contacts)
{
  std::vector<ContactCurve> result;
  std::vector<Index> parts, joined;
  for (Index p = 0; p < living.cellsOfPoint().size(); ++p)
  {
    distinctPartsOf(living.cellsOfPoint()[p], partition.partOfCell, parts);
    if (parts.size() < 2)
    {
      continue;
    }
    joined.clear();
    for (const Index contact : contacts.atPoint[p])
    {
      const IndexLists::View along = contacts.parts[contact];
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
