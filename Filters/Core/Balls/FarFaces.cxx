// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/FarFaces.h"

#include "Base/Frame.h"
#include "Base/Lists.h"
#include "Base/Neighbors.h"
#include "Base/Predicates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

// Where samples are dense, inner and outer balls barely intersect, or barely miss each other, and the faces between
// them are on the surface. Only the few faces between other balls are looked at.
namespace medial
{
namespace
{
/// A cell of the triangulation at an edge between an inner and an outer ball.
using EdgeCell = std::pair<Edge, Index>;

bool isOdd(const PolarBalls& balls, Index a, Index b)
{
  constexpr double most = 0.05; // measured; where samples are dense it is below that
  return a < b && balls.sides[a] != balls.sides[b] &&
    std::abs(intersectionDepth(balls.balls[a], balls.balls[b]) + 1) > most;
}

/// All of them, those of an edge in one list.
Lists<EdgeCell> oddEdges(const PolarBalls& balls)
{
  const std::vector<Tetrahedron>& cells = balls.triangulation.cells;
  std::vector<EdgeCell> odd;
  for (Index c = 0; c < count(cells); ++c)
  {
    for (const Index a : cells[c])
    {
      for (const Index b : cells[c])
      {
        if (isOdd(balls, a, b))
        {
          odd.push_back({ { a, b }, c });
        }
      }
    }
  }
  Lists<EdgeCell> ofBall = listsByKey<EdgeCell>(count(balls.balls), [&odd](const auto& add) {
    for (const EdgeCell& each : odd)
    {
      add(each.first[0], each);
    }
  });
  ofBall.sortEach();
  Lists<EdgeCell> result;
  result.items.reserve(odd.size());
  for (const EdgeCell& each : ofBall.items)
  {
    if (!result.items.empty() && result.items.back().first != each.first)
    {
      result.close();
    }
    result.items.push_back(each);
  }
  if (!result.items.empty())
  {
    result.close();
  }
  return result;
}

/// Measures how far places are from the surface.
class Distances
{
public:
  Distances(const PolarBalls& theBalls, const std::vector<SurfacePoint>& theSamples,
    const SurfaceTree& theSolid, double theMost, const PlaceTest& theLeftOut,
    const Execution& execution)
    : balls(theBalls)
    , samples(theSamples)
    , solid(theSolid)
    , most(theMost)
    , isLeftOut(theLeftOut)
    , neighbors(theBalls.samples)
    , spacings(meanDistances(theBalls.samples, this->neighbors, execution))
    , frame(frameOf(theBalls.samples))
  {
  }

  /// The farthest of some places on the face between two balls, if it is too far.
  /// @param cells  at the edge between the balls
  std::optional<FarFace> farthest(const Lists<EdgeCell>::View& cells) const
  {
    const Edge& edge = cells[0].first;
    std::vector<Point> corners;
    corners.reserve(cells.size());
    Point middle = Point::Zero();
    for (const auto& [same, c] : cells)
    {
      corners.push_back(this->vertex(this->balls.triangulation.cells[c]));
      middle += corners.back() / cells.size();
    }
    const std::vector<Index> around = this->samplesOf(edge);
    const Index nearest = *std::min_element(around.begin(), around.end(), [&](Index a, Index b) {
      return this->squaredDistance(middle, a) < this->squaredDistance(middle, b);
    });
    // Samples and their triangles tell of most places that they are near enough, at less cost.
    constexpr double less = 0.6; // so much at least is the spacing at the place itself
    const double enough = less * this->most * this->spacings[nearest];
    std::optional<FarFace> result = this->farPlace(middle, around, enough);
    for (const Point& place : this->placesOf(edge, corners, middle))
    {
      const auto far = this->farPlace(place, around, enough);
      if (far && (!result || far->distance > result->distance))
      {
        result = far;
      }
    }
    return result;
  }

private:
  Point vertex(const Tetrahedron& cell) const
  {
    const Index sample = lowestCommonItem(this->balls.ballSamples, cell);
    if (sample != None)
    {
      return this->balls.samples[sample];
    }
    const auto ball = [&](int k) { return this->frame.toLocal(this->balls.balls[cell[k]]); };
    return this->frame.toWorld(
      powerCenter({ ball(0), ball(1), ball(2), ball(3) }, constructionError));
  }

