// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/NoiseEstimate.h"

#include "Base/Lists.h"

#include <Eigen/Dense>

#include <cmath>
#include <utility>

namespace medial
{
namespace
{
constexpr Index neighborCount = 16;
constexpr int sampleCount = neighborCount + 1;
constexpr int coefficientCount = 6;

using Coordinates = Eigen::Matrix<double, sampleCount, 3>;

/// The residual of a quadric over the plane that fits best, in spacings.
double residual(const std::vector<Point>& points, Index sample, const std::vector<Index>& around)
{
  Coordinates relative;
  relative.row(0).setZero();
  for (int i = 0; i < neighborCount; ++i)
  {
    relative.row(i + 1) = (points[around[i]] - points[sample]).transpose();
  }
  const double reach = relative.row(neighborCount).norm();
  relative /= reach;
  relative.rowwise() -= relative.colwise().mean().eval();
  const Eigen::Matrix3d covariance = relative.transpose() * relative;
  // Ascending eigenvalues: the normal comes first.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Coordinates local = relative * solver.eigenvectors();
  Eigen::Matrix<double, sampleCount, coefficientCount> terms;
  for (int i = 0; i < sampleCount; ++i)
  {
    const double u = local(i, 1), v = local(i, 2);
    terms.row(i) << 1, u, v, u * u, u * v, v * v;
  }
  const Eigen::Matrix<double, sampleCount, 1> heights = local.col(0);
  const Eigen::Matrix<double, sampleCount, 1> rest =
    heights - terms * terms.colPivHouseholderQr().solve(heights);
  const double deviation = rest.norm() / std::sqrt(sampleCount - coefficientCount);
  // The neighbours share a disc of radius 1 evenly.
  const double spacing = std::sqrt(std::acos(-1.0) / neighborCount);
  return deviation / spacing;
}
}

double noiseEstimate(
  const std::vector<Point>& points, const Neighbors& neighbors, const Execution& execution)
{
  // The median of so many is known to 3 %.
  constexpr Index enough = 2000;
  if (count(points) <= neighborCount)
  {
    return 0;
  }
  const Index step = 1 + (count(points) - 1) / enough;
  std::vector<double> residuals((points.size() + step - 1) / step);
  execution.forEach(count(residuals), [&](Index i) {
    residuals[i] = residual(points, i * step, neighbors.nearest(i * step, neighborCount));
  });
  return median(std::move(residuals));
}
}
