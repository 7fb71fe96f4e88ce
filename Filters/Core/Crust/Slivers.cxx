// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/Slivers.h"

#include "Base/Crowds.h"
#include "Crust/CrustEdits.h"
#include "Crust/FlatTriangles.h"
#include "Crust/SliverLimits.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{
/// A step can make work for the others; two turns are usual where points are moved apart.
constexpr int mostTurns = 8;

class Removal
{
public:
  Removal(CrustSurface& surface, double spacing)
    : edits(surface)
    , limits(spacing)
  {
  }

  void run(const Execution& execution)
  {
    for (int turn = 1; turn <= mostTurns; ++turn)
    {
      execution.poll();
      this->contractShortEdges();
      mendFlatTriangles(this->edits, this->limits);
      execution.poll();
      if (!this->moveApart(turn))
      {
        break;
      }
    }
    this->edits.finish();
  }

private:
  /// Are two points so near that they are to be one, or apart? Different samples are what they are.
  bool areNear(Index a, Index b) const
  {
    const std::vector<Index>& samples = this->edits.surface().sampleOfPoint;
    const bool different = samples[a] != None && samples[b] != None && samples[a] != samples[b];
    return !different &&
      (this->edits.at(a) - this->edits.at(b)).squaredNorm() <
      this->limits.distance * this->limits.distance;
  }

  /// Contracts short edges, and those that become short by that.
  void contractShortEdges()
  {
    std::vector<Edge> edges;
    for (const Triangle& t : this->edits.surface().triangles)
    {
      for (int k = 0; k < 3 && t[0] != None; ++k)
      {
        const Index a = t[k], b = t[(k + 1) % 3];
        if (a < b && this->areNear(a, b))
        {
          edges.push_back({ a, b });
        }
      }
    }
    EditableTriangles& triangles = this->edits.triangles();
    for (std::size_t k = 0; k < edges.size(); ++k) // the list grows
    {
      const auto [goes, stays] = triangles.fewerFirst(edges[k]);
      if (!triangles.hasEdge(goes, stays) || !this->areNear(goes, stays))
      {
        continue; // an edge before it has changed it
      }
      const std::vector<Index> neighbors = triangles.neighbors(goes);
      if (!this->edits.contract(edges[k]))
      {
        continue;
      }
      for (const Index other : neighbors)
      {
        // Edges that were refused come again here: now they may be contracted.
        if (other != stays && this->areNear(other, stays))
        {
          edges.push_back({ other, stays });
        }
      }
    }
  }

  /// Moves points apart that are at one place.
  /// @param steps  how far, for the first of a place
  /// @return       was any moved?
  bool moveApart(int steps)
  {
    const IndexLists groups =
      crowds(this->edits.surface().points, this->edits.usedPoints(), this->limits.distance);
    bool any = false;
    for (Index g = 0; g < groups.size(); ++g)
    {
      if (this->hasNearOnes(groups[g]))
      {
        this->moveApart(groups[g], steps);
        any = true;
      }
    }
    return any;
  }

  bool hasNearOnes(const IndexLists::View& crowd) const
  {
    for (Index i = 0; i < crowd.size(); ++i)
    {
      for (Index k = 0; k < i; ++k)
      {
        if (this->areNear(crowd[i], crowd[k]))
        {
          return true;
        }
      }
    }
    return false;
  }

  /// The samples first, then the points where the surface is flat: a tip moves away from the side that it
  /// touches, as do the sides of a tunnel from each other.
  std::vector<Index> bestFirst(const IndexLists::View& crowd)
  {
    std::vector<std::tuple<bool, double, Index>> order;
    for (const Index p : crowd)
    {
      order.push_back({ !this->edits.isSample(p), this->edits.towardsNeighbors(p).norm(), p });
    }
    std::sort(order.begin(), order.end());
    std::vector<Index> result;
    result.reserve(order.size());
    for (const auto& item : order)
    {
      result.push_back(std::get<Index>(item));
    }
    return result;
  }

  void moveApart(const IndexLists::View& crowd, int steps)
  {
    std::vector<std::pair<Index, int>> staying; // with the number of steps for the next one there
    for (const Index p : this->bestFirst(crowd))
    {
      const auto near = std::find_if(staying.begin(), staying.end(),
        [&](const auto& stays) { return this->areNear(p, stays.first); });
      if (near == staying.end())
      {
        staying.push_back({ p, steps });
        continue;
      }
      Point direction = this->edits.towardsNeighbors(p);
      if (direction.norm() < this->limits.distance)
      {
        direction =
          this->edits.at(this->edits.triangles().neighbors(p).front()) - this->edits.at(p);
      }
      // Each by another length, since they can have the same direction.
      const double length = 2 * this->limits.distance * near->second++;
      this->edits.move(p, length * direction.stableNormalized());
    }
  }

  CrustEdits edits;
  const SliverLimits limits;
};
}

void removeSlivers(CrustSurface& surface, double spacing, const Execution& execution)
{
  Removal(surface, spacing).run(execution);
}
}
