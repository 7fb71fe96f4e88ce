// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Axis/AxisBetti.h"
#include "Axis/RimTrimming.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using complexes::Drawing;
using medial::AxisComplex;
using medial::Index;
using medial::MedialAxis;
using medial::Point;

namespace
{
/// Where samples are 1 apart.
AxisComplex trimmed(const MedialAxis& axis, double trim)
{
  return medial::trimmedRims(
    axis, medial::erosion(axis), std::vector<double>(axis.cells.size(), 1), trim);
}

double areaOf(const AxisComplex& axis)
{
  double result = 0;
  for (const medial::Triangle& corners : axis.cells.triangles)
  {
    result += medial::triangleArea(axis, corners);
  }
  return result;
}

void expectWhole(const AxisComplex& axis)
{
  const auto cells = static_cast<std::size_t>(axis.cells.size());
  EXPECT_EQ(axis.polygonOfCell.size(), cells);
  EXPECT_EQ(axis.samplesOfCell.size(), cells);
  EXPECT_EQ(axis.siteViews.size(), cells);
  EXPECT_EQ(axis.radii.size(), axis.points.size());
  EXPECT_EQ(axis.ballOfPoint.size(), axis.points.size());
  std::vector<Index> uses(axis.points.size(), 0);
  for (Index c = 0; c < axis.cells.size(); ++c)
  {
    medial::forPoints(axis.cells, c, [&](Index p) { ++uses[p]; });
  }
  EXPECT_EQ(std::count(uses.begin(), uses.end(), 0), 0);
}
}

TEST(RimTrimming, TakesTheRimOfASheet)
{
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 20, 20);
  const AxisComplex result = trimmed(drawing.axis(), 3.1);
  expectWhole(result);
  for (const medial::Triangle& corners : result.cells.triangles)
  {
    for (const Index corner : corners)
    {
      const Point& p = result.points[corner];
      EXPECT_GE(std::min({ p.x(), p.y(), 20 - p.x(), 20 - p.y() }), 2);
    }
  }
  EXPECT_LT(result.cells.edges.size(), 40u); // along diagonals of the grid, which are longer
  EXPECT_NEAR(areaOf(result), 14 * 14, 2 * 14 * 4);
  EXPECT_EQ(medial::bettiNumbers(result.cells), (medial::Betti{ 1, 0, 0 }));
}

TEST(RimTrimming, LeavesALineOfANarrowSheet)
{
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 0.5, 0), 40, 2);
  const AxisComplex result = trimmed(drawing.axis(), 0.9);
  expectWhole(result);
  EXPECT_TRUE(result.cells.triangles.empty());
  EXPECT_EQ(medial::bettiNumbers(result.cells), (medial::Betti{ 1, 0, 0 }));
  double least = 40, most = 0;
  for (const Point& p : result.points)
  {
    least = std::min(least, p.x());
    most = std::max(most, p.x());
  }
  EXPECT_LE(least, 3);
  EXPECT_GE(most, 37);
}

TEST(RimTrimming, TakesASpikeAltogether)
{
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 20, 20);
  const auto square = static_cast<std::size_t>(drawing.axis().cells.size());
  drawing.sheet(Point(10, 20, 0), Point(0.2, 0, 0), Point(0, 1, 0), 1, 8); // beyond the rim
  MedialAxis axis = drawing.axis();
  ASSERT_GT(static_cast<std::size_t>(axis.cells.size()), square);
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    axis.radii[i] = 10 - 0.98 * std::max(0.0, axis.points[i].y() - 20); // as below a small bump
  }
  const AxisComplex result = trimmed(axis, 0.15);
  expectWhole(result);
  for (const Point& p : result.points)
  {
    EXPECT_LE(p.y(), 21);
  }
  EXPECT_TRUE(result.cells.edges.empty());
  EXPECT_NEAR(areaOf(result), 400, 1);
}

TEST(RimTrimming, LeavesAClosedSheet)
{
  const MedialAxis axis = complexes::closedSheet(1).axis();
  EXPECT_EQ(trimmed(axis, 0.5).cells.triangles, axis.cells.triangles);
}

TEST(RimTrimming, KeepsTheTopology)
{
  Index taken = 0;
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MedialAxis axis = complexes::randomComplex(seed).axis();
    for (const double trim : { 0.1, 0.5, 1.0, 10.0 })
    {
      const AxisComplex result = trimmed(axis, trim);
      expectWhole(result);
      EXPECT_EQ(medial::bettiNumbers(result.cells), medial::bettiNumbers(axis.cells)) << trim;
      taken += medial::count(axis.cells.triangles) - medial::count(result.cells.triangles);
    }
  }
  EXPECT_GT(taken, 1000);
}

/// The balls of what was left out share the fate of others.
TEST(RimTrimming, LeavesTheTopologyAndTheOwnersOfShapes)
{
  pipelines::forEachShape([](pipelines::Pipeline& pipeline) {
    const MedialAxis whole = medial::medialAxis(pipeline.balls());
    medial::AxisOptions options;
    options.trim = 0.3;
    const MedialAxis axis = medial::medialAxis(pipeline.balls(), options);
    EXPECT_EQ(axis.betti, whole.betti);
    EXPECT_EQ(axis.certificate, whole.certificate);
    EXPECT_LE(axis.cells.triangles.size(), whole.cells.triangles.size());
    EXPECT_EQ(axis.erosion.size(), axis.points.size());
    EXPECT_EQ(axis.cellErosion.size(), static_cast<std::size_t>(axis.cells.size()));
    for (std::size_t b = 0; b < axis.ballOwner.size(); ++b)
    {
      EXPECT_EQ(axis.ballOwner[b] == medial::None, whole.ballOwner[b] == medial::None);
    }
  });
}
