// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Erosion.h"

#include "Axis/AxisEdges.h"
#include "Base/BallTree.h"
#include "Base/DisjointSets.h"
#include "Base/Lists.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

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

/// The cells of the axis as the fire sees them. A corner is where a cell has a point: 3 t + k for the
/// triangles, then 2 e + k for the lines. A sector is the corners at a point of triangles that hang
/// together over edges with exactly two; or one corner of a line. It burns as a whole.
class Fire
{
public:
  explicit Fire(const AxisComplex& theAxis)
    : axis(theAxis)
    , edges(axisEdges(theAxis.cells))
    , firstOfLines(3 * count(theAxis.cells.triangles))
    , time(firstOfLines + 2 * count(theAxis.cells.edges), never)
    , sectorOf(time.size(), None)
    , burnt(time.size(), 0)
    , nextOfSector(time.size(), None)
    , sectorsAt(theAxis.points.size(), 0)
    , lineAt(theAxis.points.size(), None)
    , nextLine(2 * theAxis.cells.edges.size(), None)
    , trianglesLeft(2 * this->edges.points.size(), 0)
  {
    this->joinCorners();
    this->ignite();
    while (!this->front.empty())
    {
      const auto [when, sector] = this->front.top();
      this->front.pop();
      if (!this->burnt[sector])
      {
        this->burn(sector, when);
      }
    }
  }

  /// Burn time minus radius at each corner.
  double thickness(Index corner) const
  {
    return this->time[this->sectorOf[corner]] - this->axis.radii[this->pointOf(corner)];
  }

  Index cornerCount() const { return count(this->time); }
  Index pointOf(Index corner) const
  {
    const Index line = corner - this->firstOfLines;
    return line < 0 ? this->axis.cells.triangles[corner / 3][corner % 3]
                    : this->axis.cells.edges[line / 2][line % 2];
  }
  Index cellOf(Index corner) const
  {
    const Index line = corner - this->firstOfLines;
    return line < 0 ? this->axis.cells.firstTriangle() + corner / 3
                    : this->axis.cells.firstEdge() + line / 2;
  }

private:
  Index cornerAt(Index triangle, Index point) const
  {
    const Triangle& t = this->axis.cells.triangles[triangle];
    return 3 * triangle + static_cast<Index>(std::find(t.begin(), t.end(), point) - t.begin());
  }

  void joinCorners()
  {
    DisjointSets sectors(this->cornerCount());
    for (Index e = 0; e < count(this->edges.points); ++e)
    {
      const IndexLists::View at = this->edges.triangles[e];
      for (int end = 0; end < 2; ++end)
      {
        const Index p = this->edges.points[e][end];
        if (at.size() == 2)
        {
          sectors.unite(this->cornerAt(at[0], p), this->cornerAt(at[1], p));
        }
        this->trianglesLeft[2 * e + end] = at.size();
      }
    }
    for (Index corner = this->cornerCount() - 1; corner >= 0; --corner)
    {
      const Index first = this->sectorOf[corner] = sectors.find(corner);
      const Index p = this->pointOf(corner);
      this->sectorsAt[p] += first == corner;
      if (first != corner)
      {
        this->nextOfSector[corner] = this->nextOfSector[first];
        this->nextOfSector[first] = corner;
      }
      if (corner >= this->firstOfLines)
      {
        this->nextLine[corner - this->firstOfLines] = this->lineAt[p];
        this->lineAt[p] = corner;
      }
    }
  }

