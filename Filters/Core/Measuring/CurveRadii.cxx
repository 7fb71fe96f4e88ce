// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/CurveRadii.h"

#include "Base/Lists.h"
#include "Base/Neighbors.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{
/// How large a ball about a place can be, by the balls of cells that are near, whose radii are linear between their
/// corners. Of a cell the ball counts that says most.
class RadiusBounds
{
public:
  explicit RadiusBounds(const MedialAxis& medialAxis)
    : axis(medialAxis)
    , neighbors(medialAxis.points)
    , cellsAt(listsByKey(count(medialAxis.points), [&medialAxis](const auto& add) {
      for (Index cell = 0; cell < medialAxis.cells.size(); ++cell)
      {
        forPoints(medialAxis.cells, cell, [&](Index p) { add(p, cell); });
      }
    }))
  {
  }

  struct Range
  {
    double least, most;
  };

  Range at(const Point& place) const
  {
    constexpr Index near = 6;        // points
    constexpr Index mostCells = 100; // at a point; more are a fan of very many
    Range result{ 0, std::numeric_limits<double>::infinity() };
    for (const Index p : this->neighbors.nearest(place, near))
    {
      const IndexLists::View cells = this->cellsAt[p];
      for (Index i = 0; i < std::min(cells.size(), mostCells); ++i)
      {
        result.least = std::max(result.least, -this->bound(place, cells[i], -1));
        result.most = std::min(result.most, this->bound(place, cells[i], 1));
      }
    }
    return result;
  }

private:
  /// The least of sign * radius + distance of the balls of a cell.
  double bound(const Point& place, Index cell, double sign) const
  {
    std::array<Index, 3> corners;
    Index size = 0;
    forPoints(this->axis.cells, cell, [&](Index p) { corners[size++] = p; });
    double result = this->ofInterior(place, corners, size, sign);
    for (Index i = 0; i < size; ++i)
    {
      result = std::min(result, this->ofEdge(place, corners[i], corners[(i + 1) % size], sign));
    }
    return result;
  }

  /// Along a line, s * r + distance is least where the slope of the distance is that of r.
  double ofEdge(const Point& place, Index a, Index b, double sign) const
  {
    const Point &from = this->axis.points[a], along = this->axis.points[b] - from;
    const double length = along.norm(), first = this->axis.radii[a], last = this->axis.radii[b];
    double share = 0;
    if (length > 0)
    {
      const double foot = (place - from).dot(along) / length;
      const double height = (place - from - foot / length * along).norm();
      const double slope = std::clamp(sign * (last - first) / length, -steepest, steepest);
      share = std::clamp((foot - height * slope / std::sqrt(1 - slope * slope)) / length, 0.0, 1.0);
    }
    return sign * ((1 - share) * first + share * last) + (from + share * along - place).norm();
  }

  /// Infinite where it is least at an edge.
  double ofInterior(const Point& place, const Triangle& corners, Index size, double sign) const
  {
    if (size < 3)
    {
      return std::numeric_limits<double>::infinity();
    }
    const auto [a, b, c] = corners;
    const Point& origin = this->axis.points[a];
    const Eigen::Vector2d rise(
      this->axis.radii[b] - this->axis.radii[a], this->axis.radii[c] - this->axis.radii[a]);
    Eigen::Matrix<double, 3, 2> sides;
    sides << this->axis.points[b] - origin, this->axis.points[c] - origin;
    const Eigen::Matrix2d inverse = (sides.transpose() * sides).inverse();
    const Eigen::Vector2d foot = inverse * (sides.transpose() * (place - origin));
    const Point gradient = sides * (inverse * rise);
    const double slope = std::min(gradient.norm(), steepest);
    const double height = (place - origin - sides * foot).norm();
    const Eigen::Vector2d step = height / std::sqrt(1 - slope * slope) * (inverse * rise);
    const Eigen::Vector2d shares = foot - sign * step;
    if (!(shares.minCoeff() >= 0 && shares.sum() <= 1))
    {
      return std::numeric_limits<double>::infinity();
    }
    const double radius = this->axis.radii[a] + shares.dot(rise);
    return sign * radius + (origin + sides * shares - place).norm();
  }

  static constexpr double steepest =
    0.999; ///< of two balls none of which is in the other, up to rounding

  const MedialAxis& axis;
  Neighbors neighbors;
  IndexLists cellsAt;
};
}

void bindRadii(const MedialAxis& axis, const BallTree& solid, std::vector<Centerline>& curves,
  const Execution& execution)
{
  const RadiusBounds bounds(axis);
  execution.forEach(count(curves), [&](Index i) {
    Centerline& curve = curves[i];
    for (std::size_t j = 0; j < curve.points.size(); ++j)
    {
      const Point& place = curve.points[j];
      const auto [least, most] = bounds.at(place);
      const double low = std::max(least, -solid.distance(place));
      curve.radii[j] = std::max(std::min(curve.radii[j], most), low);
      curve.halfWidths[j] = std::max(curve.halfWidths[j], curve.radii[j]);
    }
  });
}
}
