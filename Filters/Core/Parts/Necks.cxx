// SPDX-License-Identifier: BSD-3-Clause
#include "Parts/Necks.h"

#include "Base/BallTree.h"
#include "Base/Lists.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

// Bodies grow one after the other, each from the thickest point of a piece of what is left. What a growth
// leaves over of its piece falls into new pieces, so each point is taken by exactly one growth. A growth
// that is no limb, because it is too thick or its cut too long, belongs to the body next to it.
//
// Each growth takes O(m log m) time for the m points of its piece. With few limbs, as usual, this is
// O(n log n) for the n points of the axis.

namespace medial
{
namespace
{
constexpr double trunkRatio = 0.7; ///< what belongs to a body for its radius / its largest radius
constexpr double dipRatio = 0.8;  ///< radius where pieces part / the smaller of their largest radii
constexpr double longestCut = 20; ///< its square / area cut off

/// The points that share an edge with each point, ascending.
IndexLists neighborsOfPoints(const AxisEdges& edges, Index pointCount)
{
  IndexLists result = listsByKey(pointCount, [&edges](const auto& add) {
    for (const Edge& edge : edges.points)
    {
      add(edge[0], edge[1]);
      add(edge[1], edge[0]);
    }
  });
  result.sortEach();
  return result;
}

/// The order in which points are taken: large radii first, of equal ones the lower number.
struct Thickness
{
  const std::vector<double>& radii;

  bool isThicker(Index a, Index b) const
  {
    return this->radii[a] > this->radii[b] || (this->radii[a] == this->radii[b] && a < b);
  }

  /// The corner that decides to which body a cell belongs.
  template <typename Corners>
  Index thickest(const Corners& corners) const
  {
    return *std::min_element(
      corners.begin(), corners.end(), [this](Index a, Index b) { return this->isThicker(a, b); });
  }
};

/// Cuts points into pieces, at their gaps and, if asked for, at dips of the radius. Each point goes to
/// the peak that the steepest way up leads to. Where ways to two peaks meet, the lower peak is part of
/// the higher one unless the radius dips there.
/// @return  by their peaks' numbers, the points of each thickest first
std::vector<std::vector<Index>> piecesOf(std::vector<Index> points, const Thickness& thickness,
  const IndexLists& neighbors, bool cutsAtDips)
{
  std::sort(points.begin(), points.end(),
    [&thickness](Index a, Index b) { return thickness.isThicker(a, b); });
  std::map<Index, Index> higher; // peak: the peak it belongs to; point: a peak
  const auto peakOf = [&higher](Index p) {
    while (higher.at(p) != p)
    {
      p = higher.at(p);
    }
    return p;
  };
  for (const Index p : points)
  {
    // Thicker points have their peaks already. All of them that are next to p meet here.
    Index up = None, highest = None;
    std::vector<Index> peaks;
    for (const Index n : neighbors[p])
    {
      if (higher.count(n))
      {
        up = up == None || thickness.isThicker(n, up) ? n : up;
        peaks.push_back(peakOf(n));
        const Index peak = peaks.back();
        highest = highest == None || thickness.isThicker(peak, highest) ? peak : highest;
      }
    }
    higher[p] = up == None ? p : peakOf(up);
    for (const Index peak : peaks)
    {
      const bool isDip = thickness.radii[p] <= dipRatio * thickness.radii[peak];
      if (peak != highest && !(cutsAtDips && isDip))
      {
        higher[peak] = highest;
      }
    }
  }
  std::map<Index, std::vector<Index>> pieces;
  for (const Index p : points)
  {
    pieces[peakOf(p)].push_back(p);
  }
  std::vector<std::vector<Index>> result;
  result.reserve(pieces.size());
  for (auto& piece : pieces)
  {
    result.push_back(std::move(piece.second));
  }
  return result;
}

/// Grows bodies, the one after the other, until each point is in one.
class Anatomy
{
public:
  Anatomy(const MedialAxis& medialAxis, const AxisEdges& axisEdges, double neckRatio)
    : axis(medialAxis)
    , edges(axisEdges)
    , ratio(neckRatio)
    , thickness{ medialAxis.radii }
    , neighbors(neighborsOfPoints(axisEdges, count(medialAxis.points)))
    , grownIn(medialAxis.points.size(), None)
    , pieceOf(medialAxis.points.size(), None)
  {
    this->trianglesOfPoint = listsByKey(count(this->axis.points), [this](const auto& add) {
      for (Index t = 0; t < count(this->axis.cells.triangles); ++t)
      {
        add(this->thickness.thickest(this->axis.cells.triangles[t]), t);
      }
    });
  }

  Bodies run()
  {
    std::vector<Index> points(this->axis.points.size());
    std::iota(points.begin(), points.end(), 0);
    this->addPieces(std::move(points), None);
    while (!this->todo.empty())
    {
      const Piece piece = std::move(this->todo.back());
      this->todo.pop_back();
      this->grow(piece);
    }
    return this->result();
  }

private:
  struct Piece
  {
    std::vector<Index> points; ///< thickest first
    Index nextTo;              ///< the growth that it was left over by
  };

  struct Growth
  {
    double radius;    ///< the largest
    Index body;       ///< the growth whose body it is part of: itself, if it is a limb
    double neckRatio; ///< of a limb, else 1
  };

