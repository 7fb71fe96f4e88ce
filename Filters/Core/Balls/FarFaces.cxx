// SPDX-License-Identifier: BSD-3-Clause
#include "Balls/FarFaces.h"

#include "Base/Frame.h"
#include "Base/Lists.h"
#include "Base/Neighbors.h"
#include "Base/Predicates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
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

/// Shares of the three corners of a triangle.
using Shares = std::array<double, 3>;

/// Places all over a triangle, but for its first corner and the side to its third one.
/// @param divisions  of each side
std::vector<Shares> grid(int divisions)
{
  std::vector<Shares> result;
  for (int i = 1; i <= divisions; ++i)
  {
    for (int k = 0; k < i; ++k)
    {
      result.push_back(
        { 1 - i / double(divisions), (i - k) / double(divisions), k / double(divisions) });
    }
  }
  return result;
}

/// The face between two balls: triangles around its middle.
struct Fan
{
  Point middle = Point::Zero();
  std::vector<Point> corners; ///< in order around it
};

/// Makes the faces at edges, each corner once.
class Fans
{
public:
  /// @param faces  will be asked for
  Fans(const PolarBalls& theBalls, const Lists<EdgeCell>& faces, const Execution& execution)
    : balls(theBalls)
    , frame(frameOf(theBalls.samples))
    , vertices(theBalls.triangulation.cells.size())
  {
    std::vector<char> isUsed(this->vertices.size(), 0);
    for (const EdgeCell& each : faces.items)
    {
      isUsed[each.second] = 1;
    }
    execution.forEach(count(isUsed), [&](Index c) {
      if (isUsed[c])
      {
        this->vertices[c] = this->vertex(theBalls.triangulation.cells[c]);
      }
    });
  }

