// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/VertexMerging.h"

#include "Axis/PolygonIncidence.h"
#include "Base/Crowds.h"
#include "Base/DisjointSets.h"
#include "Base/Frame.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

// Merging two vertices of a complex turns every path between them into a loop. The topology stays if
// the merge fills exactly one of these loops, as if one path had been contracted. Each merge keeps this
// invariant as long as faces are discs, which they nearly always are; the axis's certificate checks the
// outcome.
//
// A contraction is the case in which nothing has to be filled or prevented.
//
// Usual merges look at the polygons at one of two vertices only. The search for a path takes time linear in
// the polygons, but is needed only where two vertices that coincide are far apart along the axis.
// Candidates for a merge are found by a grid in O(n log n) for n vertices.

namespace medial
{
namespace
{
/// Merges vertices one pair after the other.
class Merger
{
public:
  Merger(std::vector<FacePolygon>& facePolygons, Index vertexCount)
    : polygons(facePolygons, vertexCount)
  {
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
      std::vector<Index> loop = this->polygons.shortestPath(a, b);
      if (loop.empty())
      {
        return false; // to merge two pieces would lower the number of pieces
      }
      loop.pop_back();
      this->polygons.append({ std::move(loop), None });
    }
    this->polygons.rename(b, a);
    return true;
  }

  /// Contracts the side between two vertices, if this fills no other loop.
  bool contract(Index a, Index b)
  {
    const bool fillsOne = this->closings(a, b).size() == 1;
    if (fillsOne)
    {
      this->polygons.rename(b, a);
    }
    return fillsOne;
  }

  const std::vector<Edge>& midpoints() const { return this->polygons.midpoints(); }

private:
  /// How a merge of two vertices fills a loop: a face that has both is cut, or the edges to a common
  /// neighbour are folded together; neither: the vertices are neighbours, and their edge is contracted.
  struct Closing
  {
    Index polygon, neighbor;
  };

  std::vector<Closing> closings(Index a, Index b) const
  {
    // Found by the vertex with fewer polygons: those that many vertices were merged into have very many.
    const bool byB = this->polygons.entries(b) < this->polygons.entries(a);
    const Index from = byB ? b : a, to = byB ? a : b;
    const Index forward = byB ? -1 : 1; // from a to b
    const std::set<Index> near = this->polygons.neighbors(from);
    std::set<Index> between; // neighbours of both that a cut takes care of
    std::vector<Closing> result;
    if (near.count(to) > 0)
    {
      result.push_back({ None, None });
    }
    this->polygons.forPolygonsAt(from, [&](Index p, Index place) {
      const std::vector<Index>& corners = this->polygons.corners(p);
      const bool alongSide =
        cornerAfter(corners, place, 1) == to || cornerAfter(corners, place, -1) == to;
      if (std::find(corners.begin(), corners.end(), to) != corners.end() && !alongSide)
      {
        result.push_back({ p, None });
      }
      for (const Index step : { forward, -forward })
      {
        const Index v = cornerAfter(corners, place, step);
        if (cornerAfter(corners, place, 2 * step) == to && !between.insert(v).second)
        {
          result.push_back({ None, v }); // two such faces enclose a void
        }
      }
    });
    for (const Index v : near)
    {
      if (between.count(v) == 0 && this->polygons.areNeighbors(v, to))
      {
        result.push_back({ None, v });
      }
    }
    return result;
  }

  /// Splits sides at b so that the merge does not fill this loop: then b is no corner of that face,
  /// or no neighbour of the common neighbour, any more.
  void prevent(const Closing& closing, Index b)
  {
    if (closing.polygon == None)
    {
      this->polygons.splitSide(b, closing.neighbor);
    }
    else
    {
      this->polygons.cutOffCorner(closing.polygon, b);
    }
  }

  PolygonIncidence polygons;
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
  const IndexLists near = crowds(points, std::vector<char>(points.size(), 1), coincident);
  for (Index crowd = 0; crowd < near.size(); ++crowd)
  {
    for (Index i = 0; i < near[crowd].size(); ++i)
    {
      for (Index j = 0; j < i; ++j)
      {
        const Index a = near[crowd][j], b = near[crowd][i];
        if ((points[a] - points[b]).norm() < coincident)
        {
          sets.unite(a, b);
        }
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

void dropPoints(std::vector<FacePolygon>& polygons)
{
  polygons.erase(std::remove_if(polygons.begin(), polygons.end(),
                   [](const FacePolygon& polygon) { return polygon.corners.size() < 2; }),
    polygons.end());
}

Index vertexCount(const std::vector<Edge>& sides)
{
  std::vector<Index> vertices;
  for (const Edge& side : sides)
  {
    vertices.insert(vertices.end(), side.begin(), side.end());
  }
  sortUnique(vertices);
  return count(vertices);
}
}

MergedVertices mergeVertices(const std::vector<Point>& points, const std::vector<Index>& ball,
  std::vector<FacePolygon>& polygons)
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
  dropPoints(polygons);
  result.midpoints = merger.midpoints();
  return result;
}

std::vector<char> contractToEdges(const std::vector<std::vector<Edge>>& sidesOfPatches,
  const std::vector<Index>& ball, std::vector<FacePolygon>& polygons)
{
  std::vector<char> merged(ball.size(), 0);
  if (sidesOfPatches.empty())
  {
    return merged;
  }
  Merger merger(polygons, count(ball));
  DisjointSets sets(count(ball));
  std::vector<Index> vertexOfSet(ball.size());
  std::iota(vertexOfSet.begin(), vertexOfSet.end(), 0);
  const auto contract = [&](const Edge& side) {
    Index kept = vertexOfSet[sets.find(side[0])], gone = vertexOfSet[sets.find(side[1])];
    if (ball[kept] == None)
    {
      std::swap(kept, gone);
    }
    if (kept == gone || !merger.contract(kept, gone))
    {
      return false;
    }
    sets.unite(kept, gone);
    vertexOfSet[sets.find(kept)] = kept;
    merged[gone] = 1;
    return true;
  };
  for (const std::vector<Edge>& sides : sidesOfPatches)
  {
    // A contraction may make one possible that was not before.
    for (Index left = vertexCount(sides);
         left > 2 && std::any_of(sides.begin(), sides.end(), contract); --left)
    {
    }
  }
  dropPoints(polygons);
  return merged;
}
}
