// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/VertexMerging.h"

#include "Base/DisjointSets.h"
#include "Base/Frame.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>
#include <set>

namespace medial
{
namespace
{
class Merger
{
public:
  Merger(std::vector<Polygon>& all, Index vertexCount)
    : polygons(all)
    , at(vertexCount)
  {
    for (Index p = 0; p < count(this->polygons); ++p)
    {
      this->enter(p);
    }
  }

  /// Gives all places of vertex b to vertex a. @return  false where they are in different pieces
  bool merge(Index a, Index b)
  {
    std::vector<Closing> closings = this->closings(a, b);
    while (closings.size() > 1)
    {
      this->prevent(closings.back(), b);
      closings = this->closings(a, b);
    }
    if (closings.empty())
    {
      std::vector<Index> loop = this->shortestPath(a, b);
      if (loop.empty())
      {
        return false;
      }
      loop.pop_back();
      this->append({ std::move(loop), None });
    }
    this->rename(b, a);
    return true;
  }

  std::vector<Edge> midpoints;

private:
  void append(Polygon polygon)
  {
    this->polygons.push_back(std::move(polygon));
    this->enter(count(this->polygons) - 1);
  }

  void enter(Index polygon)
  {
    for (const Index v : this->polygons[polygon].corners)
    {
      if (this->at[v].empty() || this->at[v].back() != polygon)
      {
        this->at[v].push_back(polygon);
      }
    }
  }

  /// Calls body(polygon, place of v) for the polygons at v; the lists may hold stale entries.
  template <typename Body>
  void forPolygonsAt(Index v, const Body& body) const
  {
    for (const Index p : this->at[v])
    {
      const std::vector<Index>& corners = this->polygons[p].corners;
      const auto place = std::find(corners.begin(), corners.end(), v);
      if (place != corners.end())
      {
        body(p, static_cast<Index>(place - corners.begin()));
      }
    }
  }

  static Index next(const std::vector<Index>& corners, Index place, Index step)
  {
    const Index n = count(corners);
    return corners[(place + n + step) % n];
  }

  std::set<Index> neighbors(Index v) const
  {
    std::set<Index> result;
    this->forPolygonsAt(v, [&](Index p, Index place) {
      result.insert(next(this->polygons[p].corners, place, 1));
      result.insert(next(this->polygons[p].corners, place, -1));
    });
    return result;
  }

  /// How a loop through two vertices closes when they become one: a face that has both is cut, or
  /// the edges to a common neighbour are folded together; neither: the vertices are neighbours.
  struct Closing
  {
    Index polygon, neighbor;
  };

  std::vector<Closing> closings(Index a, Index b) const
  {
    const std::set<Index> nearA = this->neighbors(a), nearB = this->neighbors(b);
    std::set<Index> between; // neighbours of both that a cut takes care of
    std::vector<Closing> result;
    if (nearA.count(b) > 0)
    {
      result.push_back({ None, None });
    }
    this->forPolygonsAt(a, [&](Index p, Index place) {
      const std::vector<Index>& corners = this->polygons[p].corners;
      const bool alongSide = next(corners, place, 1) == b || next(corners, place, -1) == b;
      if (std::find(corners.begin(), corners.end(), b) != corners.end() && !alongSide)
      {
        result.push_back({ p, None });
      }
      for (const Index step : { 1, -1 })
      {
        if (next(corners, place, 2 * step) == b)
        {
          between.insert(next(corners, place, step));
        }
      }
    });
    for (const Index v : nearA)
    {
      if (nearB.count(v) > 0 && between.count(v) == 0)
      {
        result.push_back({ None, v });
      }
    }
    return result;
  }

  /// Splits sides at b so that the loop stays open when b is merged.
  void prevent(const Closing& closing, Index b)
  {
    if (closing.polygon == None)
    {
      this->splitSide(b, closing.neighbor);
      return;
    }
    const Index p = closing.polygon;
    const auto placeOf = [&](Index v) {
      const std::vector<Index>& corners = this->polygons[p].corners;
      return static_cast<Index>(std::find(corners.begin(), corners.end(), v) - corners.begin());
    };
    const Index before = this->splitSide(b, next(this->polygons[p].corners, placeOf(b), -1));
    const Index after = this->splitSide(b, next(this->polygons[p].corners, placeOf(b), 1));
    this->polygons[p].corners.erase(this->polygons[p].corners.begin() + placeOf(b));
    this->append({ { before, b, after }, this->polygons[p].siteEdge });
  }