  /// @param cells  at the edge
  Fan at(const Lists<EdgeCell>::View& cells) const
  {
    const Edge& edge = cells[0].first;
    Fan result;
    std::vector<Point> corners;
    corners.reserve(cells.size());
    for (const auto& [same, c] : cells)
    {
      corners.push_back(this->vertices[c]);
      result.middle += corners.back() / cells.size();
    }
    const Point across = this->balls.balls[edge[1]].center - this->balls.balls[edge[0]].center;
    const Point u = across.unitOrthogonal(), v = across.cross(u).normalized();
    std::vector<std::pair<double, Index>> order; // by angle
    order.reserve(corners.size());
    for (const Point& p : corners)
    {
      order.emplace_back(
        std::atan2((p - result.middle).dot(v), (p - result.middle).dot(u)), count(order));
    }
    std::sort(order.begin(), order.end());
    for (const auto& [angle, i] : order)
    {
      result.corners.push_back(corners[i]);
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

  const PolarBalls& balls;
  Frame frame;
  std::vector<Point> vertices; ///< of the power diagram, by cells; those of the faces
};

/// Measures how far places are from the surface.
class Distances
{
public:
  /// @param faces  will be measured
  Distances(const PolarBalls& theBalls, const std::vector<SurfacePoint>& theSamples,
    const SurfaceTree& theSolid, double most, const PlacesLeftOut& theLeftOut,
    const Lists<EdgeCell>& faces, const Execution& execution)
    : balls(theBalls)
    , samples(theSamples)
    , solid(theSolid)
    , leftOut(theLeftOut)
    , neighbors(theBalls.samples)
    , spacings(meanDistances(theBalls.samples, this->neighbors, execution))
    , fans(theBalls, faces, execution)
  {
    constexpr double nearly = 0.8; // of the distance: then more places may be worth it
    this->quick = { { { 0, 1, 0 }, { 2 / 3.0, 1 / 3.0, 0 }, { 0, 0.5, 0.5 }, { 0.5, 0.25, 0.25 } },
      nearly * most, 0.5 };
    this->thorough = { grid(6), most, 1 };
  }

  /// The farthest of some places on the face between two balls, if it is too far.
  /// @param cells  at the edge between the balls
  std::optional<FarFace> farthest(const Lists<EdgeCell>::View& cells) const
  {
    const Edge& edge = cells[0].first;
    const Fan face = this->fans.at(cells);
    const std::vector<Index> around = this->samplesOf(edge);
    return this->farthest(face, this->quick, around) ? this->farthest(face, this->thorough, around)
                                                     : std::optional<FarFace>();
  }

private:
  /// Where to look on a face, and what to find.
  struct Look
  {
    std::vector<Shares> places; ///< in each triangle, whose first corner is the middle of the face
    double least;               ///< distance that counts, in spacings
    double margin; ///< so much of the spacing is given to the test for places that are left out
  };

  /// @param around  samples of the balls
  std::optional<FarFace> farthest(
    const Fan& face, const Look& look, const std::vector<Index>& around) const
  {
    const Index nearest = this->nearestOf(around, face.middle);
    // Samples and their triangles tell of most places that they are near enough, at less cost.
    constexpr double less = 0.6; // so much at least is the spacing at the place itself
    const double enough = less * look.least * this->spacings[nearest];
    if (this->isAlong(this->samples[nearest].triangle, face, enough))
    {
      return {};
    }
    std::optional<FarFace> result = this->farPlace(face.middle, around, enough, look);
    for (std::size_t i = 0; i < face.corners.size(); ++i)
    {
      const Point &corner = face.corners[i], &next = face.corners[(i + 1) % face.corners.size()];
      for (const Shares& share : look.places)
      {
        const Point place = share[0] * face.middle + share[1] * corner + share[2] * next;
        const auto far = this->farPlace(place, around, enough, look);
        if (far && (!result || far->distance > result->distance))
        {
          result = far;
        }
      }
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

  Index nearestOf(const std::vector<Index>& someSamples, const Point& place) const
  {
    Index result = someSamples.front();
    double least = std::numeric_limits<double>::infinity();
    for (const Index sample : someSamples)
    {
      const double squared = this->squaredDistance(place, sample);
      if (squared < least)
      {
        least = squared;
        result = sample;
      }
    }
    return result;
  }

  /// Is all of a face near one triangle? It is where its corners are, as triangles are convex.
  bool isAlong(Index triangle, const Fan& face, double near) const
  {
    const auto isNear = [&](const Point& place) {
      return this->solid.distance(place, triangle) < near;
    };
    return isNear(face.middle) && std::all_of(face.corners.begin(), face.corners.end(), isNear);
  }

  /// How far a place is from the samples around, or from their triangles, if that is less; any distance below `enough`
  /// will do.
  double distanceFrom(const std::vector<Index>& around, const Point& place, double enough) const
  {
    const Index nearest = this->nearestOf(around, place); // most often its triangle is near enough
    if (this->squaredDistance(place, nearest) < enough * enough)
    {
      return 0;
    }
    const auto toTriangle = [&](Index s) {
      return this->solid.distance(place, this->samples[s].triangle);
    };
    double result = toTriangle(nearest);
    for (std::size_t i = 0; i < around.size() && result >= enough; ++i)
    {
      result = std::min(result, toTriangle(around[i]));
    }
    return result;
  }

  /// @param enough  nearer is near enough by the samples around
  std::optional<FarFace> farPlace(
    const Point& place, const std::vector<Index>& around, double enough, const Look& look) const
  {
    if (this->leftOut.elsewhere && this->leftOut.elsewhere(place))
    {
      return {};
    }
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
    if (atMost < (1 - rounding) * look.least * here)
    {
      return {};
    }
    const SurfacePoint& sample = this->samples[nearest];
    const SurfaceTree::Place known{ sample.position, sample.triangle };
    const double distance = (this->solid.nearest(place, known).point - place).norm() / here;
    const bool counts = distance > look.least &&
      !(this->leftOut.near && this->leftOut.near(place, look.margin * here));
    return counts ? FarFace{ place, distance, here } : std::optional<FarFace>();
  }

  const PolarBalls& balls;
  const std::vector<SurfacePoint>& samples;
  const SurfaceTree& solid;
  const PlacesLeftOut& leftOut;
  Neighbors neighbors;
  std::vector<double> spacings; ///< at the samples
  Fans fans;
  Look quick, thorough;
};
}

std::vector<FarFace> farFaces(const PolarBalls& balls, const std::vector<SurfacePoint>& samples,
  const SurfaceTree& solid, double most, const PlacesLeftOut& leftOut, const Execution& execution)
{
  const Lists<EdgeCell> faces = oddEdges(balls);
  const Distances distances(balls, samples, solid, most, leftOut, faces, execution);
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
