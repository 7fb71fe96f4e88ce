// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/OutsideSearch.h"

#include "Base/Tetrahedra.h"

#include <algorithm>

namespace medial
{
Index OutsideSearch::piecesAround(Index cell, const OpenSet& set)
{
  this->prepare();
  this->reached.clear();
  for (const Index v : this->sites.mesh.cells[cell])
  {
    const IndexLists::View cells = this->cellsOfVertex[v];
    if (this->isOnHull[v] ||
      std::any_of(cells.begin(), cells.end(), [&](Index c) { return c != cell && !set.cells[c]; }))
    {
      this->begin(v);
    }
  }
  // In turn, one vertex of each that is not complete.
  while (this->activePieces() > 1)
  {
    for (std::size_t which = 0; which < this->reached.size(); ++which)
    {
      this->expand(which, cell, set);
    }
  }
  Index result = 0;
  for (Index label = 0; label < count(this->reached); ++label)
  {
    result += this->reached[label].label == label;
  }
  for (const Reached& each : this->reached)
  {
    for (const Index v : each.vertices)
    {
      this->labelOfVertex[v] = None;
    }
  }
  return result;
}

void OutsideSearch::prepare()
{
  if (!this->isOnHull.empty())
  {
    return;
  }
  const std::vector<Tetrahedron>& cells = this->sites.mesh.cells;
  this->cellsOfVertex = listsByKey(this->sites.siteCount, [&cells](const auto& add) {
    for (Index c = 0; c < count(cells); ++c)
    {
      for (const Index v : cells[c])
      {
        add(v, c);
      }
    }
  });
  this->isOnHull.assign(this->sites.siteCount, 0);
  for (Index c = 0; c < count(cells); ++c)
  {
    for (int i = 0; i < 4; ++i)
    {
      if (this->sites.mesh.neighbors[c][i] == None)
      {
        for (const Index v : facet(cells[c], i))
        {
          this->isOnHull[v] = 1;
        }
      }
    }
  }
  this->labelOfVertex.assign(this->sites.siteCount, None);
}

void OutsideSearch::begin(Index vertex)
{
  const Index label = count(this->reached);
  this->reached.push_back({ label, false, {}, 0 });
  this->visit(vertex, label);
}

/// Looks at the cells outside around one vertex that a search has come to.
void OutsideSearch::expand(std::size_t which, Index cell, const OpenSet& set)
{
  Reached& own = this->reached[which];
  if (own.isComplete())
  {
    return;
  }
  const Index v = own.vertices[own.done++];
  for (const Index c : this->cellsOfVertex[v])
  {
    if (c != cell && !set.cells[c])
    {
      for (const Index next : this->sites.mesh.cells[c])
      {
        this->visit(next, static_cast<Index>(which));
      }
    }
  }
}

void OutsideSearch::visit(Index vertex, Index label)
{
  Index& known = this->labelOfVertex[vertex];
  if (known != None)
  {
    this->unite(known, label);
    return;
  }
  known = label;
  this->reached[label].vertices.push_back(vertex);
  if (this->isOnHull[vertex])
  {
    this->reached[this->reached[label].label].isBeyond = true;
    for (Index other = 0; other < count(this->reached); ++other)
    {
      if (this->reached[this->reached[other].label].isBeyond)
      {
        this->unite(other, label);
      }
    }
  }
}

void OutsideSearch::unite(Index a, Index b)
{
  a = this->reached[a].label;
  b = this->reached[b].label;
  if (a == b)
  {
    return;
  }
  const Index low = std::min(a, b), high = std::max(a, b);
  this->reached[low].isBeyond = this->reached[low].isBeyond || this->reached[high].isBeyond;
  for (Reached& each : this->reached)
  {
    each.label = each.label == high ? low : each.label;
  }
}

/// How many may still meet others? What has reached the hull is not complete without what else is there.
Index OutsideSearch::activePieces() const
{
  Index result = 0;
  for (Index label = 0; label < count(this->reached); ++label)
  {
    result += std::any_of(this->reached.begin(), this->reached.end(), [label](const Reached& each) {
      return each.label == label && (each.isBeyond || !each.isComplete());
    });
  }
  return result;
}
}
