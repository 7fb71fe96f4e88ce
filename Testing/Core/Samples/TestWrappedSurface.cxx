// SPDX-License-Identifier: BSD-3-Clause
#include "Samples/WrappedSurface.h"

#include "Base/SurfaceTree.h"
#include "Executions.h"
#include "Meshes.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using medial::Betti;
using medial::ClosedSurface;
using medial::Index;
using medial::Point;
using meshes::Mesh;

constexpr double width = 0.2, offset = 0.01;

ClosedSurface wrap(const Mesh& mesh)
{
  return medial::wrappedSurface(mesh.points, mesh.polygons, { width, offset });
}

/// All points of the mesh are inside.
void expectAround(const ClosedSurface& surface, const Mesh& mesh)
{
  EXPECT_TRUE(surface.measures.closed && surface.measures.manifold);
  const medial::SurfaceTree tree(surface.points, surface.triangles);
  for (const Point& p : mesh.points)
  {
    ASSERT_TRUE(tree.encloses(p));
  }
}

TEST(WrappedSurface, GoesAroundPiecesThatIntersect)
{
  const Mesh box = meshes::box(Point::Zero(), Point::Ones());
  const Mesh mesh = meshes::united(box, meshes::moved(box, Point(0.5, 0.4, 0.3)));
  const ClosedSurface surface = wrap(mesh);
  expectAround(surface, mesh);
  EXPECT_EQ(surface.measures.betti, (Betti{ 1, 0, 0 }));
  const double united = 2 - 0.5 * 0.6 * 0.7, area = 12;
  EXPECT_GT(surface.measures.volume, united);
  EXPECT_LT(surface.measures.volume, united + 1.2 * offset * area);
  ASSERT_EQ(surface.warnings.size(), 1);
  EXPECT_EQ(surface.warnings[0].code, "wrapped");
  EXPECT_FALSE(surface.warnings[0].doubtsSolid);
}

TEST(WrappedSurface, CrossesHolesThatAreNarrowerThanItsWidth)
{
  const Mesh mesh = meshes::triangulated(meshes::torus(2, 0.7, 80, 40));
  const Mesh open = meshes::without(mesh, [](Index i) { return i == 300 || i == 900; });
  const ClosedSurface surface = medial::wrappedSurface(open.points, open.polygons, { 0.8, offset });
  expectAround(surface, mesh);
  EXPECT_EQ(surface.measures.betti, (Betti{ 1, 1, 0 }));
  const ClosedSurface whole = medial::closedSurface(mesh.points, mesh.polygons);
  EXPECT_GT(surface.measures.volume, whole.measures.volume);
  EXPECT_LT(surface.measures.volume, whole.measures.volume + 3 * offset * whole.area);
}

TEST(WrappedSurface, GoesInsideThroughALargerHole)
{
  const Mesh box = meshes::box(Point::Zero(), Point::Ones());
  const Mesh open = meshes::without(box, [](Index i) { return i == 5; });
  EXPECT_THROW(wrap(open), medial::InvalidInput);
  const ClosedSurface surface = medial::wrappedSurface(open.points, open.polygons, { 3, offset });
  expectAround(surface, open);
  EXPECT_GT(surface.measures.volume, 0.9);
}

TEST(WrappedSurface, TellsTheNearestPolygonOfEachTriangle)
{
  const Mesh box = meshes::box(Point::Zero(), Point::Ones());
  const ClosedSurface surface = wrap(box);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    Point middle = Point::Zero();
    for (const Index corner : surface.triangles[t])
    {
      middle += surface.points[corner] / 3;
    }
    ASSERT_GE(surface.polygons[t], 0);
    ASSERT_LT(surface.polygons[t], 6);
    const auto side = box.polygons[surface.polygons[t]];
    const Point a = box.points[side[0]], b = box.points[side[1]], c = box.points[side[2]];
    const Point normal = (b - a).cross(c - a).normalized();
    EXPECT_LT(std::abs(normal.dot(middle - a)), 2 * offset);
  }
}

TEST(WrappedSurface, RefusesWhatItCannotWrap)
{
  const Mesh box = meshes::box(Point::Zero(), Point::Ones());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(medial::wrappedSurface(box.points, {}), medial::InvalidInput);
  EXPECT_THROW(medial::wrappedSurface(box.points, box.polygons, { -1, 0 }), medial::InvalidInput);
  EXPECT_THROW(medial::wrappedSurface(box.points, box.polygons, { 0, nan }), medial::InvalidInput);
}

TEST(WrappedSurface, CanBeStopped)
{
  const Mesh mesh = meshes::torus();
  pipelines::expectProgressAndAbort([&mesh](const medial::Execution& execution) {
    medial::wrappedSurface(mesh.points, mesh.polygons, {}, execution);
  });
}
}
