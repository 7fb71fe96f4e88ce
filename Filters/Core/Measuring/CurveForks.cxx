// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/CurveForks.h"

#include "Base/Lists.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace medial
{
namespace
{
/// One end of a curve.
struct End
{
  Index curve;
  bool isLast;
};

/// The straight continuation of a curve into a fork.
struct Ray
{
  End end;
  Index points;    ///< so many of the curve's are replaced by it
  Point from;      ///< the next point of the curve
  Point direction; ///< away from the fork, of length 1
  double radius;   ///< of the curve there
  double slope;    ///< by which it grows along the direction
};

/// A curve as seen from one of its ends.
class FromEnd
{
public:
  FromEnd(std::vector<Centerline>& curves, const End& end)
    : curve(curves[end.curve])
    , isLast(end.isLast)
  {
  }

  Index size() const { return count(this->curve.points); }
  Point& point(Index i) { return this->curve.points[this->place(i)]; }
  double& radius(Index i) { return this->curve.radii[this->place(i)]; }
  /// @param values  one for each point of the curve
  double valueOf(const std::vector<double>& values, Index i) const
  {
    return values[this->place(i)];
  }

  /// The length up to each point.
  std::vector<double> lengths() const
  {
    std::vector<double> result = medial::lengths(this->curve.points);
    if (this->isLast)
    {
      const double whole = result.back();
      std::reverse(result.begin(), result.end());
      std::for_each(result.begin(), result.end(), [whole](double& at) { at = whole - at; });
    }
    return result;
  }

private:
  Index place(Index i) const { return this->isLast ? this->size() - 1 - i : i; }

  Centerline& curve;
  bool isLast;
};

/// Where the rays come nearest to each other, by least squares, within a radius of the middle. It counts a
/// little itself, in case they are parallel.
Point meetingOf(const std::vector<Ray>& rays, const Point& middle, double radius)
{
  constexpr double little = 0.05;
  Eigen::Matrix3d left = little * Eigen::Matrix3d::Identity();
  Point right = Point::Zero();
  for (const Ray& ray : rays)
  {
    const Eigen::Matrix3d across =
      Eigen::Matrix3d::Identity() - ray.direction * ray.direction.transpose();
    left += across;
    right += across * (ray.from - middle);
  }
  const Point step = left.ldlt().solve(right);
  const double length = step.norm();
  return length > radius ? Point(middle + radius / length * step) : Point(middle + step);
}

/// Moves an end there, and what is nearer than the reach the less the farther it is.
void shift(FromEnd curve, const Point& to, double reach)
{
  const std::vector<double> at = curve.lengths();
  const double length = std::min(at.back(), reach);
  const Point step = to - curve.point(0);
  for (Index i = 1; i < curve.size() && at[i] < length; ++i)
  {
    const Point part = (1 - at[i] / length) * step;
    curve.point(i) += part;
    curve.radius(i) = std::max(0.0, curve.radius(i) - part.norm());
  }
  curve.point(0) = to;
  curve.radius(0) = std::max(0.0, curve.radius(0) - step.norm());
}

/// Puts one fork and the curves at it in place.
class Fork
{
public:
  /// @param node           the ball of the axis there
  /// @param chordShare     over so much of a curve, at most, its direction is taken
  /// @param smoothedRadii  of each curve, before any fork was put in place
  Fork(std::vector<Centerline>& curves, const Lists<End>::View& ends, const Ball& node,
    const BallTree& solid, double chordShare, const std::vector<std::vector<double>>& smoothedRadii)
    : curves(curves)
    , ends(ends)
    , node(node)
    , radius(node.radius)
    , solid(solid)
    , chordShare(chordShare)
    , smoothedRadii(smoothedRadii)
  {
  }

  void place()
  {
    Point middle = Point::Zero();
    for (const End& end : this->ends)
    {
      middle += FromEnd(this->curves, end).point(0) / this->ends.size();
    }
    if (!this->isInside(middle, this->node.radius))
    {
      middle = this->node.center;
    }
    this->enlarge(middle);
    const auto [rays, meeting] = this->validRays(middle);
    for (const End& end : this->ends)
    {
      const bool hasRay = std::any_of(rays.begin(), rays.end(), [&end](const Ray& ray) {
        return ray.end.curve == end.curve && ray.end.isLast == end.isLast;
      });
      if (!hasRay)
      {
        shift(FromEnd(this->curves, end), meeting, 2 * this->radius);
      }
    }
    for (const Ray& ray : rays)
    {
      this->straighten(ray, meeting);
    }
  }

private:
  /// Has the solid nearly as large a ball there?
  bool isInside(const Point& place, double ballRadius) const
  {
    return -this->solid.distance(place) >= 0.5 * ballRadius;
  }

  /// Those that stay inside on their way to the point where they meet, and this point.
  std::pair<std::vector<Ray>, Point> validRays(const Point& middle)
  {
    Point meeting = middle;
    std::vector<Ray> rays;
    for (int round = 0; round < 3; ++round) // later ones know better how far the fork reaches
    {
      rays = this->raysFrom(meeting);
      meeting = meetingOf(rays, meeting, this->radius);
    }
    // One wrong ray leads the others astray, so only the one that misses most goes at a time.
    while (const std::optional<std::size_t> worst = this->worstInvalid(rays, meeting))
    {
      rays.erase(rays.begin() + static_cast<std::ptrdiff_t>(*worst));
      meeting = rays.empty() ? middle : meetingOf(rays, middle, this->radius);
    }
    return { rays, meeting };
  }

  /// Of the rays that leave the solid the one that passes the meeting point farthest.
  std::optional<std::size_t> worstInvalid(const std::vector<Ray>& rays, const Point& meeting) const
  {
    std::optional<std::size_t> worst;
    double farthest = -1;
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      const double miss = (meeting - rays[i].from).cross(rays[i].direction).norm();
      if (miss > farthest && !this->isValid(rays[i], meeting))
      {
        worst = i;
        farthest = miss;
      }
    }
    return worst;
  }

  bool isValid(const Ray& ray, const Point& meeting) const
  {
    constexpr int steps = 8;
    for (int i = 0; i < steps; ++i)
    {
      const double share = static_cast<double>(i) / steps;
      const Point place = (1 - share) * meeting + share * ray.from;
      if (!this->isInside(place, this->radiusOn(ray, (place - ray.from).norm())))
      {
        return false;
      }
    }
    return true;
  }

  double radiusOn(const Ray& ray, double distance) const
  {
    return std::clamp(ray.radius - ray.slope * distance, 0.0, this->radius);
  }

  /// A fork is as large as the rods that leave it. It may be in a web between them, where balls are small and
  /// become larger towards the rods; a few rounds come there.
  void enlarge(const Point& middle)
  {
    for (int round = 0; round < 3; ++round)
    {
      const double reach = 2 * this->radius;
      for (const End& end : this->ends)
      {
        FromEnd curve(this->curves, end);
        for (Index i = 0; i < curve.size() && (curve.point(i) - middle).norm() <= reach; ++i)
        {
          this->radius = std::max(this->radius, curve.radius(i));
        }
      }
    }
  }

  std::vector<Ray> raysFrom(const Point& middle)
  {
    std::vector<Ray> result;
    for (const End& end : this->ends)
    {
      const std::optional<Ray> ray = this->ray(end, middle);
      if (ray)
      {
        result.push_back(*ray);
      }
    }
    return result;
  }

  /// From where the ball about a point of a curve leaves the fork's for good, but in the first half of the
  /// curve.
  std::optional<Ray> ray(const End& end, const Point& middle)
  {
    FromEnd curve(this->curves, end);
    const std::vector<double> at = curve.lengths();
    const auto distance = [&](Index i) { return (curve.point(i) - middle).norm(); };
    Index from = 0;
    for (Index i = 0; i + 1 < curve.size() && at[i] < 0.5 * at.back(); ++i)
    {
      from = distance(i) <= this->radius + 1.5 * curve.radius(i) ? i + 1 : from;
    }
    if (from == 0 || distance(from) <= this->radius)
    {
      return {};
    }
    const double enough = std::min(2 * curve.radius(from), this->chordShare * at.back());
    Index to = from;
    while (to + 1 < curve.size() && at[to] - at[from] < enough)
    {
      ++to;
    }
    if (at[to] <= at[from])
    {
      return {};
    }
    const Point chord = curve.point(to) - curve.point(from);
    // Radii that were extrapolated from the other end say nothing.
    Index growth = from;
    while (growth + 1 < curve.size() && at[growth] - at[from] < 0.15 * at.back())
    {
      ++growth;
    }
    const std::vector<double>& radii = this->smoothedRadii[end.curve];
    const double radius = curve.valueOf(radii, from);
    const double slope = (curve.valueOf(radii, growth) - radius) / (at[growth] - at[from]);
    return Ray{ end, from, curve.point(from), chord.stableNormalized(), radius, slope };
  }

  void straighten(const Ray& ray, const Point& to)
  {
    FromEnd curve(this->curves, ray.end);
    for (Index i = 0; i < ray.points; ++i)
    {
      const double share = static_cast<double>(i) / ray.points;
      curve.point(i) = (1 - share) * to + share * ray.from;
      curve.radius(i) = this->radiusOn(ray, (curve.point(i) - ray.from).norm());
    }
  }

  std::vector<Centerline>& curves;
  const Lists<End>::View ends;
  const Ball node;
  double radius;
  const BallTree& solid;
  double chordShare;
  const std::vector<std::vector<double>>& smoothedRadii;
};
}

void joinAtForks(const MedialAxis& axis, const BallTree& solid, std::vector<Centerline>& curves)
{
  const Lists<End> endsAt = listsByKey<End>(count(axis.points), [&curves](const auto& add) {
    for (Index i = 0; i < count(curves); ++i)
    {
      for (const bool isLast : { false, true })
      {
        if (curves[i].nodes[isLast] != None)
        {
          add(curves[i].nodes[isLast], End{ i, isLast });
        }
      }
    }
  });
  std::vector<std::vector<double>> smoothedRadii;
  smoothedRadii.reserve(curves.size());
  for (const Centerline& curve : curves)
  {
    smoothedRadii.push_back(curve.radii);
  }
  // The second time, the other ends of the curves are in place, and more of each curve is straight.
  for (const double chordShare : { 0.1, 0.25 })
  {
    for (Index node = 0; node < endsAt.size(); ++node)
    {
      if (endsAt[node].size() > 1)
      {
        const Ball ball{ axis.points[node], axis.radii[node] };
        Fork(curves, endsAt[node], ball, solid, chordShare, smoothedRadii).place();
      }
    }
  }
}
}
