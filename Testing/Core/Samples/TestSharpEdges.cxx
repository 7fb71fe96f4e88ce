// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/SharpEdges.h"

#include "Meshes.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using medial::Index;
using medial::Point;
using medial::SharpEdge;
using medial::SharpLine;
using medial::SpacingField;
using medial::SurfacePoint;
using medial::Triangle;

constexpr double angle = 30;

/// A mesh cut into triangles, its sharp lines and the samples along them.
struct Surface
{
  explicit Surface(const meshes::Mesh& mesh)
    : points(mesh.points)
    , triangles(meshes::triangles(meshes::triangulated(mesh)))
    , set(medial::triangleSet(points, triangles))
    , lines(medial::sharpLines(set, angle))
  {
  }

  std::vector<SurfacePoint> samples(double spacing) const
  {
    return medial::mirroredSamples(this->set, medial::SurfaceTree(this->points, this->triangles),
      SpacingField(spacing), this->lines);
  }

  std::vector<Point> points;
  std::vector<Triangle> triangles;
  medial::TriangleSet set;
  std::vector<SharpLine> lines;
};

void expectConnected(const SharpLine& line)
{
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    EXPECT_EQ(line[i].ends[0], line[i - 1].ends[1]);
  }
}

TEST(SharpEdges, OfABoxAreTwelve)
{
  const Surface box(meshes::box(Point::Zero(), Point::Ones()));
  ASSERT_EQ(box.lines.size(), 12);
  for (const SharpLine& line : box.lines)
  {
    ASSERT_EQ(line.size(), 1);
    const auto [a, b] = line[0].ends;
    EXPECT_DOUBLE_EQ((box.points[a] - box.points[b]).norm(), 1);
    const auto [first, second] = line[0].triangles;
    EXPECT_EQ(box.set.normals[first].dot(box.set.normals[second]), 0);
  }
}

TEST(SharpEdges, OfACylinderAreTwoClosedLines)
{
  const Surface cylinder(meshes::cylinder(1, 2));
  ASSERT_EQ(cylinder.lines.size(), 2);
  for (const SharpLine& line : cylinder.lines)
  {
    EXPECT_EQ(line.size(), 48);
    expectConnected(line);
    EXPECT_EQ(line.front().ends[0], line.back().ends[1]);
  }
}

TEST(SharpEdges, GoStraightOnAndEndAtCorners)
{
  const Surface beam(meshes::iBeam(5));
  EXPECT_EQ(beam.lines.size(), 36);
  for (const SharpLine& line : beam.lines)
  {
    expectConnected(line);
    const Point from = beam.points[line.front().ends[0]], to = beam.points[line.back().ends[1]];
    double length = 0;
    for (const SharpEdge& edge : line)
    {
      length += (beam.points[edge.ends[1]] - beam.points[edge.ends[0]]).norm();
    }
    EXPECT_NEAR((to - from).norm(), length, 1e-12);
  }
}

TEST(SharpEdges, AreNoneOnASmoothSurface)
{
  EXPECT_TRUE(Surface(meshes::torus()).lines.empty());
  EXPECT_TRUE(Surface(meshes::torus()).samples(0.1).empty());
}

TEST(SharpEdges, OfAWedgeAreLeftOutWhereTheyAreNarrower)
{
  const auto lines = [](double degrees, double straight) {
    return medial::sharpLines(Surface(meshes::wedge(degrees)).set, angle, straight).size();
  };
  EXPECT_EQ(lines(45, 180), 9);
  EXPECT_EQ(lines(45, 120), 7); // without two along z
  EXPECT_EQ(lines(59, 120), 7); // and 31 degrees
  EXPECT_EQ(lines(20, 120), 8); // 20 and 70 degrees
}

/// The pieces lie on the lines and cover them, with the normals of the walls beside them.
TEST(WedgeEdges, AreShortPiecesOfTheLines)
{
  const Surface wedge(meshes::wedge(30));
  const double spacing = 0.1;
  const std::vector<medial::WedgeEdge> pieces = medial::wedgeEdges(wedge.set, wedge.lines, spacing);
  double length = 0, expected = 0;
  for (const medial::WedgeEdge& piece : pieces)
  {
    const Point along = piece.ends[1] - piece.ends[0];
    EXPECT_LE(along.norm(), spacing);
    length += along.norm();
    for (const Point& normal : piece.normals)
    {
      EXPECT_NEAR(normal.dot(along), 0, 1e-12);
    }
  }
  for (const SharpLine& line : wedge.lines)
  {
    for (const SharpEdge& edge : line)
    {
      expected += (wedge.points[edge.ends[1]] - wedge.points[edge.ends[0]]).norm();
    }
  }
  EXPECT_NEAR(length, expected, 1e-9);
}

