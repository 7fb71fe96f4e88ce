// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/ClosedSurface.h"

#include "Executions.h"
#include "Meshes.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using medial::Betti;
using medial::ClosedSurface;
using medial::Index;
using medial::None;
using medial::Point;
using meshes::Mesh;

constexpr double pi = 3.14159265358979323846;

ClosedSurface surfaceOf(const Mesh& mesh)
{
  return medial::closedSurface(mesh.points, mesh.polygons);
}

/// What is said about polygons that bound no solid.
std::string refusal(const Mesh& mesh)
{
  try
  {
    surfaceOf(mesh);
  }
  catch (const medial::InvalidInput& error)
  {
    return error.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

testing::AssertionResult says(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos
    ? testing::AssertionSuccess()
    : testing::AssertionFailure() << "\"" << text << "\" does not say \"" << part << "\"";
}

void expectMeasures(const ClosedSurface& surface, const Betti& betti, double volume, double area)
{
  EXPECT_TRUE(surface.measures.closed && surface.measures.manifold);
  EXPECT_EQ(surface.measures.betti, betti);
  EXPECT_NEAR(surface.measures.volume, volume, 1e-9 * volume);
  EXPECT_NEAR(surface.area, area, 1e-9 * area);
  ASSERT_EQ(surface.polygons.size(), surface.triangles.size());
}

void expectNoRepairs(const ClosedSurface& surface)
{
  EXPECT_EQ(surface.repairs.mergedPoints, 0);
  EXPECT_EQ(surface.repairs.droppedPolygons, 0);
  EXPECT_EQ(surface.repairs.filledHoles, 0);
  EXPECT_EQ(surface.repairs.filledTriangles, 0);
  EXPECT_TRUE(surface.warnings.empty());
}

Mesh unitBox()
{
  return meshes::box(Point::Zero(), Point::Ones());
}

TEST(ClosedSurface, MeasuresASolidOfPolygons)
{
  const ClosedSurface box = surfaceOf(meshes::box(Point(1, 2, 3), Point(3, 5, 4)));
  expectMeasures(box, { 1, 0, 0 }, 6, 22);
  expectNoRepairs(box);
  expectMeasures(surfaceOf(meshes::drilledPlate(0.1)), { 1, 1, 0 }, 1.5, 2 * 15 + 20 * 0.1);
  expectMeasures(surfaceOf(meshes::iBeam(5)), { 1, 0, 0 }, 35, 2 * 7 + 16 * 5);
  EXPECT_EQ(surfaceOf(meshes::torus()).measures.betti, (Betti{ 1, 1, 0 }));
  const double sector = std::sin(2 * pi / 48) / 2;
  EXPECT_NEAR(surfaceOf(meshes::cylinder(1, 2)).measures.volume, 48 * sector * 2, 1e-9);
}

TEST(ClosedSurface, KnowsPiecesAndVoids)
{
  const Mesh large = meshes::sphere(), small = meshes::sphere(0.5);
  const ClosedSurface hollow = surfaceOf(meshes::united(large, meshes::reversed(small)));
  EXPECT_EQ(hollow.measures.betti, (Betti{ 1, 0, 1 }));
  const double solid = surfaceOf(large).measures.volume;
  EXPECT_NEAR(hollow.measures.volume, solid * 7 / 8, 1e-9);
  const Mesh beside = meshes::moved(unitBox(), Point(1.01, 0, 0));
  expectMeasures(surfaceOf(meshes::united(unitBox(), beside)), { 2, 0, 0 }, 2, 12);
}

/// How the pieces are turned in the file makes no difference: nesting decides.
TEST(ClosedSurface, OrientsEachPiece)
{
  const Mesh large = meshes::sphere(), small = meshes::sphere(0.5);
  for (const Mesh& outer : { large, meshes::reversed(large) })
  {
    for (const Mesh& inner : { small, meshes::reversed(small) })
    {
      const ClosedSurface surface = surfaceOf(meshes::united(outer, inner));
      EXPECT_EQ(surface.measures.betti, (Betti{ 1, 0, 1 }));
      EXPECT_GT(surface.measures.volume, 0);
    }
  }
}

TEST(ClosedSurface, OrientsEachTriangle)
{
  Mesh mesh = meshes::triangulated(meshes::torus());
  for (Index i = 0; i < mesh.polygons.size(); i += 3)
  {
    std::swap(mesh.polygons.items[3 * i], mesh.polygons.items[3 * i + 1]);
  }
  const ClosedSurface as = surfaceOf(meshes::triangulated(meshes::torus()));
  const ClosedSurface turned = surfaceOf(mesh);
  EXPECT_EQ(turned.measures.betti, (Betti{ 1, 1, 0 }));
  EXPECT_NEAR(turned.measures.volume, as.measures.volume, 1e-9);
  EXPECT_EQ(turned.triangles.size(), as.triangles.size());
}

TEST(ClosedSurface, MergesRepeatedPoints)
{
  const Mesh mesh = meshes::soup(meshes::triangulated(meshes::drilledPlate(0.1)));
  const ClosedSurface surface = surfaceOf(mesh);
  expectMeasures(surface, { 1, 1, 0 }, 1.5, 2 * 15 + 20 * 0.1);
  EXPECT_EQ(surface.points.size(), 32);
  EXPECT_EQ(surface.repairs.mergedPoints, medial::count(mesh.points) - 32);
  EXPECT_EQ(surface.repairs.droppedPolygons, 0);
}

/// Every triangle has corners of its own, each one a little off.
Mesh jitteredSoup(double by)
{
  Mesh mesh = meshes::soup(meshes::triangulated(meshes::torus()));
  for (Index i = 0; i < medial::count(mesh.points); ++i)
  {
    mesh.points[i][i % 3] += (i % 2 ? by : -by) * (i % 7) / 7;
  }
  return mesh;
}

TEST(ClosedSurface, WeldsPointsThatDifferByRounding)
{
  const ClosedSurface whole = surfaceOf(meshes::triangulated(meshes::torus()));
  const ClosedSurface surface = surfaceOf(jitteredSoup(2e-7));
  EXPECT_EQ(surface.measures.betti, (Betti{ 1, 1, 0 }));
  EXPECT_EQ(surface.points.size(), whole.points.size());
  EXPECT_EQ(surface.repairs.filledHoles, 0);
  EXPECT_NEAR(surface.measures.volume, whole.measures.volume, 1e-5);
  EXPECT_TRUE(says(refusal(jitteredSoup(0.01)), "not closed")); // that is no rounding
}

/// Two walls nearer to each other than rounding, in a mesh that is closed.
TEST(ClosedSurface, LeavesPointsOfAClosedSurfaceApart)
{
  const Mesh mesh = meshes::box(Point::Zero(), Point(1, 1, 1e-9));
  EXPECT_EQ(surfaceOf(mesh).points.size(), 8);
}

TEST(ClosedSurface, DropsPolygonsThatAreRepeatedOrHaveNoArea)
{
  Mesh mesh = meshes::triangulated(unitBox());
  mesh.polygons.append(std::vector<Index>{
    mesh.polygons[4][1], mesh.polygons[4][2], mesh.polygons[4][0] }); // the same as 4
  mesh.polygons.append(std::vector<Index>{ 0, 0, 1 });
  mesh.polygons.append(std::vector<Index>{ 0, 1 });
  const ClosedSurface surface = surfaceOf(mesh);
  expectMeasures(surface, { 1, 0, 0 }, 1, 6);
  EXPECT_EQ(surface.repairs.droppedPolygons, 3);
}

TEST(ClosedSurface, LeavesOutPointsThatNoPolygonHas)
{
  Mesh mesh = unitBox();
  mesh.points.emplace_back(-3, -3, -3);
  mesh.points.emplace_back(0.5, 0.5, 0.5);
  const ClosedSurface surface = surfaceOf(mesh);
  expectMeasures(surface, { 1, 0, 0 }, 1, 6);
  EXPECT_EQ(surface.points.size(), 8);
}

TEST(ClosedSurface, RefusesASurfaceWithoutVolume)
{
  for (const double thin : { 0.0, 1e-300 })
  {
    Mesh flat = meshes::triangulated(unitBox());
    Mesh line = flat;
    for (Point& p : flat.points)
    {
      p.z() *= thin;
    }
    for (Point& p : line.points)
    {
      p.y() = thin * p.y();
      p.z() = thin * p.z();
    }
    EXPECT_FALSE(refusal(flat).empty());
    EXPECT_FALSE(refusal(line).empty());
  }
}

/// Each of some edges has a vertex in its middle on one side only, and a triangle without an area beside it.
TEST(ClosedSurface, DropsTheFlatTriangleOfATVertex)
{
  Mesh mesh = meshes::triangulated(unitBox());
  const auto side = mesh.polygons[0];
  const Index middle = medial::count(mesh.points);
  mesh.points.push_back((mesh.points[side[0]] + mesh.points[side[1]]) / 2);
  mesh.polygons.append(std::vector<Index>{ side[0], middle, side[1] });
  const ClosedSurface surface = surfaceOf(mesh);
  expectMeasures(surface, { 1, 0, 0 }, 1, 6);
  EXPECT_EQ(surface.repairs.droppedPolygons, 1);
  EXPECT_EQ(surface.repairs.filledHoles, 0);
}

TEST(ClosedSurface, BridgesATriangleOnALine)
{
  const ClosedSurface surface = surfaceOf(meshes::tetrahedronWithFlatTriangle());
  expectMeasures(surface, { 1, 0, 0 }, 1.0 / 6, 1.5 + std::sqrt(3.0) / 2);
  for (const medial::Triangle& t : surface.triangles)
  {
    const Point a = surface.points[t[0]], b = surface.points[t[1]], c = surface.points[t[2]];
    EXPECT_GT((b - a).cross(c - a).norm(), 0);
  }
}

/// The triangle lies in its polygon.
void expectInPolygons(const ClosedSurface& surface, const Mesh& mesh)
{
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    ASSERT_NE(surface.polygons[t], None);
    const auto polygon = mesh.polygons[surface.polygons[t]];
    for (const Index corner : surface.triangles[t])
    {
      EXPECT_TRUE(std::any_of(polygon.begin(), polygon.end(),
        [&](Index p) { return mesh.points[p] == surface.points[corner]; }));
    }
  }
}

TEST(ClosedSurface, TellsThePolygonOfEachTriangle)
{
  expectInPolygons(surfaceOf(meshes::iBeam(5)), meshes::iBeam(5));
  const Mesh mesh = meshes::soup(meshes::cylinder(1, 2));
  expectInPolygons(surfaceOf(mesh), mesh);
  Mesh turned = meshes::reversed(meshes::triangulated(meshes::torus()));
  std::swap(turned.polygons.items[0], turned.polygons.items[1]);
  expectInPolygons(surfaceOf(turned), turned);
}

TEST(ClosedSurface, FillsSmallHolesAndSaysWhere)
{
  const Mesh whole = meshes::triangulated(meshes::torus());
  const Mesh mesh = meshes::without(whole, [](Index i) { return i == 300 || i == 700; });
  const ClosedSurface surface = surfaceOf(mesh);
  EXPECT_EQ(surface.measures.betti, (Betti{ 1, 1, 0 }));
  EXPECT_NEAR(surface.measures.volume, surfaceOf(whole).measures.volume, 1e-9);
  EXPECT_EQ(surface.repairs.filledHoles, 2);
  EXPECT_EQ(surface.repairs.filledTriangles, 2);
  EXPECT_EQ(std::count(surface.polygons.begin(), surface.polygons.end(), None), 2);
  ASSERT_EQ(surface.warnings.size(), 1);
  EXPECT_EQ(surface.warnings[0].code, "filled_holes");
  EXPECT_EQ(surface.warnings[0].count, 2);
  EXPECT_TRUE(says(surface.warnings[0].text, "2 small holes"));
  EXPECT_FALSE(surface.warnings[0].doubtsSolid);
  ASSERT_TRUE(surface.warnings[0].place);
  const auto atHole = [&](Index polygon) {
    const auto corners = whole.polygons[polygon];
    return std::any_of(corners.begin(), corners.end(),
      [&](Index p) { return whole.points[p] == *surface.warnings[0].place; });
  };
  EXPECT_TRUE(atHole(300) || atHole(700));
}

TEST(ClosedSurface, RefusesAnOpenBoxWithCountAndPlace)
{
  const std::string text = refusal(meshes::without(unitBox(), [](Index i) { return i == 5; }));
  EXPECT_TRUE(says(text, "1 hole,"));
  EXPECT_TRUE(says(text, ", 1)")); // the side at z = 1 is missing
  EXPECT_TRUE(says(
    refusal(meshes::without(unitBox(), [](Index i) { return i == 5 || i == 4; })), "2 holes,"));
}

TEST(ClosedSurface, RefusesNoPolygons)
{
  EXPECT_TRUE(says(refusal({}), "no polygons"));
  EXPECT_TRUE(says(refusal({ unitBox().points, {} }), "no polygons"));
  Mesh needle = unitBox();
  needle.polygons = {};
  needle.polygons.append(std::vector<Index>{ 0, 1, 0 });
  EXPECT_TRUE(says(refusal(needle), "no polygons"));
}

TEST(ClosedSurface, RefusesPiecesThatIntersectWithCountAndPlace)
{
  const std::string text =
    refusal(meshes::united(unitBox(), meshes::moved(unitBox(), Point(0.5, 0.4, 0.3))));
  EXPECT_TRUE(says(text, " of them of separate pieces"));
  EXPECT_TRUE(says(text, "pairs of triangles intersect"));
  EXPECT_TRUE(says(text, "the first at ("));
}

/// A corner is pushed into the opposite side.
TEST(ClosedSurface, RefusesAPieceThatIntersectsItselfAllOver)
{
  Mesh mesh = meshes::triangulated(unitBox());
  mesh.points[0] = Point(3, 0.3, 0.2);
  EXPECT_TRUE(says(refusal(mesh), "0 of them of separate pieces"));
}

TEST(ClosedSurface, WarnsOfAFold)
{
  Mesh mesh = meshes::triangulated(meshes::torus(2, 0.7, 80, 40));
  mesh.points[0].x() = 1.2; // through the other side of the tube
  const ClosedSurface surface = surfaceOf(mesh);
  EXPECT_EQ(surface.measures.betti, (Betti{ 1, 1, 0 }));
  ASSERT_EQ(surface.warnings.size(), 1);
  EXPECT_EQ(surface.warnings[0].code, "self_intersections");
  EXPECT_GT(surface.warnings[0].count, 0);
  ASSERT_TRUE(surface.warnings[0].place);
  EXPECT_LT((*surface.warnings[0].place - Point(1.3, 0, 0)).norm(), 1.5);
}

/// Its one border is too large to fill.
TEST(ClosedSurface, RefusesAStripWithAHalfTurn)
{
  Mesh mesh;
  constexpr int n = 20;
  for (int i = 0; i < n; ++i)
  {
    const double u = 2 * pi * i / n;
    for (const double side : { -0.5, 0.5 })
    {
      const double r = 2 + side * std::cos(u / 2);
      mesh.points.emplace_back(r * std::cos(u), r * std::sin(u), side * std::sin(u / 2));
    }
    const Index a = 2 * i, next = (2 * i + 2) % (2 * n), turned = i + 1 == n;
    mesh.polygons.append(std::vector<Index>{ a, next + turned, next + 1 - turned, a + 1 });
  }
  refusal(mesh);
}

TEST(ClosedSurface, DoesNotDependOnUnitAndPlace)
{
  const ClosedSurface surface = surfaceOf(meshes::iBeam(5));
  const ClosedSurface larger = surfaceOf(meshes::scaled(meshes::iBeam(5), 1024));
  EXPECT_EQ(larger.triangles, surface.triangles);
  EXPECT_EQ(larger.measures.betti, surface.measures.betti);
  const ClosedSurface there = surfaceOf(meshes::moved(meshes::iBeam(5), Point(1024, 0, -2048)));
  EXPECT_EQ(there.triangles, surface.triangles);
}

TEST(ClosedSurface, CanBeStopped)
{
  const Mesh mesh = meshes::torus();
  pipelines::expectProgressAndAbort([&mesh](const medial::Execution& execution) {
    medial::closedSurface(mesh.points, mesh.polygons, execution);
  });
}
}
