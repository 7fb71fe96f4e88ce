// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Erosion.h"

#include "Axis/AxisEdges.h"
#include "Axis/Sectors.h"
#include "Base/BallTree.h"
#include "Base/Lists.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

// Dijkstra's algorithm on sectors: the sector with the earliest known time burns, and its time is
// final, because what burns later can only offer later times. A sector burns as a whole, so that the
// fire comes to all triangles of a sheet around a point at once, and to each sheet of a seam on its own.
//
// Along sides alone times would be up to 15 % too large on regular triangles. So where two corners of a
// triangle have burnt, the front also goes straight on to the third one, as in fast marching. Two fronts
// that met in the triangle behind are not one straight front: isOneFront tells.
//
// For n cells this takes O(n log n) time.

namespace medial
{
namespace
{
constexpr double never = std::numeric_limits<double>::infinity();

/// A burnt edge, and where a point lies beside it.
struct Edgewise
{
  double slope; ///< of the burn time along the edge
  double along, height;

  Edgewise(const Point& a, double timeA, const Point& b, double timeB, const Point& beside)
  {
    const double length = (b - a).norm();
    this->slope = (timeB - timeA) / length;
    this->along = (beside - a).dot(b - a) / length;
    this->height = (b - a).cross(beside - a).norm() / length;
  }
};

/// When a straight front that comes to a and b at these times has come to c, through the inside of the
/// triangle; never where it comes past a side.
double straightOn(const Point& a, double timeA, const Point& b, double timeB, const Point& c)
{
  const Edgewise edge(a, timeA, b, timeB, c);
  if (!(std::abs(edge.slope) < 1))
  {
    return never;
  }
  const double steepness = std::sqrt(1 - edge.slope * edge.slope);
  const double start = edge.along - edge.slope * edge.height / steepness;
  return start > 0 && start < (b - a).norm()
    ? timeA + edge.slope * edge.along + steepness * edge.height
    : never;
}

/// Has one front come through the burnt triangle a, b, c, over the edge a b? If it were straight, the
/// gradient of the times would be 1; where two fronts meet it is well below.
bool isOneFront(
  const Point& a, double timeA, const Point& b, double timeB, const Point& c, double timeC)
{
  constexpr double least = 0.9;
  const Edgewise edge(a, timeA, b, timeB, c);
  const double across = (timeA + edge.slope * edge.along - timeC) / edge.height;
  return across > 0 && std::hypot(edge.slope, across) >= least;
}

/// Burns sector by sector, the earliest first.
class Fire
{
public:
  Fire(const AxisComplex& axisComplex, const Sectors& axisSectors, const Execution& execution)
    : axis(axisComplex)
    , sectors(axisSectors)
    , edges(axisSectors.edges)
    , time(axisSectors.cornerCount(), never)
    , burnt(time.size(), 0)
    , sectorsLeft(axisSectors.sectorsAt())
  {
    this->trianglesLeft.reserve(2 * this->edges.points.size());
    for (Index e = 0; e < count(this->edges.points); ++e)
    {
      this->trianglesLeft.insert(this->trianglesLeft.end(), 2, this->edges.triangles[e].size());
    }
    this->ignite();
    for (Index turn = 0; !this->front.empty(); turn = (turn + 1) % 4096)
    {
      execution.pollAt(turn);
      const auto [when, sector] = this->front.top();
      this->front.pop();
      if (!this->burnt[sector]) // else an earlier offer came first
      {
        this->burn(sector, when);
      }
    }
  }

  /// Burn time minus radius at each corner.
  double thickness(Index corner) const
  {
    return this->time[this->sectors.sectorOf(corner)] -
      this->axis.radii[this->sectors.pointOf(corner)];
  }

private:
  void offer(Index corner, double when)
  {
    const Index sector = this->sectors.sectorOf(corner);
    when = std::max(when, this->axis.radii[this->sectors.pointOf(corner)]);
    if (!this->burnt[sector] && when < this->time[sector])
    {
      this->time[sector] = when;
      this->front.push({ when, sector });
    }
  }

  void ignite()
  {
    for (Index e = 0; e < count(this->edges.points); ++e)
    {
      for (const Index p : this->edges.points[e])
      {
        if (this->edges.triangles[e].size() == 1)
        {
          this->offer(this->sectors.cornerAt(this->edges.triangles[e][0], p), 0);
        }
      }
    }
    for (Index corner = this->sectors.firstOfLines(); corner < count(this->time); ++corner)
    {
      if (this->sectorsLeft[this->sectors.pointOf(corner)] == 1)
      {
        this->offer(corner, 0);
      }
    }
  }

