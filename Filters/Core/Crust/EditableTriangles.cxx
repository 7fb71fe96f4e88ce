// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/EditableTriangles.h"

#include "Base/Polygons.h"

#include <algorithm>

namespace medial
{
namespace
{
bool hasCorner(const Triangle& triangle, Index point)
{
  return std::find(triangle.begin(), triangle.end(), point) != triangle.end();
}
}

EditableTriangles::EditableTriangles(std::vector<Triangle>& ofSurface, Index pointCount)
  : triangles(ofSurface)
  , before(trianglesAtPoints(ofSurface, pointCount))
  , numberOfList(pointCount, None)
{
}

std::vector<Index>& EditableTriangles::around(Index point)
{
  Index& number = this->numberOfList[point];
  if (number == None)
  {
    number = count(this->lists);
    const IndexLists::View list = this->before[point];
    this->lists.emplace_back(list.begin(), list.end());
  }
  return this->lists[number];
}

std::vector<Index> EditableTriangles::neighbors(Index point)
{
  std::vector<Index> result;
  for (const Index t : this->around(point))
  {
    for (const Index corner : this->triangles[t])
    {
      if (corner != point && hasCorner(this->triangles[t], point))
      {
        result.push_back(corner);
      }
    }
  }
  sortUnique(result);
  return result;
}

std::vector<Index> EditableTriangles::atEdge(Index a, Index b)
{
  const bool fewerAtA = this->around(a).size() < this->around(b).size();
  std::vector<Index> result;
  for (const Index t : this->around(fewerAtA ? a : b))
  {
    if (hasCorner(this->triangles[t], a) && hasCorner(this->triangles[t], b))
    {
      result.push_back(t);
    }
  }
  sortUnique(result);
  return result;
}

bool EditableTriangles::hasEdge(Index a, Index b)
{
  if (this->around(b).size() < this->around(a).size())
  {
    std::swap(a, b);
  }
  const std::vector<Index>& list = this->around(a);
  return std::any_of(list.begin(), list.end(),
    [&](Index t) { return hasCorner(this->triangles[t], a) && hasCorner(this->triangles[t], b); });
}

Index EditableTriangles::across(Index triangle, int corner)
{
  const Triangle& corners = this->triangles[triangle];
  const std::vector<Index> both =
    this->atEdge(corners[(corner + 1) % 3], corners[(corner + 2) % 3]);
  return both.size() == 2 ? both[both[0] == triangle ? 1 : 0] : None;
}

Index EditableTriangles::beyond(Index triangle, int corner)
{
  const Index other = this->across(triangle, corner);
  if (other == None)
  {
    return None;
  }
  const Triangle &near = this->triangles[triangle], &far = this->triangles[other];
  const Index a = near[(corner + 1) % 3], b = near[(corner + 2) % 3];
  return *std::find_if(
    far.begin(), far.end(), [&](Index point) { return point != a && point != b; });
}

Edge EditableTriangles::fewerFirst(const Edge& edge)
{
  const std::size_t first = this->around(edge[0]).size(), second = this->around(edge[1]).size();
  return first < second || (first == second && edge[0] > edge[1]) ? edge : Edge{ edge[1], edge[0] };
}

bool EditableTriangles::contract(Index goes, Index stays)
{
  const std::vector<Index> link = this->neighbors(goes);
  const auto shared = std::count_if(link.begin(), link.end(),
    [&](Index point) { return point != stays && this->hasEdge(point, stays); });
  if (shared != 2 || this->atEdge(goes, stays).size() != 2)
  {
    return false;
  }
  if (link.size() == 3)
  {
    // Is the third triangle at `goes` next to one at `stays`? Then there are no more than four.
    const Index x = link[0] == stays ? link[1] : link[0], y = link[2] == stays ? link[1] : link[2];
    const std::vector<Index> both = this->atEdge(x, y);
    if (std::any_of(
          both.begin(), both.end(), [&](Index t) { return hasCorner(this->triangles[t], stays); }))
    {
      return false;
    }
  }
  for (const Index t : std::vector<Index>(this->around(goes)))
  {
    Triangle& triangle = this->triangles[t];
    if (hasCorner(triangle, goes) && hasCorner(triangle, stays))
    {
      triangle = { None, None, None };
    }
    else if (hasCorner(triangle, goes))
    {
      std::replace(triangle.begin(), triangle.end(), goes, stays);
      this->around(stays).push_back(t);
    }
  }
  this->around(goes).clear();
  return true;
}

bool EditableTriangles::flip(Index triangle, int corner)
{
  const Index other = this->across(triangle, corner);
  if (other == None)
  {
    return false;
  }
  const Index b = this->triangles[triangle][corner];
  const Index c = this->triangles[triangle][(corner + 1) % 3];
  const Index a = this->triangles[triangle][(corner + 2) % 3];
  const Index d = this->beyond(triangle, corner);
  if (b == d || this->hasEdge(b, d))
  {
    return false;
  }
  this->triangles[triangle] = { a, b, d };
  this->triangles[other] = { b, c, d };
  this->around(d).push_back(triangle);
  this->around(b).push_back(other);
  return true;
}
}
