// SPDX-License-Identifier: BSD-3-Clause
#include "Measuring/SampleWalls.h"

#include "Base/Neighbors.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{
constexpr int around = 12;                    ///< so many samples make a wall at most
using Tangents = Eigen::Matrix<double, 3, 2>; ///< two directions at a right angle, as columns

Tangents tangents(const Point& normal)
{
  Tangents result;
  result.col(0) = normal.unitOrthogonal();
  result.col(1) = normal.cross(result.col(0));
  return result;
}

/// From the inner ball of a sample to the outer one, of length 1; zero where it has neither.
Point poleDirection(const PolarBalls& balls, Index sample)
{
  const Point& at = balls.samples[sample];
  Point result = Point::Zero();
  if (balls.innerBall[sample] != None)
  {
    result += (at - balls.balls[balls.innerBall[sample]].center).normalized();
  }
  if (balls.outerBall[sample] != None)
  {
    result += (balls.balls[balls.outerBall[sample]].center - at).normalized();
  }
  return result.normalized();
}

/// Of the plane that is nearest to some steps from a point, and goes through it.
Point planeNormal(const std::vector<Point>& steps)
{
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Point& step : steps)
  {
    scatter += step * step.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(scatter); // the smallest first
  return axes.eigenvectors().col(0);
}

/// The paraboloid over a plane that is nearest to some steps from its top.
/// @param normal  of the plane
SampleWall paraboloid(const std::vector<Point>& steps, const Point& normal)
{
  constexpr std::size_t unknowns = 5;
  SampleWall result{ normal, Eigen::Matrix3d::Zero() };
  if (steps.size() < unknowns + 1)
  {
    return result;
  }
  const Tangents along = tangents(normal);
  // Of limited size, so that they need no memory of their own.
  Eigen::Matrix<double, Eigen::Dynamic, unknowns, 0, around, unknowns> terms(
    steps.size(), unknowns);
  Eigen::Matrix<double, Eigen::Dynamic, 1, 0, around, 1> heights(steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const Eigen::Vector2d p = along.transpose() * steps[i];
    const auto row = static_cast<Eigen::Index>(i);
    terms.row(row) << p.x(), p.y(), p.x() * p.x() / 2, p.x() * p.y(), p.y() * p.y() / 2;
    heights[row] = steps[i].dot(normal);
  }
  const Eigen::Matrix<double, unknowns, 1> fit = terms.colPivHouseholderQr().solve(heights);
  if (!fit.allFinite())
  {
    return result;
  }
  Eigen::Matrix2d bend;
  bend << fit[2], fit[3], fit[3], fit[4];
  result.normal = (normal - along * fit.head<2>()).normalized();
  const Eigen::Matrix3d flat =
    Eigen::Matrix3d::Identity() - result.normal * result.normal.transpose();
  result.curvature = flat * along * bend * along.transpose() * flat;
  return result;
}

/// How a normal changes, from those of the neighbors.
/// @param changes  of the normal, one for each step
Eigen::Matrix3d curvature(
  const std::vector<Point>& steps, const std::vector<Point>& changes, const Point& normal)
{
  const Tangents along = tangents(normal);
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    const Eigen::Vector2d p = along.transpose() * steps[i], q = -along.transpose() * changes[i];
    Eigen::Matrix<double, 2, 3> terms; // of the symmetric matrix that takes p to q
    terms << p.x(), p.y(), 0, 0, p.x(), p.y();
    products += terms.transpose() * terms;
    right += terms.transpose() * q;
  }
  const Eigen::Vector3d fit = products.ldlt().solve(right);
  if (steps.size() < 3 || !fit.allFinite())
  {
    return Eigen::Matrix3d::Zero();
  }
  Eigen::Matrix2d bend;
  bend << fit[0], fit[1], fit[1], fit[2];
  return along * bend * along.transpose();
}

class Walls
{
public:
  Walls(const PolarBalls& theBalls, const Execution& execution)
    : balls(theBalls)
    , neighbors(theBalls.samples)
    , directions(theBalls.normals)
  {
    if (this->directions.empty())
    {
      this->directions.resize(theBalls.samples.size());
      execution.forEach(count(theBalls.samples),
        [this](Index s) { this->directions[s] = poleDirection(this->balls, s); });
    }
  }

  /// The samples in an order that is quick.
  std::vector<Index> order() const { return this->neighbors.inOrder(); }

  SampleWall at(Index sample) const
  {
    const bool hasNormal = !this->balls.normals.empty() && !this->directions[sample].isZero();
    constexpr double sameWall = 0.5; // cosine between their directions
    std::vector<Point> steps, changes;
    steps.reserve(around);
    changes.reserve(around);
    for (const Index other : this->neighbors.nearest(sample, around))
    {
      if (this->directions[other].dot(this->directions[sample]) > sameWall)
      {
        steps.push_back(this->balls.samples[other] - this->balls.samples[sample]);
        changes.push_back(this->directions[other] - this->directions[sample]);
      }
    }
    const Point& direction = this->directions[sample];
    if (hasNormal)
    {
      return { direction, curvature(steps, changes, direction) };
    }
    constexpr std::size_t fewest = 3; // for a plane
    if (steps.size() < fewest)
    {
      return { direction, Eigen::Matrix3d::Zero() };
    }
    const Point normal = planeNormal(steps);
    return paraboloid(steps, normal.dot(direction) < 0 ? Point(-normal) : normal);
  }

private:
  const PolarBalls& balls;
  Neighbors neighbors;
  std::vector<Point> directions; ///< outwards
};

/// How far a point is from a wall, to second order in its distance from the place of the wall's sample; negative where
/// the wall doesn't face it.
/// @param outwards  1, or -1 for a point outside
double distanceFrom(
  const SampleWall& wall, const Point& sample, const Point& point, double outwards)
{
  const Point from = sample - point, normal = outwards * wall.normal;
  const double straight = from.dot(normal); // from the plane at the sample
  const Point aside = from - straight * normal;
  const double squared = aside.squaredNorm();
  if (!(squared > 0))
  {
    return straight;
  }
  const double bend = outwards * aside.dot(wall.curvature * aside) / squared;
  constexpr double least =
    0.25; // a wall that bends around the point: there all its places are as near
  return straight + bend * squared / (2 * std::max(least, 1 + bend * straight));
}
}

std::vector<SampleWall> sampleWalls(const PolarBalls& balls, const Execution& execution)
{
  const Walls walls(balls, execution);
  std::vector<SampleWall> result(balls.samples.size());
  const std::vector<Index> order = walls.order();
  execution.forEach(count(order), [&](Index i) { result[order[i]] = walls.at(order[i]); });
  return result;
}

std::vector<double> wallDistances(const PolarBalls& balls, const std::vector<SampleWall>& walls)
{
  std::vector<double> result;
  result.reserve(balls.balls.size());
  for (Index b = 0; b < count(balls.balls); ++b)
  {
    const Ball& ball = balls.balls[b];
    const double outwards = balls.sides[b] == Side::Outer ? -1 : 1;
    double sum = 0;
    Index facing = 0;
    for (const Index s : balls.ballSamples[b])
    {
      const double distance = distanceFrom(walls[s], balls.samples[s], ball.center, outwards);
      if (distance > 0)
      {
        sum += distance;
        ++facing;
      }
    }
    result.push_back(facing > 0 ? std::min(sum / facing, ball.radius) : ball.radius);
  }
  return result;
}
}