  /// Places all over the face between two balls, but for its middle.
  std::vector<Point> placesOf(
    const Edge& edge, const std::vector<Point>& corners, const Point& middle) const
  {
    const Point across = this->balls.balls[edge[1]].center - this->balls.balls[edge[0]].center;
    const Point u = across.unitOrthogonal(), v = across.cross(u).normalized();
    std::vector<std::pair<double, Point>> around; // by angle
    around.reserve(corners.size());
    for (const Point& p : corners)
    {
      around.emplace_back(std::atan2((p - middle).dot(v), (p - middle).dot(u)), p);
    }
    std::sort(
      around.begin(), around.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Point> result;
    result.reserve(4 * around.size());
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      const Point &corner = around[i].second, &next = around[(i + 1) % around.size()].second;
      result.push_back(corner);
      result.emplace_back((corner + 2 * middle) / 3);
      result.emplace_back((2 * corner + middle) / 3);
      result.emplace_back((corner + next) / 2);
    }
    return result;
  }

  std::vector<Index> samplesOf(const Edge& edge) const
  {
    std::vector<Index> result;
    for (const Index ball : edge)
    {
      const auto own = this->balls.ballSamples[ball];
      result.insert(result.end(), own.begin(), own.end());
    }
    return result;
  }

  double squaredDistance(const Point& place, Index sample) const
  {
    return (this->balls.samples[sample] - place).squaredNorm();
  }

  /// How far a place is from the samples around, or from their triangles, if that is less; any distance below `enough`
  /// will do.
  double distanceFrom(const std::vector<Index>& around, const Point& place, double enough) const
  {
    const auto isAt = [&](Index s) { return this->squaredDistance(place, s) < enough * enough; };
    if (std::any_of(around.begin(), around.end(), isAt))
    {
      return 0;
    }
    double result = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < around.size() && result >= enough; ++i)
    {
      result = std::min(result, this->solid.distance(place, this->samples[around[i]].triangle));
    }
    return result;
  }

  /// @param enough  nearer is near enough by the samples around
  std::optional<FarFace> farPlace(
    const Point& place, const std::vector<Index>& around, double enough) const
  {
    const double atMost = this->distanceFrom(around, place, enough);
    if (atMost < enough)
    {
      return {};
    }
    const Index nearest = this->neighbors.nearestOne(place);
    if (nearest == None) // the centre of a flat cell: not a number
    {
      return {};
    }
    const double here = this->spacings[nearest];
    constexpr double rounding = 1e-9;
    if (atMost < (1 - rounding) * this->most * here)
    {
      return {};
    }
    const double distance = (this->solid.nearest(place).point - place).norm() / here;
    return distance > this->most && !(this->isLeftOut && this->isLeftOut(place, here))
      ? FarFace{ place, distance, here }
      : std::optional<FarFace>();
  }

  const PolarBalls& balls;
  const std::vector<SurfacePoint>& samples;
  const SurfaceTree& solid;
  double most;
  const PlaceTest& isLeftOut;
  Neighbors neighbors;
  std::vector<double> spacings; ///< at the samples
  Frame frame;
};
}

std::vector<FarFace> farFaces(const PolarBalls& balls, const std::vector<SurfacePoint>& samples,
  const SurfaceTree& solid, double most, const PlaceTest& isLeftOut, const Execution& execution)
{
  const Lists<EdgeCell> faces = oddEdges(balls);
  const Distances distances(balls, samples, solid, most, isLeftOut, execution);
  std::vector<std::optional<FarFace>> far(faces.size());
  execution.forEach(faces.size(), [&](Index f) { far[f] = distances.farthest(faces[f]); });
  std::vector<FarFace> result;
  for (const std::optional<FarFace>& each : far)
  {
    if (each)
    {
      result.push_back(*each);
    }
  }
  return result;
}
}
