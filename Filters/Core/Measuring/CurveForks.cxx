// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/CurveForks.h"

#include "Base/Lists.h"

#include <Eigen/Cholesky>

#include <algorithm>

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
  Point direction; ///< of length 1
};

/// The place of a curve's point, counted from an end.
Index placeFrom(const End& end, const Centreline& curve, Index i)
{
  return end.isLast ? count(curve.points) - 1 - i : i;
}

/// The first point, counted on from `first`, that is farther from a place; as many as there are if none is.
Index firstFarther(
  const End& end, const Centreline& curve, Index first, const Point& place, double distance)
{
  const Index size = count(curve.points);
  Index i = first;
  while (i < size && (curve.points[placeFrom(end, curve, i)] - place).norm() <= distance)
  {
    ++i;
  }
  return i;
}

/// Puts one fork and the curves at it in place.
class Fork
{
public:
  Fork(std::vector<Centreline>& curves, const Lists<End>::View& ends, double radius)
    : curves(curves)
    , ends(ends)
    , radius(radius)
  {
  }

  void place()
  {
    Point middle = Point::Zero();
    for (const End& end : this->ends)
    {
      middle += this->curvePoint(end, 0) / this->ends.size();
    }
    std::vector<End> others;
    for (const End& end : this->ends)
    {
      if (!this->addRay(end, middle))
      {
        others.push_back(end);
      }
    }
    const Point meeting = this->meeting(middle);
    for (const End& end : others)
    {
      this->shift(end, meeting);
    }
    for (const Ray& ray : this->rays)
    {
      this->straighten(ray, meeting);
    }
  }

private:
  Point& curvePoint(const End& end, Index i)
  {
    Centreline& curve = this->curves[end.curve];
    return curve.points[placeFrom(end, curve, i)];
  }

  /// Only where it leaves half of the curve to the other end.
  /// @return  is there one?
  bool addRay(const End& end, const Point& middle)
  {
    const Centreline& curve = this->curves[end.curve];
    const Index size = count(curve.points);
    const Index from = firstFarther(end, curve, 0, middle, 1.5 * this->radius);
    if (from >= size - 1)
    {
      return false;
    }
    const std::vector<double> at = lengths(curve.points);
    const double place = at[placeFrom(end, curve, from)];
    if ((end.isLast ? at.back() - place : place) > at.back() / 2)
    {
      return false;
    }
    const Point start = this->curvePoint(end, from);
    const Index to = std::min(size - 1, firstFarther(end, curve, from + 1, start, this->radius));
    const Point chord = this->curvePoint(end, to) - start;
    this->rays.push_back({ end, from, start, chord.stableNormalized() });
    return true;
  }

  /// Where the rays come nearest to each other, by least squares, within a radius of the middle. It counts a little
  /// itself, in case they are parallel.
  Point meeting(const Point& middle) const
  {
    constexpr double little = 0.05;
    Eigen::Matrix3d left = little * Eigen::Matrix3d::Identity();
    Point right = Point::Zero();
    for (const Ray& ray : this->rays)
    {
      const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - ray.direction * ray.direction.transpose();
      left += across;
      right += across * (ray.from - middle);
    }
    const Point step = left.ldlt().solve(right);
    return middle + step * std::min(1.0, this->radius / std::max(step.norm(), this->radius));
  }

  /// Moves an end there, and the rest the less the farther it is.
  void shift(const End& end, const Point& to)
  {
    Centreline& curve = this->curves[end.curve];
    const std::vector<double> at = lengths(curve.points);
    const Point step = to - this->curvePoint(end, 0);
    for (std::size_t i = 0; i < at.size() && at.back() > 0; ++i)
    {
      const double share = at[i] / at.back();
      curve.points[i] += step * (end.isLast ? share : 1 - share);
    }
    this->curvePoint(end, 0) = to;
  }

  void straighten(const Ray& ray, const Point& to)
  {
    for (Index i = 0; i < ray.points; ++i)
    {
      const double share = static_cast<double>(i) / ray.points;
      this->curvePoint(ray.end, i) = (1 - share) * to + share * ray.from;
    }
  }

  std::vector<Centreline>& curves;
  const Lists<End>::View ends;
  double radius;
  std::vector<Ray> rays;
};
}

void joinAtForks(const MedialAxis& axis, std::vector<Centreline>& curves)
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
  for (Index node = 0; node < endsAt.size(); ++node)
  {
    if (endsAt[node].size() > 1)
    {
      Fork(curves, endsAt[node], axis.radii[node]).place();
    }
  }
}
}