  /// Puts a new vertex between two neighbours. @return  the vertex
  Index splitSide(Index b, Index v)
  {
    const Index middle = count(this->at);
    this->at.emplace_back();
    this->midpoints.push_back({ b, v });
    std::vector<Index> atB;
    this->forPolygonsAt(b, [&](Index p, Index) { atB.push_back(p); });
    for (const Index p : atB)
    {
      std::vector<Index>& corners = this->polygons[p].corners;
      const Index place =
        static_cast<Index>(std::find(corners.begin(), corners.end(), b) - corners.begin());
      const bool isAfter = next(corners, place, 1) == v;
      if (!isAfter && next(corners, place, -1) != v)
      {
        continue;
      }
      if (corners.size() == 2)
      {
        corners = { b, middle };
        this->append({ { middle, v }, this->polygons[p].siteEdge });
      }
      else
      {
        corners.insert(corners.begin() + place + isAfter, middle);
      }
      this->at[middle].push_back(p);
    }
    return middle;
  }

  /// From a to b along sides of polygons, both included; empty where there is no path.
  std::vector<Index> shortestPath(Index a, Index b) const
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

  void rename(Index from, Index to)
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

  std::vector<Polygon>& polygons;
  std::vector<std::vector<Index>> at; ///< the polygons at each vertex
};

/// Groups of two and more vertices with the same pole or the same place. The first of a group has a
/// pole if any of it has.
std::vector<std::vector<Index>> sameVertices(
  const std::vector<Point>& points, const std::vector<Index>& ball)
{
  DisjointSets sets(count(points));
  std::map<Index, Index> vertexOfBall;
  for (Index v = 0; v < count(points); ++v)
  {
    if (ball[v] != None)
    {
      sets.unite(vertexOfBall.insert({ ball[v], v }).first->second, v);
    }
  }
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return points[a].x() != points[b].x() ? points[a].x() < points[b].x() : a < b;
  });
  for (auto i = order.begin(); i != order.end(); ++i)
  {
    for (auto j = i + 1; j != order.end() && points[*j].x() - points[*i].x() < coincident; ++j)
    {
      if ((points[*i] - points[*j]).norm() < coincident)
      {
        sets.unite(*i, *j);
      }
    }
  }
  std::map<Index, std::vector<Index>> groups;
  for (Index v = 0; v < count(points); ++v)
  {
    groups[sets.find(v)].push_back(v);
  }
  std::vector<std::vector<Index>> result;
  for (auto& [first, group] : groups)
  {
    std::stable_partition(group.begin(), group.end(), [&ball](Index v) { return ball[v] != None; });
    if (group.size() > 1)
    {
      result.push_back(group);
    }
  }
  return result;
}
}

void appendSimplePolygons(std::vector<Index> walk, Index siteEdge, std::vector<Polygon>& polygons)
{
  std::vector<Index> path;
  const auto emit = [&](std::vector<Index> corners) {
    if (corners.size() > 1)
    {
      polygons.push_back({ std::move(corners), siteEdge });
    }
  };
  for (const Index vertex : walk)
  {
    const auto before = std::find(path.begin(), path.end(), vertex);
    if (before == path.end())
    {
      path.push_back(vertex);
      continue;
    }
    emit({ before, path.end() });
    path.erase(before + 1, path.end());
  }
  emit(path);
}

MergedVertices mergeVertices(
  const std::vector<Point>& points, const std::vector<Index>& ball, std::vector<Polygon>& polygons)
{
  Merger merger(polygons, count(points));
  MergedVertices result{ std::vector<char>(points.size(), 0), {} };
  for (const std::vector<Index>& group : sameVertices(points, ball))
  {
    for (std::size_t i = 1; i < group.size(); ++i)
    {
      result.merged[group[i]] = merger.merge(group[0], group[i]);
    }
  }
  polygons.erase(std::remove_if(polygons.begin(), polygons.end(),
                   [](const Polygon& polygon) { return polygon.corners.size() < 2; }),
    polygons.end());
  result.midpoints = std::move(merger.midpoints);
  return result;
}
}
