// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/CurveSmoothing.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{
/// Position, radius and half width.
using Values = Eigen::Matrix<double, 1, 5>;

/// A short stretch of a branch: the means along it, and its length.
struct Stretch
{
  Values mean;
  double length;
};

double lengthOf(const MedialAxis& axis, const CurveBranch& branch)
{
  double result = 0;
  for (std::size_t i = 1; i < branch.points.size(); ++i)
  {
    result += (axis.points[branch.points[i]] - axis.points[branch.points[i - 1]]).norm();
  }
  return result;
}

/// The stretches of a branch: each ends at the first point at which it is an eighth long of the radius
/// there or of the branch. The ends of a line are stretches of their own, so that it isn't shortened.
std::vector<Stretch> stretches(
  const MedialAxis& axis, const std::vector<double>& times, const CurveBranch& branch)
{
  const auto valuesAt = [&](Index point) {
    Values values;
    values << axis.points[point].transpose(), axis.radii[point], times[point];
    return values;
  };
  const bool isLoop = branch.nodes[0] == None;
  const std::vector<Index>& points = branch.points;
  std::vector<Stretch> result;
  const auto addEnd = [&](Index point) {
    if (!isLoop)
    {
      result.push_back({ valuesAt(point), axis.radii[point] / 16 });
    }
  };
  addEnd(points.front());
  const double whole = lengthOf(axis, branch);
  Stretch next{ Values::Zero(), 0 };
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    const double length = (axis.points[points[i]] - axis.points[points[i - 1]]).norm();
    next.mean += length / 2 * (valuesAt(points[i - 1]) + valuesAt(points[i]));
    next.length += length;
    const bool isLast = i + 1 == points.size();
    if (next.length > 0 && (isLast || next.length >= std::min(axis.radii[points[i]], whole) / 8))
    {
      result.push_back({ next.mean / next.length, next.length });
      next = { Values::Zero(), 0 };
    }
  }
  addEnd(points.back());
  return result;
}

/// Local parabolas along stretches in a line or a circle.
class Parabolas
{
public:
  Parabolas(const std::vector<Stretch>& stretches, bool isLoop)
    : all(stretches)
    , isLoop(isLoop)
    , values(stretches.size())
  {
    std::transform(
      all.begin(), all.end(), values.begin(), [](const Stretch& stretch) { return stretch.mean; });
  }

  std::vector<Values> smoothed()
  {
    constexpr int rounds =
      2; // the first one measures along the zigzag, the second one along its curve
    for (int round = 0; round < rounds; ++round)
    {
      this->measure();
      std::vector<Values> next(this->all.size());
      for (Index i = 0; i < count(this->all); ++i)
      {
        next[i] = this->fitted(i);
      }
      this->values = std::move(next);
    }
    return std::move(this->values);
  }

private:
  void measure()
  {
    this->at.assign(1, 0);
    for (std::size_t i = 1; i <= this->values.size(); ++i)
    {
      const Values step = this->values[i % this->values.size()] - this->values[i - 1];
      this->at.push_back(this->at.back() + step.head<3>().norm());
    }
  }

  /// The value at stretch i of the parabola through those around it, nearer ones counting more.
  Values fitted(Index i) const
  {
    constexpr Index most = 16;
    const Index size = count(this->all);
    const Index before = this->isLoop ? std::min(most, (size - 1) / 2) : std::min(most, i);
    const Index after = this->isLoop ? before : std::min(most, size - 1 - i);
    const double reach = 0.5 * this->all[i].mean[3];
    Eigen::Matrix3d left = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 5> right = Eigen::Matrix<double, 3, 5>::Zero();
    for (Index j = i - before; j <= i + after; ++j)
    {
      const Stretch& stretch = this->all[(j + size) % size];
      const double t = this->along(i, j) / reach;
      if (std::abs(t) < 1)
      {
        const double weight = (1 - t * t) * (1 - t * t) * stretch.length;
        const Eigen::Vector3d powers(1, t, t * t);
        left += weight * powers * powers.transpose();
        right += weight * powers * stretch.mean;
      }
    }
    if (!(left(0, 0) > 0))
    {
      return this->all[i].mean; // a radius of 0
    }
    // Where too few are near for a parabola, it is a line or a constant.
    left.diagonal().tail<2>().array() += 1e-6 * left(0, 0);
    const Eigen::Matrix<double, 3, 5> parabola = left.ldlt().solve(right);
    return parabola.row(0);
  }

  /// How far stretch j is from stretch i, along the curve; j may be beyond both ends of a loop.
  double along(Index i, Index j) const
  {
    const Index size = count(this->all);
    const double round = j < 0 ? -this->at.back() : (j < size ? 0 : this->at.back());
    const Index within = j < 0 ? j + size : (j < size ? j : j - size);
    return this->at[within] + round - this->at[i];
  }

  const std::vector<Stretch>& all;
  bool isLoop;
  std::vector<Values> values;
  std::vector<double> at; ///< place along the curve of each; of the first once more at the end
};
}

Centerline smoothed(
  const MedialAxis& axis, const std::vector<double>& times, const CurveBranch& branch)
{
  const bool isLoop = branch.nodes[0] == None;
  const std::vector<Stretch> means = stretches(axis, times, branch);
  std::vector<Values> values = Parabolas(means, isLoop).smoothed();
  if (isLoop)
  {
    values.push_back(values.front());
  }
  Centerline result;
  for (const Values& value : values)
  {
    result.points.emplace_back(value.head<3>().transpose());
    result.radii.push_back(value[3]);
    result.halfWidths.push_back(value[4]);
  }
  result.nodes = branch.nodes;
  return result;
}
}
