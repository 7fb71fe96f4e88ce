// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/Partition.h"

#include "Base/Lists.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace medial
{
namespace
{
/// Gives each living cell the number of its part.
void numberParts(LivingCells& living, Partition& result)
{
  const AxisCells& cells = living.cells;
  std::vector<Index>& partOfCell = result.partOfCell;
  partOfCell.assign(cells.size(), None);
  const auto number = [&](Index from, Index to, int dimension) {
    for (Index c = from; c < to; ++c)
    {
      if (!living.isLiving(c))
      {
        continue;
      }
      const Index first = living.groupOf(c);
      if (first == c)
      {
        partOfCell[c] = count(result.dimension);
        result.dimension.push_back(dimension);
      }
      partOfCell[c] = partOfCell[first];
    }
  };
  number(cells.firstTriangle(), cells.size(), 2);
  number(cells.firstEdge(), cells.firstTriangle(), 1);
  number(0, cells.firstEdge(), 0);
}

/// The living cells by their part, ascending.
void sortCells(Partition& result)
{
  result.cells = listsByKey(count(result.dimension), [&result](const auto& add) {
    for (Index c = 0; c < count(result.partOfCell); ++c)
    {
      if (result.partOfCell[c] != None)
      {
        add(result.partOfCell[c], c);
      }
    }
  });
}

/// Parts with an edge of one triangle, or a chain's free end; and vertices.
void findBorder(const LivingCells& living, Partition& result)
{
  const AxisCells& cells = living.cells;
  const auto set = [&result](Index cell) {
    if (result.partOfCell[cell] != None)
    {
      result.level[result.partOfCell[cell]] = 1;
    }
  };
  for (Index e = 0; e < living.edges.triangles.size(); ++e)
  {
    if (living.trianglesAtEdge(e) == 1)
    {
      const IndexLists::View triangles = living.edges.triangles[e];
      std::for_each(
        triangles.begin(), triangles.end(), [&](Index t) { set(cells.firstTriangle() + t); });
    }
  }
  for (Index e = 0; e < count(cells.edges); ++e)
  {
    const Edge& ends = cells.edges[e];
    if (living.cellsAtPoint(ends[0]) == 1 || living.cellsAtPoint(ends[1]) == 1)
    {
      set(cells.firstEdge() + e);
    }
  }
  for (Index v = 0; v < cells.firstEdge(); ++v)
  {
    set(v);
  }
}

/// Calls body(cell) for the cells that a level spreads to from a cell: over contact edges, and from any
/// part to the dangling edges at its points.
template <typename Body>
void forInwardNeighbors(const LivingCells& living, Index cell, const Body& body)
{
  const AxisCells& cells = living.cells;
  const auto overEdge = [&](Index e) {
    if (living.isContact(e))
    {
      for (const Index other : living.edges.triangles[e])
      {
        body(cells.firstTriangle() + other);
      }
    }
  };
  const auto toDangling = [&](Index p) {
    for (const Index other : living.cellsOfPoint()[p])
    {
      if (other >= cells.firstTriangle())
      {
        break; // ascending: the dangling edges come before
      }
      if (cell >= cells.firstEdge() && other >= cells.firstEdge())
      {
        body(other);
      }
    }
  };
  forFaces(cells, living.edges, cell, overEdge, toDangling);
}

/// A breadth-first search inwards from the parts of level 1 (paper 4.1). Linear in the number of cells.
void spreadLevels(const LivingCells& living, int maximumLevel, Partition& result)
{
  std::vector<Index> current;
  for (Index part = 0; part < count(result.level); ++part)
  {
    if (result.level[part] == 1)
    {
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
        forInwardNeighbors(living, c, [&](Index other) {
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

Partition partition(LivingCells& living, int maximumLevel, const Execution& execution)
{
  living.join();
  Partition result;
  numberParts(living, result);
  result.level.assign(result.dimension.size(), 0);
  execution.forEach(
    2, [&](Index task) { task == 0 ? sortCells(result) : findBorder(living, result); });
  spreadLevels(living, maximumLevel, result);
  return result;
}

Partition partition(const AxisCells& cells, const AxisEdges& edges, int maximumLevel)
{
  LivingCells living(cells, edges);
  return partition(living, maximumLevel);
}

void findAllLevels(const LivingCells& living, Partition& partition)
{
  spreadLevels(living, 0, partition);
}

void distinctPartsOf(
  IndexLists::View cells, const std::vector<Index>& partOfCell, std::vector<Index>& parts)
{
  parts.clear();
  for (const Index cell : cells)
  {
    const Index part = partOfCell[cell];
    if (part != None && (parts.empty() || parts.back() != part))
    {
      parts.push_back(part);
    }
  }
  if (parts.size() > 1)
  {
    sortUnique(parts);
  }
}

void partsOf(
  IndexLists::View cells, const std::vector<Index>& partOfCell, std::vector<Index>& parts)
{
  parts.clear();
  for (const Index cell : cells)
  {
    if (partOfCell[cell] != None)
    {
      parts.push_back(partOfCell[cell]);
    }
  }
  if (std::adjacent_find(parts.begin(), parts.end(), std::greater<>()) != parts.end())
  {
    std::sort(parts.begin(), parts.end());
  }
}
}