TEST(WedgeEdges, AreNoneOfShortLines)
{
  const Surface wedge(meshes::wedge(30));
  EXPECT_EQ(medial::wedgeEdges(wedge.set, wedge.lines, 10).size(), 0);
}

/// For each sample there is the mirror image in the plane that halves the edge next to it.
TEST(MirroredSamples, AreMirrorImages)
{
  const double spacing = 0.1;
  const std::vector<SurfacePoint> samples =
    Surface(meshes::box(Point::Zero(), Point::Ones())).samples(spacing);
  EXPECT_EQ(samples.size(), 6 * 36); // a ring of 10 x 10 on each side
  for (const SurfacePoint& sample : samples)
  {
    // Across the edge between the side that it is on and the next one.
    int on = 0;
    (sample.position - Point::Constant(0.5)).cwiseAbs().maxCoeff(&on);
    Point off = (sample.position - Point::Constant(0.5)).cwiseAbs();
    off[on] = 0;
    int next = 0;
    EXPECT_NEAR(off.maxCoeff(&next), 0.5 - spacing / 2, 1e-12);
    Point image = sample.position;
    const double side = sample.position[next] < 0.5 ? 0 : 1;
    image[next] = side;
    image[on] = std::abs(sample.position[on] - spacing / 2);
    EXPECT_TRUE(std::any_of(samples.begin(), samples.end(),
      [&image](const SurfacePoint& other) { return (other.position - image).norm() < 1e-9; }));
    EXPECT_EQ(std::abs(sample.normal[on]), 1);
  }
}

TEST(MirroredSamples, AreBesideConcaveEdges)
{
  const std::vector<SurfacePoint> samples = Surface(meshes::iBeam(5)).samples(0.25);
  const auto near = [&samples](const Point& place) {
    return std::count_if(samples.begin(), samples.end(), [&](const SurfacePoint& sample) {
      return std::abs((sample.position - place).head<2>().cwiseAbs().sum() - 0.125) < 1e-9;
    });
  };
  EXPECT_EQ(near(Point(1, 1, 0)), 2 * 20); // along an inner edge of length 5
  EXPECT_EQ(near(Point(0, 0, 0)), 2 * 20); // and an outer one
}

/// Pairs beside the edge along z, each at the same height and as far from it as its mirror image, in rows up to
/// where the wedge is two spacings thick.
TEST(MirroredSamples, AreInRowsInANarrowWedge)
{
  const double degrees = 20, spacing = 0.05;
  double farthest = 0;
  const std::vector<SurfacePoint> samples = Surface(meshes::wedge(degrees)).samples(spacing);
  for (const SurfacePoint& sample : samples)
  {
    const bool isOnWall = std::abs(sample.normal.z()) < 0.5 && sample.normal.x() < 0.5;
    const Point& p = sample.position;
    const double r = std::hypot(p.x(), p.y());
    const bool isInTheMiddle = std::min(p.z(), 1 - p.z()) > 0.2 && r < 0.6;
    if (isOnWall && isInTheMiddle)
    {
      const double turn = degrees * 3.14159265358979323846 / 180;
      const Point image =
        p.y() < 1e-9 ? Point(r * std::cos(turn), r * std::sin(turn), p.z()) : Point(r, 0, p.z());
      EXPECT_TRUE(std::any_of(samples.begin(), samples.end(),
        [&image](const SurfacePoint& other) { return (other.position - image).norm() < 1e-9; }))
        << p.transpose();
      farthest = std::max(farthest, r);
    }
  }
  const double row = 2 * spacing / (2 * std::tan(degrees * 3.14159265358979323846 / 360));
  EXPECT_GT(farthest, row - 1.5 * spacing);
  EXPECT_LT(farthest, row + 1.5 * spacing);
}

TEST(MirroredSamples, AreNoneOnShortLinesAndNarrowFaces)
{
  EXPECT_TRUE(Surface(meshes::box(Point::Zero(), Point::Ones())).samples(0.5).empty());
  const std::vector<SurfacePoint> plate =
    Surface(meshes::box(Point::Zero(), Point(1, 1, 0.01))).samples(0.1);
  EXPECT_TRUE(plate.empty()); // the sides are too low
}
}
