// SPDX-License-Identifier: BSD-3-Clause
#include "Complexes.h"
#include "Executions.h"
#include "Shapes.h"
#include "Struts.h"

#include "Balls/PolarBalls.h"
#include "Measuring/PlatesAndRods.h"
#include "Measuring/PointVolumes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using medial::Element;
using medial::Index;
using medial::InvalidInput;
using medial::MedialAxis;
using medial::None;
using medial::PlatesAndRods;
using medial::Point;

namespace
{
MedialAxis axisOf(const std::vector<Point>& samples)
{
  return medial::medialAxis(medial::polarBalls(samples));
}

/// How many plates, rods, and junctions of plates, of both, and of rods there are.
std::string census(const PlatesAndRods& found)
{
  Index plates = 0;
  for (const Element& element : found.elements)
  {
    plates += element.isPlate;
  }
  const Index rods = medial::count(found.elements) - plates;
  return medial::text(plates, " plates, ", rods, " rods, ", found.plateJunctions, "+",
    found.mixedJunctions, "+", found.rodJunctions, " junctions");
}

double volume(const PlatesAndRods& found, bool ofPlates)
{
  double result = 0;
  for (const Element& element : found.elements)
  {
    result += element.isPlate == ofPlates ? element.volume : 0;
  }
  return result;
}

/// Areas of plates and lengths of rods.
std::vector<double> sortedSizes(const PlatesAndRods& found)
{
  std::vector<double> result;
  for (const Element& element : found.elements)
  {
    result.push_back(element.isPlate ? element.area : element.length);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// The same counts for the samples, mirrored, and turned.
void expectCensus(const std::vector<Point>& samples, const std::string& expected)
{
  const PlatesAndRods found = medial::platesAndRods(axisOf(samples));
  EXPECT_EQ(census(found), expected);
  const std::vector<double> sizes = sortedSizes(found);
  for (const bool mirror : { true, false })
  {
    SCOPED_TRACE(mirror ? "mirrored" : "rotated");
    const PlatesAndRods moved = medial::platesAndRods(
      axisOf(mirror ? shapes::mirrored(samples) : shapes::rotated(samples, 3)));
    EXPECT_EQ(census(moved), expected);
    EXPECT_NEAR(volume(moved, true), volume(found, true), 0.02 * volume(found, true));
    EXPECT_NEAR(volume(moved, false), volume(found, false), 0.02 * volume(found, false));
    const std::vector<double> movedSizes = sortedSizes(moved);
    ASSERT_EQ(movedSizes.size(), sizes.size());
    for (std::size_t i = 0; i < sizes.size(); ++i)
    {
      // Where in the largest balls of a junction rods meet is a matter of rounding.
      EXPECT_NEAR(movedSizes[i], sizes[i], 0.15 * sizes.back());
    }
  }
}

void expectCensus(const std::vector<shapes::Strut>& struts, double radius, double spacing,
  const std::string& expected)
{
  for (const unsigned seed : { 1u, 2u })
  {
    SCOPED_TRACE(medial::text("seed ", seed));
    expectCensus(shapes::strutSamples(struts, radius, spacing, seed), expected);
  }
}

/// Of the ratios of width to thickness, over the volume.
struct Ratios
{
  double mean, median;
};

Ratios ratiosOf(const MedialAxis& axis, const PlatesAndRods& found)
{
  const std::vector<double> volumes = medial::pointVolumes(axis);
  std::vector<std::pair<double, double>> ratios;
  double whole = 0, sum = 0, below = 0;
  for (std::size_t p = 0; p < volumes.size(); ++p)
  {
    ratios.push_back({ found.widths.ratio[p], volumes[p] });
    whole += volumes[p];
    sum += volumes[p] * found.widths.ratio[p];
  }
  std::sort(ratios.begin(), ratios.end());
  const auto half = std::find_if(ratios.begin(), ratios.end(), [&](const auto& one) {
    below += one.second;
    return 2 * below >= whole;
  });
  return { sum / whole, half->first };
}

/// A band 4 long in x that is 1 wide, and `neck` wide in the middle, with burn times as a fire
/// gives them. Radius 0.1.
MedialAxis band(double neck)
{
  complexes::Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(0.125, 0, 0), Point(0, 0.125, 0), 32, 8);
  MedialAxis axis = drawing.axis();
  std::vector<double> fire;
  for (Index p = 0; p < medial::count(axis.points); ++p)
  {
    const Point& place = axis.points[p];
    const double width = std::min(1., neck + std::abs(place.x() - 2));
    fire.push_back(std::max(0., std::min(place.y(), 1 - place.y()) - (1 - width) / 2));
    axis.radii[p] = 0.1;
    axis.erosion[p] = fire[p];
  }
  for (Index cell = 0; cell < axis.cells.size(); ++cell)
  {
    medial::forPoints(axis.cells, cell,
      [&](Index p) { axis.cellErosion[cell] = std::max(axis.cellErosion[cell], fire[p]); });
  }
  return axis;
}
}

TEST(PlatesAndRods, EllipticRodsHaveTheRatioOfTheirHalfAxes)
{
  for (const double ratio : { 1., 1.25, 1.5, 2., 3., 5. })
  {
    SCOPED_TRACE(ratio);
    const MedialAxis axis = axisOf(shapes::ellipticRod(0.5 * ratio, 0.5, 0.1, 1));
    const PlatesAndRods found = medial::platesAndRods(axis);
    const Ratios ratios = ratiosOf(axis, found);
    EXPECT_NEAR(ratios.mean, ratio, 0.03 * ratio);
    EXPECT_NEAR(ratios.median, ratio, 0.02 * ratio);
    if (ratio != 1.5) // else a plate as well as a rod
    {
      EXPECT_EQ(census(found),
        ratio < 1.5 ? "0 plates, 1 rods, 0+0+0 junctions" : "1 plates, 0 rods, 0+0+0 junctions");
    }
  }
}

// A ball of a flat wall bulges between samples by a tenth of the thickness here.
TEST(PlatesAndRods, ThicknessIsThatOfTheWallsNotOfTheBalls)
{
  const MedialAxis axis = axisOf(shapes::strutSamples(shapes::plate(), 0.15, 0.08, 1));
  const PlatesAndRods found = medial::platesAndRods(axis);
  const std::vector<double> volumes = medial::pointVolumes(axis);
  double whole = 0, thickness = 0, diameter = 0;
  for (std::size_t p = 0; p < volumes.size(); ++p)
  {
    whole += volumes[p];
    thickness += volumes[p] * found.widths.thickness[p];
    diameter += volumes[p] * 2 * axis.radii[found.widths.summit[p]];
  }
  EXPECT_NEAR(thickness / whole / 0.3, 1, 0.02);
  EXPECT_GT(diameter / whole / 0.3, 1.05);
}

TEST(PlatesAndRods, CountASpring)
{
  expectCensus(shapes::spring(), 0.2, 0.08, "0 plates, 1 rods, 0+0+0 junctions");
}

TEST(PlatesAndRods, CountThreeRodsThatMeet)
{
  expectCensus(shapes::threeRods(), 0.3, 0.1, "0 plates, 3 rods, 0+0+1 junctions");
}

TEST(PlatesAndRods, CountSixRodsThatMeet)
{
  expectCensus(shapes::sixRods(), 0.25, 0.09, "0 plates, 6 rods, 0+0+1 junctions");
}

TEST(PlatesAndRods, CountTheFrameOfACube)
{
  expectCensus(shapes::cubeFrame(), 0.25, 0.09, "0 plates, 12 rods, 0+0+8 junctions");
}

TEST(PlatesAndRods, CountTheFrameOfATetrahedron)
{
  expectCensus(shapes::tetrahedronFrame(), 0.25, 0.09, "0 plates, 6 rods, 0+0+4 junctions");
}

TEST(PlatesAndRods, CountAPlate)
{
  expectCensus(shapes::plate(), 0.15, 0.06, "1 plates, 0 rods, 0+0+0 junctions");
}

TEST(PlatesAndRods, CountThreePlatesAtASeam)
{
  expectCensus(shapes::threePlates(), 0.12, 0.06, "3 plates, 0 rods, 1+0+0 junctions");
}

TEST(PlatesAndRods, CountARodBetweenTwoPlates)
{
  expectCensus(shapes::platesAndRod(), 0.12, 0.05, "2 plates, 1 rods, 0+2+0 junctions");
}

TEST(PlatesAndRods, MeasureARodBetweenTwoPlates)
{
  const auto samples = shapes::strutSamples(shapes::platesAndRod(), 0.12, 0.05, 1);
  const MedialAxis axis = axisOf(samples);
  const PlatesAndRods found = medial::platesAndRods(axis);
  ASSERT_EQ(found.elements.size(), 3u);
  for (Index e = 0; e < 3; ++e)
  {
    const Element& element = found.elements[e];
    EXPECT_EQ(element.isPlate, e < 2);
    EXPECT_NEAR(element.meanThickness, 0.24, 0.02);
    EXPECT_NEAR(element.largestThickness, 0.25, 0.02);
    EXPECT_GT(element.leastThickness, 0);
    EXPECT_NEAR(std::abs(element.direction[e < 2 ? 2 : 0]), 1, 0.02);
    EXPECT_GT(element.direction[e < 2 ? 2 : 0], 0);
  }
  EXPECT_NEAR(found.elements[0].area, 1.44, 0.1);
  EXPECT_NEAR(found.elements[1].area, 1.44, 0.1);
  EXPECT_NEAR(found.elements[2].length, 1.2, 0.25); // the rims of the plates begin a radius earlier
  const auto neighbors = found.neighbors[2];
  ASSERT_EQ(neighbors.size(), 2);
  EXPECT_EQ(neighbors[0], 0);
  EXPECT_EQ(neighbors[1], 1);
}

TEST(PlatesAndRods, VolumesOfTheElementsAreAllThereIs)
{
  const MedialAxis axis = axisOf(shapes::strutSamples(shapes::cubeFrame(), 0.25, 0.09, 1));
  double whole = 0;
  for (const double volume : axis.ballVolumes)
  {
    whole += volume;
  }
  const PlatesAndRods found = medial::platesAndRods(axis);
  EXPECT_EQ(volume(found, true), 0);
  for (const Element& element : found.elements)
  {
    EXPECT_NEAR(element.length, 2, 0.15);
  }
  EXPECT_NEAR(volume(found, false), whole, 1e-9 * whole);
}

TEST(PlatesAndRods, AClosedSheetIsAPlateOfFiniteWidth)
{
  const MedialAxis axis = axisOf(shapes::hollowSphere().samples);
  const PlatesAndRods found = medial::platesAndRods(axis);
  EXPECT_EQ(census(found), "1 plates, 0 rods, 0+0+0 junctions");
  for (const double width : found.widths.width)
  {
    EXPECT_TRUE(std::isfinite(width));
    EXPECT_GT(width, 4);
  }
}

TEST(PlatesAndRods, ASphereIsOneRod)
{
  const PlatesAndRods found = medial::platesAndRods(axisOf(shapes::sphere().samples));
  EXPECT_EQ(census(found), "0 plates, 1 rods, 0+0+0 junctions");
}

TEST(PlatesAndRods, CutAPlateAtItsNeck)
{
  EXPECT_EQ(census(medial::platesAndRods(band(0.5))), "2 plates, 0 rods, 1+0+0 junctions");
  EXPECT_EQ(
    census(medial::platesAndRods(band(0.5), { 1.5, 0.4 })), "1 plates, 0 rods, 0+0+0 junctions");
  EXPECT_EQ(census(medial::platesAndRods(band(1))), "1 plates, 0 rods, 0+0+0 junctions");
}

TEST(PlatesAndRods, DoNotDependOnUnitOrThreads)
{
  const auto samples = shapes::strutSamples(shapes::platesAndRod(), 0.12, 0.05, 1);
  MedialAxis axis = axisOf(samples);
  const PlatesAndRods found = medial::platesAndRods(axis);
  const PlatesAndRods again = medial::platesAndRods(axis, {}, pipelines::threaded());
  EXPECT_EQ(again.elementOfCell, found.elementOfCell);
  for (Point& point : axis.points)
  {
    point *= 1024;
  }
  for (auto* lengths : { &axis.radii, &axis.erosion, &axis.cellErosion })
  {
    for (double& length : *lengths)
    {
      length *= 1024;
    }
  }
  for (medial::SiteView& view : axis.siteViews)
  {
    view.lambda *= 1024;
  }
  axis.sampleSpacing *= 1024;
  const PlatesAndRods scaled = medial::platesAndRods(axis);
  EXPECT_EQ(scaled.elementOfCell, found.elementOfCell);
  EXPECT_EQ(scaled.widths.ratio, found.widths.ratio);
}

TEST(PlatesAndRods, ReportProgressAndStop)
{
  const MedialAxis axis = axisOf(shapes::strutSamples(shapes::platesAndRod(), 0.12, 0.05, 1));
  pipelines::expectProgressAndAbort(
    [&axis](const medial::Execution& execution) { medial::platesAndRods(axis, {}, execution); });
}

// A step that looked at all pairs of pages would take minutes.
TEST(PlatesAndRods, ABookOfVeryManyPagesTakesNoTime)
{
  constexpr Index pages = 100000;
  std::vector<Point> points{ { 0, 0, 0 }, { 0, 0, 1 } };
  medial::AxisCells cells;
  for (Index i = 0; i < pages; ++i)
  {
    points.emplace_back(std::cos(i), std::sin(i), 0.5);
    cells.triangles.push_back({ 0, 1, i + 2 });
  }
  for (const double erosion : { 0., 1. }) // rods, plates
  {
    MedialAxis axis;
    axis.points = points;
    axis.cells = cells;
    axis.radii.assign(points.size(), 0.1);
    axis.ballOfPoint.assign(points.size(), None);
    axis.erosion.assign(points.size(), erosion);
    axis.cellErosion.assign(pages, erosion);
    axis.siteViews.assign(pages, { 0, 0 });
    const PlatesAndRods found = medial::platesAndRods(axis);
    EXPECT_EQ(found.plateJunctions, erosion);
    EXPECT_EQ(found.elements.front().isPlate, erosion > 0);
  }
}

TEST(PlatesAndRods, RefuseRatiosThatMakeNoSense)
{
  const MedialAxis axis = band(1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double ratio : { 0.9, nan, infinity })
  {
    EXPECT_THROW(medial::platesAndRods(axis, { ratio, 0.8 }), InvalidInput);
  }
  for (const double ratio : { -0.1, 1.1, nan })
  {
    EXPECT_THROW(medial::platesAndRods(axis, { 1.5, ratio }), InvalidInput);
  }
}

TEST(PlatesAndRods, AnEmptyAxisHasNone)
{
  const PlatesAndRods found = medial::platesAndRods(complexes::axisOf({}, {}));
  EXPECT_TRUE(found.elements.empty());
  EXPECT_EQ(found.neighbors.size(), 0);
}
