// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/VolumeThickness.h"

#include "Base/Errors.h"
#include "Base/Frame.h"
#include "Base/Lists.h"
#include "Measuring/LargestBalls.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace medial
{
namespace
{
/// For each inner ball the outer balls whose power cells touch its own.
IndexLists outerNeighbors(const PolarBalls& balls)
{
  const IndexLists all = listsByKey(count(balls.balls), [&balls](const auto& add) {
    for (const Tetrahedron& cell : balls.triangulation.cells)
    {
      for (const Index a : cell)
      {
        for (const Index b : cell)
        {
          if (balls.sides[a] == Side::Inner && balls.sides[b] == Side::Outer)
          {
            add(a, b);
          }
        }
      }
    }
  });
  IndexLists result;
  std::vector<Index> own;
  for (Index b = 0; b < all.size(); ++b)
  {
    own.assign(all[b].begin(), all[b].end());
    sortUnique(own);
    result.append(own);
  }
  return result;
}

/// Tells the power cells of inner balls from those of outer ones.
class PowerCells
{
public:
  explicit PowerCells(const PolarBalls& theBalls)
    : balls(theBalls.balls)
    , reach(corner * theBalls.spacing)
    , inner(theBalls, Side::Inner)
    , outside(outerNeighbors(theBalls))
  {
  }

  /// The inner ball in whose power cell the place is, or None. A cell is convex: a place is in it that is nearer to none
  /// of its neighbors, and of the inner ones that is sure.
  Index innerBall(const Point& place) const
  {
    if (this->inner.isFar(place, this->reach)) // most places are, and this is quick
    {
      return None;
    }
    const Index nearest = this->inner.leastPower(place);
    if (nearest == None)
    {
      return None;
    }
    const double least = this->power(place, nearest);
    const IndexLists::View others = this->outside[nearest];
    const bool isOutside = std::any_of(
      others.begin(), others.end(), [&](Index b) { return this->power(place, b) < least; });
    return isOutside ? None : nearest;
  }

private:
  /// Only sharp corners of a solid are outside of its balls, within a few sample spacings.
  static constexpr double corner = 5;

  double power(const Point& place, Index b) const
  {
    const double distance = (place - this->balls[b].center).norm();
    return (distance - this->balls[b].radius) * (distance + this->balls[b].radius);
  }

  const std::vector<Ball>& balls;
  double reach;
  LargestBalls inner;
  IndexLists outside;
};

/// A place of the volume, and the inner ball in whose power cell it is; None: it is outside.
struct Place
{
  Point at;
  Index cell;
};

/// Place k of a sequence that fills a box evenly: the additive recurrence whose steps are powers of the root of
/// x^4 = x + 1.
Point evenPoint(Index k, const Eigen::AlignedBox3d& box)
{
  constexpr double root = 1.2207440846057594754;
  const Point steps(1 / root, 1 / (root * root), 1 / (root * root * root));
  const Point along = Point::Constant(0.5) + (k + 1.0) * steps;
  return box.min() + (along - along.array().floor().matrix()).cwiseProduct(box.sizes());
}

/// Places all over the box: as many inside as wanted, but where the solid fills hardly anything of it.
std::vector<Place> evenPlaces(
  const PolarBalls& balls, const Eigen::AlignedBox3d& box, Index inside, const Execution& execution)
{
  constexpr int mostTurns = 20;
  const PowerCells cells(balls);
  std::vector<Place> result;
  Index found = 0;
  for (int turn = 0; turn < mostTurns && found < inside; ++turn)
  {
    const Index first = count(result);
    result.resize(result.size() + inside);
    execution.forEach(inside, [&](Index i) {
      const Point at = evenPoint(first + i, box);
      result[first + i] = { at, cells.innerBall(at) };
    });
    found += static_cast<Index>(std::count_if(
      result.begin() + first, result.end(), [](const Place& place) { return place.cell != None; }));
    execution.report(std::max((turn + 1.0) / mostTurns, std::min(1.0, found / double(inside))));
  }
  return result;
}

double distanceToFaces(const Eigen::AlignedBox3d& box, const Point& place)
{
  return std::min((place - box.min()).minCoeff(), (box.max() - place).minCoeff());
}

/// The places inside, and as many outside.
struct Sides
{
  std::vector<Place> inside, outside;
};

Sides sidesOf(const std::vector<Place>& places)
{
  Sides result;
  for (const Place& place : places)
  {
    (place.cell == None ? result.outside : result.inside).push_back(place);
  }
  result.outside.resize(std::min(result.outside.size(), result.inside.size()));
  return result;
}

/// Diameters of the largest balls around places; that of its cell where no ball contains it, in a sharp corner. Not a
/// number where there is neither.
std::vector<double> diameters(const LargestBalls& balls, const std::vector<Place>& places,
  const std::vector<double>& distances, const Execution& execution)
{
  std::vector<double> result(places.size(), std::numeric_limits<double>::quiet_NaN());
  execution.forEach(count(places), [&](Index i) {
    const Index around = balls.around(places[i].at);
    const Index ball = around == None ? places[i].cell : around;
    result[i] = ball == None ? result[i] : 2 * distances[ball];
  });
  return result;
}

/// The values of places that are at least so far from the faces.
std::vector<double> away(const std::vector<double>& values, const std::vector<Place>& places,
  const Eigen::AlignedBox3d& box, double margin)
{
  std::vector<double> result;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (distanceToFaces(box, places[i].at) >= margin)
    {
      result.push_back(values[i]);
    }
  }
  return result;
}

void check(const Eigen::AlignedBox3d& box, const ThicknessBounds& volume)
{
  if (!(box.sizes().minCoeff() > 0) || !box.sizes().allFinite())
  {
    throw InvalidInput("the volume of interest is empty: give bounds whose upper corner is above "
                       "the lower one in x, y and z");
  }
  if (volume.bounds && 2 * volume.margin >= box.sizes().minCoeff())
  {
    throw InvalidInput("a margin of ", volume.margin,
      " leaves nothing of the volume of interest: take larger bounds, or a smaller margin");
  }
}
}

VolumeThickness volumeThickness(const PolarBalls& balls, const std::vector<double>& distances,
  const ThicknessBounds& volume, Index number, const Execution& execution)
{
  const Eigen::AlignedBox3d box = volume.bounds ? *volume.bounds : boundingBox(balls.samples);
  check(box, volume);
  const std::vector<Place> places = evenPlaces(balls, box, number, execution.between(0, 0.5));
  const Sides sides = sidesOf(places);
  const std::vector<double> inside = diameters(
    LargestBalls(balls, Side::Inner), sides.inside, distances, execution.between(0.5, 0.75));
  const LargestBalls gaps(
    balls, Side::Outer, [&](Index b) { return box.contains(balls.balls[b].center); });
  const std::vector<double> outside =
    diameters(gaps, sides.outside, distances, execution.between(0.75, 1));
  VolumeThickness result{ distribution(inside), distribution(known(outside)), 0,
    double(sides.inside.size()) / double(places.size()) };
  if (volume.bounds && result.thickness.number > 0)
  {
    result.margin = volume.margin < 0 ? result.thickness.mean / 2 : volume.margin;
    result.thickness = distribution(away(inside, sides.inside, box, result.margin));
  }
  execution.report(1);
  return result;
}
}
