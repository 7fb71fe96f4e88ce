// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/CellFaces.h"

#include "Base/Tetrahedra.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace medial
{
namespace
{
/// The bit of a cell's edge between corners number i and k.
std::uint16_t edgeBit(int i, int k)
{
  return static_cast<std::uint16_t>(
    1U << (1U << i | 1U << k)); // of six edges and ten other sets of corners
}

/// Finds one face for each dual edge between an inner and an outer ball. An edge is met in each of the cells
/// around it, and known there by a bit.
class FaceSearch
{
public:
  explicit FaceSearch(const PowerDiagram& diagram)
    : inner(diagram.inner)
    , done(diagram.dual.cells.size(), 0)
  {
    this->cells.reserve(diagram.dual.cells.size());
    for (std::size_t c = 0; c < diagram.dual.cells.size(); ++c)
    {
      this->cells.push_back({ diagram.dual.cells[c], diagram.dual.neighbors[c] });
    }
  }

  CellFaces run(const Execution& execution)
  {
    for (Index c = 0; c < count(this->cells); ++c)
    {
      execution.pollAt(c);
      const Tetrahedron& corners = this->cells[c].corners;
      for (const auto& [i, k] : cellEdges)
      {
        if (this->inner[corners[i]] != this->inner[corners[k]] &&
          (this->done[c] & edgeBit(i, k)) == 0)
        {
          this->inner[corners[i]] ? this->addFace(c, i, k) : this->addFace(c, k, i);
        }
      }
    }
    return std::move(this->faces);
  }

private:
  /// The walks spend most of their time on waiting for memory, so all of a cell is at one place.
  struct Cell
  {
    Tetrahedron corners, neighbors;

    int place(Index corner) const
    {
      return (this->corners[1] == corner) + 2 * (this->corners[2] == corner) +
        3 * (this->corners[3] == corner);
    }
  };

  /// That of the dual edge between the inner corner i and the outer corner k of a cell, counter-clockwise seen
  /// from the outer ball; none where the edge is on the convex hull.
  void addFace(Index start, int i, int k)
  {
    const Edge edge{ this->cells[start].corners[i], this->cells[start].corners[k] };
    // Of the facets with the edge, leave by the one from which the turn is counter-clockwise.
    const Triangle seen = facet({ 0, 1, 2, 3 }, i); // so seen from the inner ball
    int leave = seen[(std::find(seen.begin(), seen.end(), k) - seen.begin() + 2) % 3];
    std::vector<Index>& cycles = this->faces.cycles.items;
    for (Index cell = start;;)
    {
      const Cell& here = this->cells[cell];
      this->done[cell] |= edgeBit(i, k);
      cycles.push_back(cell);
      const Index pivot = here.corners[6 - i - k - leave]; // next opposite to the facet to cross
      cell = here.neighbors[leave];
      if (cell == start)
      {
        break;
      }
      if (cell == None)
      {
        cycles.resize(this->faces.cycles.offsets.back());
        return;
      }
      const Cell& next = this->cells[cell];
      i = next.place(edge[0]);
      k = next.place(edge[1]);
      leave = next.place(pivot);
    }
    this->faces.cycles.close();
    this->faces.balls.push_back(edge);
  }

  std::vector<Cell> cells;
  const std::vector<char>& inner;
  std::vector<std::uint16_t> done; ///< bits of the edges that were met, for each cell
  CellFaces faces;
};
}

CellFaces cellFaces(const PowerDiagram& diagram, const Execution& execution)
{
  return FaceSearch(diagram).run(execution);
}
}
