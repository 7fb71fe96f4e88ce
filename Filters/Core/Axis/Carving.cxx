// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Carving.h"

#include "Axis/OutsideCounts.h"
#include "Base/DisjointSets.h"

#include <algorithm>

// The set begins with all candidates and shrinks to the core and what holds it together. A cell is taken
// away if what it shares with the outside is a disc or a smaller contractible piece: then neither the set
// nor the outside changes its topology. So the Betti numbers of the set are those it began with, whatever
// the order. The order decides what stays: shallow cells go first, since the axis is deep inside.
//
// A cell that can't go may be able to when its neighbours have gone, so passes are repeated until nothing
// changes. A pass takes time linear in the candidates that are left; few passes do.

namespace medial
{
namespace
{
/// Is the cell across facet i outside the set?
bool isOpen(const SiteTriangulation& sites, const OpenSet& set, Index cell, int i)
{
  const Index neighbor = sites.mesh.neighbors[cell][i];
  return neighbor == None || !set.cells[neighbor];
}

void markCell(const SiteTriangulation& sites, Index cell, Outside& outside)
{
  for (const Index v : sites.mesh.cells[cell])
  {
    outside.vertices[v] = 1;
  }
  for (const Index e : sites.edges.ofCell[cell])
  {
    outside.edges[e] = 1;
  }
}

/// How many pieces of the rest of space the set encloses.
Index voidCount(const SiteTriangulation& sites, const OpenSet& set)
{
  // Pieces of the closed rest: cells, joined over shared vertices. The vertex at infinity is one more.
  const Index infinity = sites.siteCount;
  DisjointSets pieces(infinity + 1);
  std::vector<char> isOutside(infinity, 0);
  for (Index c = 0; c < count(set.cells); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (!set.cells[c])
      {
        isOutside[sites.mesh.cells[c][i]] = 1;
        pieces.unite(sites.mesh.cells[c][0], sites.mesh.cells[c][i]);
      }
      if (sites.mesh.neighbors[c][i] == None)
      {
        for (const Index v : facet(sites.mesh.cells[c], i))
        {
          pieces.unite(v, infinity);
        }
      }
    }
  }
  Index result = 0;
  for (Index v = 0; v < infinity; ++v)
  {
    result += isOutside[v] && pieces.find(v) == v && pieces.find(infinity) != v;
  }
  return result;
}

/// Can the cell go without a change of topology? What it shares with the outside must be contractible.
bool isSimple(
  const SiteTriangulation& sites, const OpenSet& set, const Outside& outside, Index cell)
{
  std::array<bool, 4> vertices;
  std::array<bool, 6> edges;
  int facets = 0;
  for (int i = 0; i < 4; ++i)
  {
    vertices[i] = outside.vertices[sites.mesh.cells[cell][i]];
    facets += isOpen(sites, set, cell, i);
  }
  for (int k = 0; k < 6; ++k)
  {
    edges[k] = outside.edges[sites.edges.ofCell[cell][k]];
  }
  return boundaryPiece(vertices, edges, facets).isContractible();
}

/// Components of the set over shared facets, each known by its lowest cell.
DisjointSets components(const SiteTriangulation& sites, const OpenSet& set)
{
  DisjointSets result(count(set.cells));
  for (Index c = 0; c < count(set.cells); ++c)
  {
    if (!set.cells[c])
    {
      continue;
    }
    for (const Index n : sites.mesh.neighbors[c])
    {
      if (n > c && set.cells[n])
      {
        result.unite(c, n);
      }
    }
  }
  return result;
}
}

Outside outsideOf(const SiteTriangulation& sites, const OpenSet& set)
{
  Outside result{ std::vector<char>(sites.siteCount, 0),
    std::vector<char>(sites.edges.edges.size(), 0) };
  for (Index c = 0; c < count(set.cells); ++c)
  {
    if (!set.cells[c])
    {
      markCell(sites, c, result);
      continue;
    }
    for (int i = 0; i < 4; ++i)
    {
      if (sites.mesh.neighbors[c][i] == None)
      {
        for (const Index v : facet(sites.mesh.cells[c], i))
        {
          result.vertices[v] = 1;
        }
        for (int k = 0; k < 6; ++k)
        {
          result.edges[sites.edges.ofCell[c][k]] |= isInFacet(k, i);
        }
      }
    }
  }
  return result;
}

OpenSet insideCells(const SiteTriangulation& sites, double kappa)
{
  OpenSet set{ sites.isCore };
  for (std::size_t c = 0; c < set.cells.size(); ++c)
  {
    set.cells[c] |= sites.depth[c] >= kappa;
  }
  DisjointSets pieces = components(sites, set);
  std::vector<char> hasBall(set.cells.size(), 0);
  for (Index c = 0; c < count(set.cells); ++c)
  {
    hasBall[pieces.find(c)] |= sites.onBall[c] != None;
  }
  for (Index c = 0; c < count(set.cells); ++c)
  {
    set.cells[c] = set.cells[c] && hasBall[pieces.find(c)];
  }
  return set;
}

Betti bettiNumbers(const SiteTriangulation& sites, const OpenSet& set)
{
  const Outside outside = outsideOf(sites, set);
  DisjointSets pieces = components(sites, set);
  Index cells = 0, facets = 0, edges = 0, vertices = 0, b0 = 0;
  std::vector<char> seen(outside.vertices.size(), 0);
  for (Index c = 0; c < count(set.cells); ++c)
  {
    for (const Index v : sites.mesh.cells[c])
    {
      vertices += !seen[v] && !outside.vertices[v];
      seen[v] = 1;
    }
    if (set.cells[c])
    {
      ++cells;
      b0 += pieces.find(c) == c;
      for (int i = 0; i < 4; ++i)
      {
        facets += !isOpen(sites, set, c, i);
      }
    }
  }
  for (const char edge : outside.edges)
  {
    edges += !edge;
  }
  // By Alexander duality; the open set's Euler characteristic then gives the tunnels.
  const Index b2 = voidCount(sites, set);
  return { b0, b0 + b2 - (cells - facets / 2 + edges - vertices), b2 };
}

void carve(const SiteTriangulation& sites, OpenSet& set, const Execution& execution)
{
  Outside outside = outsideOf(sites, set);
  std::vector<Index> order;
  for (Index c = 0; c < count(set.cells); ++c)
  {
    if (set.cells[c] && !sites.isCore[c])
    {
      order.push_back(c);
    }
  }
  std::stable_sort(
    order.begin(), order.end(), [&](Index a, Index b) { return sites.depth[a] < sites.depth[b]; });
  for (bool changed = true; changed;)
  {
    changed = false;
    execution.report(0.5);
    for (Index i = 0; i < count(order); ++i)
    {
      execution.pollAt(i);
      Index& c = order[i];
      if (isSimple(sites, set, outside, c))
      {
        set.cells[c] = 0;
        markCell(sites, c, outside);
        changed = true;
        c = None;
      }
    }
    order.erase(std::remove(order.begin(), order.end(), None), order.end());
  }
}
}
