// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/Anisotropy.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int Heights = 16; ///< above the equator
constexpr int Around = 64; ///< a multiple of four, so that mirrored frames have the same directions

/// A direction with its share of the half sphere; the other half sees the same.
struct Direction
{
  Point unit;
  double weight;
};

/// Height and weight of a root of the Legendre polynomial of degree 2 * Heights (Gauss's quadrature), the
/// i-th from the pole, by Newton's method.
std::pair<double, double> gaussPoint(int i)
{
  constexpr int degree = 2 * Heights;
  double z = std::cos(Pi * (i + 0.75) / (degree + 0.5)), slope = 1;
  for (int round = 0; round < 8; ++round)
  {
    double value = z, before = 1;
    for (int k = 2; k <= degree; ++k)
    {
      const double next = ((2 * k - 1) * z * value - (k - 1) * before) / k;
      before = value;
      value = next;
    }
    slope = degree * (z * value - before) / (z * z - 1);
    z -= value / slope;
  }
  return { z, 2 / ((1 - z * z) * slope * slope) };
}

/// They integrate polynomials up to degree 63 exactly.
std::vector<Direction> directions()
{
  std::vector<Direction> result;
  for (int i = 0; i < Heights; ++i)
  {
    const auto [z, weight] = gaussPoint(i);
    for (int k = 0; k < Around; ++k)
    {
      const double angle = 2 * Pi * (k + 0.5) / Around, radius = std::sqrt(1 - z * z);
      result.push_back(
        { Point(radius * std::cos(angle), radius * std::sin(angle), z), weight / Around });
    }
  }
  return result;
}

/// The principal directions of the normals: they turn with the surface.
Eigen::Matrix3d frameOf(const std::vector<Point>& areas)
{
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const Point& area : areas)
  {
    const double size = area.norm();
    sum += size > 0 ? Eigen::Matrix3d(area * area.transpose() / size) : Eigen::Matrix3d::Zero();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors();
}

/// The quadratic form that fits squares best, for squares of directions that fill the sphere evenly. With T the
/// mean of square * d d^T it is (15 T - 3 trace(T)) / 2, as the mean of d_i d_j d_k d_l tells.
Eigen::Matrix3d fitted(const std::vector<Direction>& directions, const std::vector<double>& squares)
{
  Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    const Point& d = directions[i].unit;
    mean += directions[i].weight * squares[i] * d * d.transpose();
  }
  return (15 * mean - 3 * mean.trace() * Eigen::Matrix3d::Identity()) / 2;
}
}

double degreeOfAnisotropy(const std::vector<Point>& areas, const Execution& execution)
{
  double whole = 0;
  for (const Point& area : areas)
  {
    whole += area.norm();
  }
  if (!(whole > 0))
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::vector<Direction> all = directions();
  const Eigen::Matrix3d frame = frameOf(areas);
  std::vector<double> squares(all.size());
  execution.forEach(count(all), [&](Index i) {
    const Point direction = frame * all[i].unit;
    double sum = 0;
    for (const Point& area : areas)
    {
      sum += std::abs(area.dot(direction));
    }
    squares[i] = sum / whole * (sum / whole);
  });
  const Point eigenvalues =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(fitted(all, squares)).eigenvalues();
  // Where lines in a direction meet nothing the least is 0, and rounding or the fit may make it less.
  return 1 - std::max(0.0, eigenvalues[0]) / eigenvalues[2];
}
}