  void burn(Index sector, double when)
  {
    this->burnt[sector] = 1;
    this->sectors.forCornersOf(sector, [&](Index corner) {
      if (this->sectors.isOfLine(corner))
      {
        const Index other = this->sectors.otherEndOfLine(corner);
        this->offer(other, when + this->distance(corner, other));
        return;
      }
      this->expose(corner, when);
      const Index first = corner - corner % 3;
      const Index next = first + (corner + 1) % 3, last = first + (corner + 2) % 3;
      this->spread(corner, next, last, when);
      this->spread(corner, last, next, when);
    });
    const Index p = this->sectors.pointOf(sector);
    if (--this->sectorsLeft[p] == 1)
    {
      // If what is left at the point is a line, the fire now runs into it; a sheet waits for its seam.
      this->sectors.forLinesAt(p, [&](Index corner) { this->offer(corner, when); });
    }
  }

  double distance(Index a, Index b) const { return (this->place(a) - this->place(b)).norm(); }

  /// Over the two edges at a burnt corner into the last triangle there.
  void expose(Index corner, double when)
  {
    const Index p = this->sectors.pointOf(corner);
    const Triangle& sides = this->edges.ofTriangle[corner / 3];
    for (const Index e : { sides[corner % 3], sides[(corner + 2) % 3] })
    {
      const int end = this->edges.points[e][0] == p ? 0 : 1;
      if (--this->trianglesLeft[2 * e + end] != 1 || this->edges.triangles[e].size() < 3)
      {
        continue;
      }
      for (const Index t : this->edges.triangles[e])
      {
        this->offer(this->sectors.cornerAt(t, p), when);
      }
    }
  }

  /// From one corner of a triangle; and straight on from it and the other one, if that has burnt.
  void spread(Index from, Index to, Index other, double when)
  {
    if (this->burnt[this->sectors.sectorOf(to)])
    {
      return;
    }
    double arrival = when + this->distance(from, to);
    const double otherTime = this->timeOf(other);
    if (otherTime <= when && this->isCrossed(from, other))
    {
      const double straight =
        straightOn(this->place(from), when, this->place(other), otherTime, this->place(to));
      arrival = std::min(arrival, std::max(when, straight));
    }
    this->offer(to, arrival);
  }

  /// Has one front come over the edge between two burnt corners of a triangle? On the border and at
  /// seams it starts there. Where two fronts met behind the edge, none goes on as a straight one.
  bool isCrossed(Index a, Index b) const
  {
    const Triangle& sides = this->edges.ofTriangle[a / 3];
    const Index e = (a + 1) % 3 == b % 3 ? sides[a % 3] : sides[b % 3];
    const IndexLists::View at = this->edges.triangles[e];
    if (at.size() != 2)
    {
      return true;
    }
    const Index behind = at[0] == a / 3 ? at[1] : at[0];
    const Index pointOfA = this->sectors.pointOf(a), pointOfB = this->sectors.pointOf(b);
    Index third = 3 * behind;
    while (this->sectors.pointOf(third) == pointOfA || this->sectors.pointOf(third) == pointOfB)
    {
      ++third;
    }
    const double time = this->timeOf(third);
    return time < never &&
      isOneFront(
        this->place(a), this->timeOf(a), this->place(b), this->timeOf(b), this->place(third), time);
  }

  const Point& place(Index corner) const
  {
    return this->axis.points[this->sectors.pointOf(corner)];
  }

  /// Of a burnt corner; never for others.
  double timeOf(Index corner) const
  {
    const Index sector = this->sectors.sectorOf(corner);
    return this->burnt[sector] ? this->time[sector] : never;
  }

  const AxisComplex& axis;
  const Sectors& sectors;
  const AxisEdges& edges;
  std::vector<double> time;         ///< of each sector, by its lowest corner; final when it burns
  std::vector<char> burnt;          ///< of each sector
  std::vector<Index> sectorsLeft;   ///< unburnt, for each point
  std::vector<Index> trianglesLeft; ///< unburnt, for each end of each edge

  using Event = std::pair<double, Index>;
  std::priority_queue<Event, std::vector<Event>, std::greater<>> front; ///< (time, sector)
};
}

Erosion erosion(const AxisComplex& axis, const Execution& execution)
{
  const Sectors sectors(axis.cells, count(axis.points));
  execution.poll();
  const Fire fire(axis, sectors, execution);
  double largest = boundingDiagonal(maximalBalls(axis));
  for (Index corner = 0; corner < sectors.cornerCount(); ++corner)
  {
    const double thickness = fire.thickness(corner);
    largest = std::isfinite(thickness) ? std::max(largest, thickness) : largest;
  }
  Erosion result;
  result.ofPoint.assign(axis.points.size(), 0);
  result.ofCell.assign(axis.cells.size(), 0);
  for (Index corner = 0; corner < sectors.cornerCount(); ++corner)
  {
    const double thickness = std::min(largest, fire.thickness(corner));
    double& ofPoint = result.ofPoint[sectors.pointOf(corner)];
    double& ofCell = result.ofCell[sectors.cellOf(corner)];
    ofPoint = std::max(ofPoint, thickness);
    ofCell = std::max(ofCell, thickness);
  }
  return result;
}
}
