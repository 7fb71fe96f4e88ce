// SPDX-License-Identifier: BSD-3-Clause
#include "Partition.h"

#include "DisjointSets.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace medial
{
namespace
{
/// What the living cells look like from edges and points.
struct Incidence
{
  std::vector<Index> trianglesAtEdge; ///< how many live
  std::vector<Index> cellsAtPoint;    ///< how many live, of any kind
  IndexLists danglingAtPoint;         ///< living dangling edges, as cells
};

Index pointCount(const AxisCells& cells, const AxisEdges& edges)
{
  Index highest = None;
  for (const Edge& edge : edges.points)
  {
    highest = std::max(highest, edge[1]);
  }
  for (const Index v : cells.vertices)
  {
    highest = std::max(highest, v);
  }
  return highest + 1;
}

Incidence incidence(const AxisCells& cells, const AxisEdges& edges, const std::vector<char>& living)
{
  Incidence result;
  result.trianglesAtEdge.assign(edges.points.size(), 0);
  result.cellsAtPoint.assign(pointCount(cells, edges), 0);
  std::vector<std::vector<Index>> dangling(result.cellsAtPoint.size());
  for (Index v = 0; v < count(cells.vertices); ++v)
  {
    result.cellsAtPoint[cells.vertices[v]] += living[v];
  }
  for (Index e = 0; e < count(cells.edges); ++e)
  {
    for (const Index p : cells.edges[e])
    {
      if (living[cells.firstEdge() + e])
      {
        ++result.cellsAtPoint[p];
        dangling[p].push_back(cells.firstEdge() + e);
      }
    }
  }
  for (Index t = 0; t < count(cells.triangles); ++t)
  {
    for (int k = 0; k < 3 && living[cells.firstTriangle() + t]; ++k)
    {
      ++result.cellsAtPoint[cells.triangles[t][k]];
      ++result.trianglesAtEdge[edges.ofTriangle[t][k]];
    }
  }
  for (const std::vector<Index>& list : dangling)
  {
    result.danglingAtPoint.items.insert(
      result.danglingAtPoint.items.end(), list.begin(), list.end());
    result.danglingAtPoint.close();
  }
  return result;
}

/// Joins triangles over edges with two, and dangling edges over points with two and nothing else.
DisjointSets joined(const AxisCells& cells, const AxisEdges& edges, const std::vector<char>& living,
  const Incidence& incidence)
{
  DisjointSets sets(cells.size());
  for (Index e = 0; e < count(edges.points); ++e)
  {
    Index first = None;
    for (const Index t : edges.triangles[e])
    {
      const Index cell = cells.firstTriangle() + t;
      if (incidence.trianglesAtEdge[e] == 2 && living[cell])
      {
        sets.unite(first == None ? cell : first, cell);
        first = cell;
      }
    }
  }
  for (Index p = 0; p < incidence.danglingAtPoint.size(); ++p)
  {
    const IndexLists::View at = incidence.danglingAtPoint[p];
    if (at.size() == 2 && incidence.cellsAtPoint[p] == 2)
    {
      sets.unite(at[0], at[1]);
    }
  }
  return sets;
}

void numberParts(
  const AxisCells& cells, const std::vector<char>& living, DisjointSets& sets, Partition& result)
{
  result.partOfCell.assign(cells.size(), None);
  const auto number = [&](Index begin, Index end, int dimension) {
    for (Index c = begin; c < end; ++c)
    {
      const Index first = sets.find(c);
      if (living[c] && first == c)
      {
        result.partOfCell[c] = count(result.dimension);
        result.dimension.push_back(dimension);
      }
      result.partOfCell[c] = living[c] ? result.partOfCell[first] : None;
    }
  };
  number(cells.firstTriangle(), cells.size(), 2);
  number(cells.firstEdge(), cells.firstTriangle(), 1);
  number(0, cells.firstEdge(), 0);
  std::vector<std::vector<Index>> lists(result.dimension.size());
  for (Index c = 0; c < cells.size(); ++c)
  {
    if (result.partOfCell[c] != None)
    {
      lists[result.partOfCell[c]].push_back(c);
    }
  }
  for (const std::vector<Index>& list : lists)
  {
    result.cells.items.insert(result.cells.items.end(), list.begin(), list.end());
    result.cells.close();
  }
}

bool isAtBorder(
  const AxisCells& cells, const AxisEdges& edges, const Incidence& incidence, Index cell)
{
  if (cell >= cells.firstTriangle())
  {
    const Triangle& sides = edges.ofTriangle[cell - cells.firstTriangle()];
    return std::any_of(
      sides.begin(), sides.end(), [&](Index e) { return incidence.trianglesAtEdge[e] == 1; });
  }
  if (cell >= cells.firstEdge())
  {
    const Edge& ends = cells.edges[cell - cells.firstEdge()];
    return incidence.cellsAtPoint[ends[0]] == 1 || incidence.cellsAtPoint[ends[1]] == 1;
  }
  return true;
}

/// Calls body(cell) for what a level spreads to: over edges with more than two triangles, and from
/// any part to the dangling edges at its points.
template <typename Body>
void forInwardNeighbors(const AxisCells& cells, const AxisEdges& edges, const Incidence& incidence,
  Index cell, const Body& body)
{
  const auto toDangling = [&](Index point) {
    for (const Index other : incidence.danglingAtPoint[point])
    {
      body(other);
    }
  };
  if (cell >= cells.firstTriangle())
  {
    const Index t = cell - cells.firstTriangle();
    for (int k = 0; k < 3; ++k)
    {
      toDangling(cells.triangles[t][k]);
      const Index e = edges.ofTriangle[t][k];
      for (const Index other : edges.triangles[e])
      {
        if (incidence.trianglesAtEdge[e] > 2)
        {
          body(cells.firstTriangle() + other);
        }
      }
    }
  }
  else if (cell >= cells.firstEdge())
  {
    toDangling(cells.edges[cell - cells.firstEdge()][0]);
    toDangling(cells.edges[cell - cells.firstEdge()][1]);
  }
}

void findLevels(const AxisCells& cells, const AxisEdges& edges, const Incidence& incidence,
  int maximumLevel, Partition& result)
{
  result.level.assign(result.dimension.size(), 0);
  std::vector<Index> current;
  for (Index c = 0; c < cells.size(); ++c)
  {
    const Index part = result.partOfCell[c];
    if (part != None && result.level[part] == 0 && isAtBorder(cells, edges, incidence, c))
    {
      result.level[part] = 1;
      current.push_back(part);
    }
  }
  const int last = maximumLevel > 0 ? maximumLevel : std::numeric_limits<int>::max();
  for (int level = 2; level <= last && !current.empty(); ++level)
  {
    std::vector<Index> next;
    for (const Index part : current)
    {
      for (const Index c : result.cells[part])
      {
        forInwardNeighbors(cells, edges, incidence, c, [&](Index other) {
          const Index neighbor = result.partOfCell[other];
          if (neighbor != None && result.level[neighbor] == 0)
          {
            result.level[neighbor] = level;
            next.push_back(neighbor);
          }
        });
      }
    }
    current = std::move(next);
  }
}
}

Partition partition(
  const AxisCells& cells, const AxisEdges& edges, const std::vector<char>& living, int maximumLevel)
{
  const std::vector<char> all(cells.size(), 1);
  const std::vector<char>& mask = living.empty() ? all : living;
  const Incidence around = incidence(cells, edges, mask);
  DisjointSets sets = joined(cells, edges, mask, around);
  Partition result;
  numberParts(cells, mask, sets, result);
  findLevels(cells, edges, around, maximumLevel, result);
  return result;
}
IndexLists partsAtPoints(
  const AxisCells& cells, const std::vector<Index>& partOfCell, Index pointCount)
{
  const auto forCorners = [&](const auto& body) {
    for (Index c = 0; c < cells.size(); ++c)
    {
      if (partOfCell[c] != None)
      {
        forPoints(cells, c, [&](Index p) { body(p, partOfCell[c]); });
      }
    }
  };
  IndexLists result;
  result.offsets.assign(pointCount + 1, 0);
  forCorners([&](Index p, Index) { ++result.offsets[p + 1]; });
  std::partial_sum(result.offsets.begin(), result.offsets.end(), result.offsets.begin());
  result.items.resize(result.offsets.back());
  std::vector<Index> next(result.offsets.begin(), result.offsets.end() - 1);
  forCorners([&](Index p, Index part) { result.items[next[p]++] = part; });
  for (Index p = 0; p < pointCount; ++p)
  {
    std::sort(result.items.data() + result.offsets[p], result.items.data() + result.offsets[p + 1]);
  }
  return result;
}
}
