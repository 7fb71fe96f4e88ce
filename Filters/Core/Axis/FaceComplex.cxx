// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/FaceComplex.h"

#include <algorithm>
#include <utility>

namespace medial
{
namespace
{
/// For each of `size` values the numbers of the lists that hold it.
IndexLists listsWith(const IndexLists& lists, Index size)
{
  return listsByKey(size, [&lists](const auto& add) {
    for (Index i = 0; i < lists.size(); ++i)
    {
      std::for_each(lists[i].begin(), lists[i].end(), [&](Index value) { add(value, i); });
    }
  });
}
}

FaceComplex::FaceComplex(const std::vector<FacePolygon>& facePolygons, Index vertexCount)
  : polygons(facePolygons)
  , face(facePolygons.size())
  , goneVertex(vertexCount, 0)
{
  std::transform(facePolygons.begin(), facePolygons.end(), this->face.begin(),
    [](const FacePolygon& polygon) { return polygon.corners.size() > 2; });
  this->numberSides();
}

/// Finds equal sides in lists by their lower corner: few share one, so sorting takes little time.
void FaceComplex::numberSides()
{
  using Use = std::pair<Index, Index>; // higher corner, polygon
  Lists<Use> uses = listsByKey<Use>(this->vertexCount(), [this](const auto& add) {
    for (Index p = 0; p < count(this->polygons); ++p)
    {
      const std::vector<Index>& corners = this->polygons[p].corners;
      for (std::size_t i = 0; i < (this->face[p] ? corners.size() : 1); ++i)
      {
        const Index a = corners[i], b = corners[(i + 1) % corners.size()];
        add(std::min(a, b), Use{ std::max(a, b), p });
      }
    }
  });
  uses.sortEach();
  IndexLists ends;
  for (Index lower = 0; lower < uses.size(); ++lower)
  {
    for (const Use *use = uses[lower].begin(), *last = uses[lower].end(); use != last;)
    {
      const Index higher = use->first;
      this->sides.push_back({ lower, higher });
      this->faces.push_back(0);
      ends.append(this->sides.back());
      for (; use != last && use->first == higher; ++use)
      {
        this->users.items.push_back(use->second);
        this->faces.back() += this->face[use->second];
      }
      this->users.close();
    }
  }
  this->sidesOfPolygon = listsWith(this->users, count(this->polygons));
  this->sidesOfVertex = listsWith(ends, this->vertexCount());
}

std::vector<Index> FaceComplex::facesAt(Index side) const
{
  std::vector<Index> result;
  this->forFacesAt(side, [&result](Index p) { result.push_back(p); });
  return result;
}

Index FaceComplex::freeSide(Index polygon) const
{
  for (const Index s : this->sidesOfPolygon[polygon])
  {
    if (this->faces[s] == 1)
    {
      return s;
    }
  }
  return None;
}

DisjointSets FaceComplex::joinedFaces() const
{
  DisjointSets result(count(this->polygons));
  for (Index s = 0; s < this->sideCount(); ++s)
  {
    if (this->faceCount(s) == 2)
    {
      Index other = None;
      this->forFacesAt(s, [&](Index p) {
        result.unite(p, other == None ? p : other);
        other = p;
      });
    }
  }
  return result;
}

std::vector<Index> FaceComplex::danglingSides() const
{
  std::vector<Index> result(this->vertexCount(), 0);
  for (Index s = 0; s < this->sideCount(); ++s)
  {
    if (this->faces[s] == 0)
    {
      ++result[this->sides[s][0]], ++result[this->sides[s][1]];
    }
  }
  return result;
}

bool FaceComplex::collapse(Index polygon)
{
  const Index side = this->face[polygon] ? this->freeSide(polygon) : None;
  if (side == None)
  {
    return false;
  }
  for (const Index s : this->sidesOfPolygon[polygon])
  {
    --this->faces[s];
  }
  this->face[polygon] = 0;
  this->faces[side] = None;
  for (const Index v : this->polygons[polygon].corners)
  {
    this->removeChain(v);
  }
  return true;
}

bool FaceComplex::collapseAll(const std::vector<Index>& polygonNumbers)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const Index p : polygonNumbers)
    {
      changed = this->collapse(p) || changed;
    }
  }
  return std::none_of(
    polygonNumbers.begin(), polygonNumbers.end(), [this](Index p) { return this->face[p]; });
}

/// Collapses edges from a vertex that is the end of one edge alone, as long as there is one.
void FaceComplex::removeChain(Index vertex)
{
  while (!this->goneVertex[vertex])
  {
    Index only = None, alive = 0;
    for (const Index s : this->sidesOfVertex[vertex])
    {
      if (this->faces[s] != None)
      {
        ++alive;
        only = s;
      }
    }
    if (alive != 1 || this->faces[only] != 0)
    {
      return;
    }
    this->faces[only] = None;
    this->goneVertex[vertex] = 1;
    vertex = this->sides[only][0] == vertex ? this->sides[only][1] : this->sides[only][0];
  }
}

std::vector<FacePolygon> FaceComplex::remaining() const
{
  std::vector<FacePolygon> result;
  for (Index p = 0; p < count(this->polygons); ++p)
  {
    if (this->face[p])
    {
      result.push_back(this->polygons[p]);
    }
  }
  for (Index s = 0; s < this->sideCount(); ++s)
  {
    if (this->faces[s] == 0)
    {
      const FacePolygon& former = this->polygons[this->users[s][0]];
      result.push_back(
        { { this->sides[s][0], this->sides[s][1] }, former.siteEdge, former.siteFacet });
    }
  }
  return result;
}
}
