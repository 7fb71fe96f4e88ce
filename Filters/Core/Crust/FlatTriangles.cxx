// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/FlatTriangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace medial
{
namespace
{
class Mending
{
public:
  Mending(CrustEdits& ofCrust, const SliverLimits& ofMending)
    : edits(ofCrust)
    , limits(ofMending)
  {
  }

  /// @return  was a side contracted or a corner moved? That may have made other triangles flat.
  bool run()
  {
    std::vector<Index> flat;
    for (Index t = 0; t < count(this->triangles()); ++t)
    {
      if (this->isFlat(t))
      {
        flat.push_back(t);
      }
    }
    // A flip makes the smaller of two triangles larger, so this ends; but it could take long.
    const std::size_t most = 8 * flat.size();
    bool changed = false;
    for (std::size_t k = 0; k < std::min(most, flat.size()); ++k) // the list grows
    {
      if (!this->isFlat(flat[k]))
      {
        continue;
      }
      if (this->contractSide(flat[k]))
      {
        changed = true;
      }
      else
      {
        this->flipLongest(flat[k], flat);
      }
    }
    sortUnique(flat);
    for (const Index t : flat)
    {
      changed = (this->isFlat(t) && this->moveApex(t)) || changed;
    }
    return changed;
  }

private:
  const std::vector<Triangle>& triangles() const { return this->edits.surface().triangles; }

  double area(Index a, Index b, Index c) const
  {
    const Point &p = this->edits.at(a), &q = this->edits.at(b), &r = this->edits.at(c);
    return (q - p).cross(r - p).norm() / 2;
  }

  bool isFlat(Index triangle) const
  {
    const Triangle& t = this->triangles()[triangle];
    return t[0] != None && this->area(t[0], t[1], t[2]) < this->limits.area;
  }

  /// The lengths of the sides opposite to the corners.
  std::array<double, 3> lengths(Index triangle) const
  {
    const Triangle& t = this->triangles()[triangle];
    const Point &a = this->edits.at(t[0]), &b = this->edits.at(t[1]), &c = this->edits.at(t[2]);
    return { (b - c).norm(), (c - a).norm(), (a - b).norm() };
  }

  /// Contracts the shortest side that can be, if it is short.
  bool contractSide(Index triangle)
  {
    const std::array<double, 3> sides = this->lengths(triangle);
    std::array<int, 3> order{ 0, 1, 2 };
    std::sort(order.begin(), order.end(), [&](int i, int k) { return sides[i] < sides[k]; });
    const Triangle t = this->triangles()[triangle];
    for (const int corner : order)
    {
      const Index a = t[(corner + 1) % 3], b = t[(corner + 2) % 3];
      const bool mayGo =
        sides[corner] < this->limits.side && !(this->edits.isSample(a) && this->edits.isSample(b));
      if (mayGo && this->edits.contract({ a, b }))
      {
        return true;
      }
    }
    return false;
  }

  /// The corner opposite to the longest side.
  int apex(Index triangle) const
  {
    const std::array<double, 3> sides = this->lengths(triangle);
    return static_cast<int>(std::max_element(sides.begin(), sides.end()) - sides.begin());
  }

  /// Is the smaller of the two triangles at the edge opposite to a corner larger with their other
  /// diagonal?
  bool flipHelps(Index triangle, int corner)
  {
    const Index d = this->edits.triangles().beyond(triangle, corner);
    if (d == None)
    {
      return false;
    }
    const Triangle& t = this->triangles()[triangle];
    const Index b = t[corner], c = t[(corner + 1) % 3], a = t[(corner + 2) % 3];
    return std::min(this->area(a, b, d), this->area(b, c, d)) >
      std::min(this->area(a, b, c), this->area(a, c, d));
  }

  /// Flips the longest side, or that of a flat triangle across it.
  void flipLongest(Index triangle, std::vector<Index>& flat)
  {
    const int corner = this->apex(triangle);
    const Index other = this->edits.triangles().across(triangle, corner);
    if (this->flipHelps(triangle, corner) && this->edits.flip(triangle, corner))
    {
      flat.insert(flat.end(), { triangle, other });
      return;
    }
    if (other == None || !this->isFlat(other))
    {
      return;
    }
    const int next = this->apex(other);
    const Index third = this->edits.triangles().across(other, next);
    if (this->flipHelps(other, next) && this->edits.flip(other, next))
    {
      flat.insert(flat.end(), { triangle, other, third });
    }
  }

  /// Moves the corner opposite to the longest side away from it, to where the corner's other triangles
  /// are: where many are on a line, no diagonal helps.
  bool moveApex(Index triangle)
  {
    const int corner = this->apex(triangle);
    const Triangle& t = this->triangles()[triangle];
    const std::array<double, 3> sides = this->lengths(triangle);
    if (this->edits.isSample(t[corner]) ||
      *std::min_element(sides.begin(), sides.end()) < this->limits.distance)
    {
      return false;
    }
    const Point side = this->edits.at(t[(corner + 2) % 3]) - this->edits.at(t[(corner + 1) % 3]);
    const Point line = side.stableNormalized(), to = this->edits.towardsNeighbors(t[corner]);
    const double height = 4 * this->limits.area / side.norm(); // twice what it has to be
    this->edits.move(t[corner],
      std::min(height, this->limits.side) * (to - to.dot(line) * line).stableNormalized());
    return true;
  }

  CrustEdits& edits;
  const SliverLimits& limits;
};
}

void mendFlatTriangles(CrustEdits& edits, const SliverLimits& limits)
{
  constexpr int mostTurns = 8; // two are usual
  for (int turn = 0; turn < mostTurns && Mending(edits, limits).run(); ++turn)
  {
  }
}
}