  void offer(Index corner, double when)
  {
    const Index sector = this->sectorOf[corner];
    when = std::max(when, this->axis.radii[this->pointOf(corner)]);
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
          this->offer(this->cornerAt(this->edges.triangles[e][0], p), 0);
        }
      }
    }
    for (Index corner = this->firstOfLines; corner < this->cornerCount(); ++corner)
    {
      if (this->sectorsAt[this->pointOf(corner)] == 1)
      {
        this->offer(corner, 0);
      }
    }
  }

  void burn(Index sector, double when)
  {
    this->burnt[sector] = 1;
    for (Index corner = sector; corner != None; corner = this->nextOfSector[corner])
    {
      if (corner >= this->firstOfLines)
      {
        const Index other = this->firstOfLines + ((corner - this->firstOfLines) ^ 1);
        this->offer(other, when + this->distance(corner, other));
        continue;
      }
      this->expose(corner, when);
      const Index first = corner - corner % 3;
      const Index next = first + (corner + 1) % 3, last = first + (corner + 2) % 3;
      this->spread(corner, next, last, when);
      this->spread(corner, last, next, when);
    }
    const Index p = this->pointOf(sector);
    if (--this->sectorsAt[p] == 1)
    {
      this->exposeLine(p, when);
    }
  }

  double distance(Index a, Index b) const
  {
    return (this->axis.points[this->pointOf(a)] - this->axis.points[this->pointOf(b)]).norm();
  }

  /// Over the two edges at a burnt corner into the last triangle there.
  void expose(Index corner, double when)
  {
    const Index p = this->pointOf(corner);
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
        this->offer(this->cornerAt(t, p), when);
      }
    }
  }

  /// Into a line at a point where all else has burnt.
  void exposeLine(Index p, double when)
  {
    for (Index corner = this->lineAt[p]; corner != None;
         corner = this->nextLine[corner - this->firstOfLines])
    {
      this->offer(corner, when);
    }
  }

  /// From one corner of a triangle; and straight on from it and the other one, if that has burnt.
  void spread(Index from, Index to, Index other, double when)
  {
    if (this->burnt[this->sectorOf[to]])
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
  /// seams it starts there.
  bool isCrossed(Index a, Index b)
  {
    const Triangle& sides = this->edges.ofTriangle[a / 3];
    const Index e = (a + 1) % 3 == b % 3 ? sides[a % 3] : sides[b % 3];
    const IndexLists::View at = this->edges.triangles[e];
    if (at.size() != 2)
    {
      return true;
    }
    const Index behind = at[0] == a / 3 ? at[1] : at[0];
    Index third = 3 * behind;
    while (this->pointOf(third) == this->pointOf(a) || this->pointOf(third) == this->pointOf(b))
    {
      ++third;
    }
    const double time = this->timeOf(third);
    return time < never &&
      isOneFront(
        this->place(a), this->timeOf(a), this->place(b), this->timeOf(b), this->place(third), time);
  }

  const Point& place(Index corner) const { return this->axis.points[this->pointOf(corner)]; }

  /// Of a burnt corner; never for others.
  double timeOf(Index corner)
  {
    const Index sector = this->sectorOf[corner];
    return this->burnt[sector] ? this->time[sector] : never;
  }

  const AxisComplex& axis;
  AxisEdges edges;
  Index firstOfLines;
  std::vector<double> time;         ///< of each sector, by its first corner
  std::vector<Index> sectorOf;      ///< for each corner the first of its sector
  std::vector<char> burnt;          ///< of each sector
  std::vector<Index> nextOfSector;  ///< for each corner
  std::vector<Index> sectorsAt;     ///< unburnt, for each point
  std::vector<Index> lineAt;        ///< for each point the first corner of a line there
  std::vector<Index> nextLine;      ///< for each corner of a line
  std::vector<Index> trianglesLeft; ///< unburnt, for each end of each edge

  using Event = std::pair<double, Index>;
  std::priority_queue<Event, std::vector<Event>, std::greater<>> front;
};
}

Erosion erosion(const AxisComplex& axis)
{
  Fire fire(axis);
  std::vector<Ball> balls;
  for (Index p = 0; p < count(axis.points); ++p)
  {
    balls.push_back({ axis.points[p], axis.radii[p] });
  }
  double largest = boundingDiagonal(balls);
  for (Index corner = 0; corner < fire.cornerCount(); ++corner)
  {
    const double thickness = fire.thickness(corner);
    largest = std::isfinite(thickness) ? std::max(largest, thickness) : largest;
  }
  Erosion result;
  result.ofPoint.assign(axis.points.size(), 0);
  result.ofCell.assign(axis.cells.size(), 0);
  for (Index corner = 0; corner < fire.cornerCount(); ++corner)
  {
    const double thickness = std::min(largest, fire.thickness(corner));
    double& ofPoint = result.ofPoint[fire.pointOf(corner)];
    double& ofCell = result.ofCell[fire.cellOf(corner)];
    ofPoint = std::max(ofPoint, thickness);
    ofCell = std::max(ofCell, thickness);
  }
  return result;
}
}