  /// What is next to a body is cut at dips, too: it may be several limbs that touch.
  void addPieces(std::vector<Index> points, Index nextTo)
  {
    const bool cutsAtDips = nextTo != None;
    for (std::vector<Index>& piece :
      piecesOf(std::move(points), this->thickness, this->neighbors, cutsAtDips))
    {
      this->todo.push_back({ std::move(piece), nextTo });
    }
  }

  void grow(const Piece& piece)
  {
    const Index number = count(this->growths);
    for (const Index p : piece.points)
    {
      this->pieceOf[p] = number;
    }
    const double radius = this->axis.radii[piece.points[0]];
    const std::vector<Index> grown = this->growthOf(piece, number, radius);
    Growth growth{ radius, number, 1 };
    if (piece.nextTo != None)
    {
      const Growth& other = this->growths[piece.nextTo];
      const bool isLimb = radius <= this->ratio * other.radius && this->isCutShort(grown, number);
      growth.body = isLimb ? number : other.body;
      growth.neckRatio = isLimb ? radius / other.radius : 1;
    }
    this->growths.push_back(growth);
    std::vector<Index> rest;
    std::copy_if(piece.points.begin(), piece.points.end(), std::back_inserter(rest),
      [&](Index p) { return this->grownIn[p] != number; });
    this->addPieces(std::move(rest), number);
  }

  /// The points of a piece that a body takes from its thickest point.
  std::vector<Index> growthOf(const Piece& piece, Index number, double radius)
  {
    std::vector<Index> grown{ piece.points[0] };
    this->grownIn[grown[0]] = number;
    const auto spread = [&](const auto& accept) {
      for (std::size_t i = 0; i < grown.size(); ++i)
      {
        for (const Index n : this->neighbors[grown[i]])
        {
          if (this->pieceOf[n] == number && this->grownIn[n] != number && accept(n))
          {
            this->grownIn[n] = number;
            grown.push_back(n);
          }
        }
      }
    };
    spread([&](Index p) { return this->axis.radii[p] >= trunkRatio * radius; });
    // What lies inside the balls of the trunk adds no shape of its own: it can be no limb.
    std::vector<Ball> balls;
    balls.reserve(grown.size());
    for (const Index p : grown)
    {
      balls.push_back({ this->axis.points[p], this->axis.radii[p] });
    }
    constexpr Index all = 0, none = 1; // groups of balls: all are in one, none is left out
    const BallTree tree(balls, std::vector<Index>(balls.size(), all));
    spread([&](Index p) { return tree.protrusion({ this->axis.points[p], 0 }, none) <= 0; });
    return grown;
  }

  /// Is the border of what has grown with all outside its piece short for its area?
  bool isCutShort(const std::vector<Index>& grown, Index number) const
  {
    double area = 0, cut = 0;
    for (const Index p : grown)
    {
      for (const Index t : this->trianglesOfPoint[p])
      {
        area += triangleArea(this->axis, this->axis.cells.triangles[t]);
        for (const Index e : this->edges.ofTriangle[t])
        {
          cut += this->isBorder(e, t, number) ? this->length(e) : 0;
        }
      }
    }
    return area > 0 && cut * cut <= longestCut * area;
  }

  /// Is the triangle the first one at the edge that has grown, and another one outside the piece?
  bool isBorder(Index edge, Index triangle, Index number) const
  {
    bool hasOther = false;
    for (const Index t : this->edges.triangles[edge])
    {
      const Index top = this->thickness.thickest(this->axis.cells.triangles[t]);
      if (t < triangle && this->grownIn[top] == number)
      {
        return false;
      }
      hasOther = hasOther || this->pieceOf[top] != number;
    }
    return hasOther;
  }

  double length(Index edge) const
  {
    const Edge& ends = this->edges.points[edge];
    return (this->axis.points[ends[1]] - this->axis.points[ends[0]]).norm();
  }

  Bodies result() const
  {
    Bodies bodies;
    std::vector<Index> numbers(this->growths.size(), None);
    for (std::size_t i = 0; i < this->growths.size(); ++i)
    {
      if (this->growths[i].body == static_cast<Index>(i))
      {
        numbers[i] = count(bodies.neckRatio);
        bodies.neckRatio.push_back(this->growths[i].neckRatio);
      }
    }
    const auto add = [&](const auto& corners) {
      const Index growth = this->grownIn[this->thickness.thickest(corners)];
      bodies.ofCell.push_back(numbers[this->growths[growth].body]);
    };
    for (const Index vertex : this->axis.cells.vertices)
    {
      add(std::array<Index, 1>{ vertex });
    }
    std::for_each(this->axis.cells.edges.begin(), this->axis.cells.edges.end(), add);
    std::for_each(this->axis.cells.triangles.begin(), this->axis.cells.triangles.end(), add);
    return bodies;
  }

  const MedialAxis& axis;
  const AxisEdges& edges;
  double ratio; ///< of the largest radii of a limb and of its body, at most
  Thickness thickness;
  IndexLists neighbors;
  IndexLists trianglesOfPoint;         ///< those that it is the thickest corner of
  std::vector<Index> grownIn, pieceOf; ///< for each point the growth; None: not yet
  std::vector<Piece> todo;
  std::vector<Growth> growths;
};
}

Bodies bodies(const MedialAxis& axis, const AxisEdges& edges, double neckRatio)
{
  return Anatomy(axis, edges, neckRatio).run();
}
}
