// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/KeptThickness.h"

#include "Meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using medial::Index;
using medial::Point;
using medial::Triangle;
using meshes::Mesh;

constexpr double thick = 2; // what is thicker moves freely

std::vector<double> even(int steps, double length)
{
  std::vector<double> result;
  for (int i = 0; i <= steps; ++i)
  {
    result.push_back(length * i / steps);
  }
  return result;
}

/// 4 by 4, of many triangles.
Mesh plate(double thickness)
{
  return meshes::blocks(
    even(20, 4), even(20, 4), { 0, thickness }, [](int, int, int) { return true; });
}

/// Where "smoothing" moves all points at a height towards the middle one.
std::vector<Point> movedTo(const std::vector<Point>& points, double middle, double by)
{
  std::vector<Point> result = points;
  for (Point& p : result)
  {
    p.z() += p.z() < middle ? by : -by;
  }
  return result;
}

std::vector<Point> kept(const Mesh& mesh, const std::vector<Point>& smoothed)
{
  return medial::withThicknessKept(
    mesh.points, smoothed, meshes::triangles(meshes::triangulated(mesh)), thick);
}

bool isAtRim(const Point& p)
{
  return std::min(p.x(), p.y()) < 0.5 || std::max(p.x(), p.y()) > 3.5;
}

TEST(KeptThickness, KeepsTheSidesOfAWallApart)
{
  const double thickness = 0.2;
  const Mesh mesh = plate(thickness);
  const std::vector<Point> result = kept(mesh, movedTo(mesh.points, thickness / 2, 0.15));
  int inside = 0;
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    if (!isAtRim(mesh.points[i]))
    {
      const double expected = mesh.points[i].z() == 0 ? 0.05 : 0.15; // a quarter each
      EXPECT_NEAR(result[i].z(), expected, 1e-9);
      ++inside;
    }
  }
  EXPECT_GT(inside, 400);
}

TEST(KeptThickness, KeepsTheSidesOfAGapApart)
{
  const Mesh below = plate(3);
  const Mesh mesh = meshes::united(below, meshes::moved(below, Point(0, 0, 3.2)));
  const std::vector<Point> result = kept(mesh, mesh.points);
  EXPECT_EQ(result, mesh.points); // nothing was smoothed
  std::vector<Point> smoothed = mesh.points;
  for (Point& p : smoothed)
  {
    p.z() += p.z() == 3 ? 0.15 : p.z() == 3.2 ? -0.15 : 0; // across each other
  }
  int inside = 0;
  const std::vector<Point> gap = kept(mesh, smoothed);
  for (std::size_t i = 0; i < gap.size(); ++i)
  {
    if (!isAtRim(mesh.points[i]) && std::abs(mesh.points[i].z() - 3.1) < 0.2)
    {
      EXPECT_NEAR(std::abs(gap[i].z() - 3.1), 0.05, 1e-9);
      ++inside;
    }
  }
  EXPECT_GT(inside, 400);
}

TEST(KeptThickness, LeavesWhatIsThick)
{
  const Mesh mesh = plate(3);
  const std::vector<Point> smoothed = movedTo(mesh.points, 1.5, 0.3);
  EXPECT_EQ(kept(mesh, smoothed), smoothed);
}

TEST(KeptThickness, LeavesSmallMoves)
{
  const Mesh mesh = plate(0.2);
  const std::vector<Point> smoothed = movedTo(mesh.points, 0.1, 0.01);
  const std::vector<Point> result = kept(mesh, smoothed);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    if (!isAtRim(mesh.points[i]))
    {
      EXPECT_EQ(result[i], smoothed[i]);
    }
  }
}
}
