// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/PolygonIncidence.h"

#include <map>
#include <queue>
#include <utility>

namespace medial
{
namespace
{
Index placeOf(const std::vector<Index>& corners, Index vertex)
{
  return static_cast<Index>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
}
}

PolygonIncidence::PolygonIncidence(std::vector<FacePolygon>& facePolygons, Index vertexCount)
  : polygons(facePolygons)
  , at(vertexCount)
{
  for (Index p = 0; p < count(this->polygons); ++p)
  {
    this->enter(p);
  }
}

void PolygonIncidence::append(FacePolygon polygon)
{
  this->polygons.push_back(std::move(polygon));
  this->enter(count(this->polygons) - 1);
}

void PolygonIncidence::enter(Index polygon)
{
  for (const Index v : this->corners(polygon))
  {
    if (this->at[v].empty() || this->at[v].back() != polygon)
    {
      this->at[v].push_back(polygon);
    }
  }
}

std::set<Index> PolygonIncidence::neighbors(Index vertex) const
{
  std::set<Index> result;
  this->forPolygonsAt(vertex, [&](Index p, Index place) {
    result.insert(cornerAfter(this->corners(p), place, 1));
    result.insert(cornerAfter(this->corners(p), place, -1));
  });
  return result;
}

bool PolygonIncidence::areNeighbors(Index a, Index b) const
{
  if (this->entries(b) < this->entries(a))
  {
    std::swap(a, b);
  }
  const std::vector<Index>& atA = this->at[a];
  return std::any_of(atA.begin(), atA.end(), [&](Index p) {
    const std::vector<Index>& corners = this->corners(p);
    const Index place = placeOf(corners, a);
    return place < count(corners) &&
      (cornerAfter(corners, place, 1) == b || cornerAfter(corners, place, -1) == b);
  });
}

std::vector<Index> PolygonIncidence::shortestPath(Index a, Index b) const
{
  std::map<Index, Index> from{ { a, a } };
  std::queue<Index> queue({ a });
  while (!queue.empty() && from.count(b) == 0)
  {
    const Index v = queue.front();
    queue.pop();
    for (const Index n : this->neighbors(v))
    {
      if (from.insert({ n, v }).second)
      {
        queue.push(n);
      }
    }
  }
  std::vector<Index> path;
  if (from.count(b) > 0)
  {
    for (Index v = b; v != a; v = from[v])
    {
      path.push_back(v);
    }
    path.push_back(a);
    std::reverse(path.begin(), path.end());
  }
  return path;
}

Index PolygonIncidence::splitSide(Index a, Index b)
{
  const Index middle = count(this->at);
  this->at.emplace_back();
  this->splitSides.push_back({ a, b });
  std::vector<Index> atA;
  this->forPolygonsAt(a, [&](Index p, Index) { atA.push_back(p); });
  for (const Index p : atA)
  {
    std::vector<Index>& corners = this->polygons[p].corners;
    const Index place = placeOf(corners, a);
    const bool isAfter = cornerAfter(corners, place, 1) == b;
    if (!isAfter && cornerAfter(corners, place, -1) != b)
    {
      continue;
    }
    if (corners.size() == 2)
    {
      corners = { a, middle };
      this->append({ { middle, b }, this->polygons[p].siteEdge });
    }
    else
    {
      corners.insert(corners.begin() + place + isAfter, middle);
    }
    this->at[middle].push_back(p);
  }
  return middle;
}

void PolygonIncidence::cutOffCorner(Index polygon, Index vertex)
{
  const auto neighbor = [&](Index step) {
    const std::vector<Index>& corners = this->corners(polygon);
    return cornerAfter(corners, placeOf(corners, vertex), step);
  };
  const Index before = this->splitSide(vertex, neighbor(-1));
  const Index after = this->splitSide(vertex, neighbor(1));
  std::vector<Index>& corners = this->polygons[polygon].corners;
  corners.erase(corners.begin() + placeOf(corners, vertex));
  this->append({ { before, vertex, after }, this->polygons[polygon].siteEdge });
}

void PolygonIncidence::rename(Index from, Index to)
{
  const std::vector<Index> affected = std::move(this->at[from]);
  this->at[from].clear();
  for (const Index p : affected)
  {
    std::vector<Index> walk = std::move(this->polygons[p].corners);
    this->polygons[p].corners.clear();
    std::replace(walk.begin(), walk.end(), from, to);
    const Index first = count(this->polygons);
    appendSimplePolygons(walk, this->polygons[p].siteEdge, this->polygons);
    for (Index q = first; q < count(this->polygons); ++q)
    {
      this->enter(q);
    }
  }
}
}
