// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Axis/Erosion.h"
#include "Base/Neighbors.h"
#include "Measuring/Centerlines.h"
#include "Rods.h"

#include <cmath>
#include <limits>

using complexes::Drawing;
using medial::Centerline;
using medial::CenterlineNode;
using medial::CenterlineOptions;
using medial::Centerlines;
using medial::Index;
using medial::MedialAxis;
using medial::None;
using medial::Point;
using pipelines::forEachShape;
using pipelines::Pipeline;
using rods::Rod;

namespace
{
const CenterlineOptions everywhere{ 0 };

MedialAxis axisOfSamples(const std::vector<Point>& samples)
{
  return medial::medialAxis(medial::polarBalls(samples));
}

Centerlines linesOf(const std::vector<Point>& samples)
{
  return medial::centerlines(axisOfSamples(samples));
}

double lengthOf(const Centerline& branch)
{
  return medial::lengths(branch.points).back();
}

/// A drawing's axis with its fire.
MedialAxis burnt(const Drawing& drawing)
{
  MedialAxis axis = drawing.axis();
  const medial::Erosion fire = medial::erosion(axis);
  axis.erosion = fire.ofPoint;
  axis.cellErosion = fire.ofCell;
  return axis;
}

/// Pieces and loops of the graph of branches and nodes; loops without nodes have one of each.
medial::Betti bettiOf(const Centerlines& lines)
{
  validators::Complex graph;
  const Index nodes = medial::count(lines.nodes);
  for (Index i = 0; i < medial::count(lines.branches); ++i)
  {
    // Two points of its own, so that it is no edge twice.
    const auto [a, b] = lines.branches[i].nodes;
    const Index c = nodes + 3 * i, first = a == None ? c + 2 : a, last = a == None ? c + 2 : b;
    graph.edges.insert(graph.edges.end(), { { first, c }, { c, c + 1 }, { c + 1, last } });
  }
  return validators::bettiNumbers(graph);
}

/// Nodes are where branches end, and know how many do.
void expectConsistent(const Centerlines& lines)
{
  std::vector<Index> degrees(lines.nodes.size(), 0);
  for (const Centerline& branch : lines.branches)
  {
    ASSERT_GE(branch.points.size(), 2u);
    ASSERT_EQ(branch.points.size(), branch.radii.size());
    ASSERT_EQ(branch.points.size(), branch.halfWidths.size());
    const auto [first, last] = branch.nodes;
    if (first == None)
    {
      EXPECT_EQ(last, None);
      EXPECT_EQ(branch.points.front(), branch.points.back());
      continue;
    }
    ++degrees[first], ++degrees[last];
    EXPECT_EQ(branch.points.front(), lines.nodes[first].point);
    EXPECT_EQ(branch.points.back(), lines.nodes[last].point);
    EXPECT_EQ(branch.radii.front(), lines.nodes[first].radius);
    EXPECT_EQ(branch.radii.back(), lines.nodes[last].radius);
  }
  for (std::size_t i = 0; i < degrees.size(); ++i)
  {
    EXPECT_EQ(degrees[i], lines.nodes[i].degree);
  }
}

std::string bytesOf(const Centerlines& lines)
{
  pipelines::Bytes bytes;
  for (const Centerline& branch : lines.branches)
  {
    bytes.add(branch.points).add(branch.radii).add(branch.halfWidths);
    bytes.add(branch.nodes[0]).add(branch.nodes[1]);
  }
  for (const CenterlineNode& node : lines.nodes)
  {
    bytes.add(node.point).add(node.radius).add(node.degree).add(node.isAtPlate);
  }
  return bytes.add(lines.openedVoids).text;
}

/// How many branches and nodes there are.
std::vector<std::size_t> countsOf(const Centerlines& lines)
{
  return { lines.branches.size(), lines.nodes.size() };
}

/// Points of the surface of a union of rods, many times denser than samples.
std::vector<Point> densePoints(const std::vector<Rod>& all, std::size_t number, unsigned seed)
{
  rods::Random random(seed);
  std::vector<Point> result;
  while (result.size() < number)
  {
    const auto which =
      static_cast<std::size_t>(shapes::uniform(random, 0, static_cast<double>(all.size())));
    const Point point = rods::pointOn(all[std::min(which, all.size() - 1)], random);
    const bool isInside = std::any_of(
      all.begin(), all.end(), [&point](const Rod& rod) { return rod.outside(point) < -1e-9; });
    if (!isInside)
    {
      result.push_back(point);
    }
  }
  return result;
}

/// All in radii.
struct Miss
{
  double middle;
  double radius; ///< of the largest ball about a point
};

/// How far lines are at most from the middle of rods, and their radii from the distance to the surface of all rods. In a
/// fork that is more than the radius of each rod.
Miss miss(const Centerlines& lines, const std::vector<Rod>& all)
{
  const std::vector<Point> surface = densePoints(all, 300000, 1);
  const medial::Neighbors nearest(surface);
  Miss worst{ 0, 0 };
  for (const Centerline& branch : lines.branches)
  {
    for (std::size_t i = 0; i < branch.points.size(); ++i)
    {
      const Point& x = branch.points[i];
      const auto distance = [&x](const Rod& rod) { return (x - rod.at(rod.nearest(x))).norm(); };
      const Rod& rod = *std::min_element(all.begin(), all.end(),
        [&](const Rod& a, const Rod& b) { return distance(a) < distance(b); });
      worst.middle = std::max(worst.middle, distance(rod) / rod.radiusAt(rod.nearest(x)));
      const double radius = (surface[nearest.nearestOne(x)] - x).norm();
      worst.radius = std::max(worst.radius, std::abs(branch.radii[i] / radius - 1));
    }
  }
  return worst;
}
}

TEST(Centerlines, OfAVesselTreeAreItsVessels)
{
  const rods::Frame tree = rods::vesselTree();
  for (const auto& [spacing, seed] : { std::pair(0.1, 2u), std::pair(0.08, 1u), std::pair(0.08, 2u),
         std::pair(0.08, 3u), std::pair(0.05, 2u), std::pair(0.05, 3u) })
  {
    SCOPED_TRACE(testing::Message() << "spacing " << spacing << ", seed " << seed);
    const Centerlines lines = linesOf(rods::samples(tree.rods(), spacing, seed));
    expectConsistent(lines);
    EXPECT_EQ(countsOf(lines), (std::vector<std::size_t>{ 8, 8 }));
    EXPECT_EQ(bettiOf(lines), (medial::Betti{ 1, 1, 0 }));
    const Miss worst = miss(lines, tree.rods());
    EXPECT_LT(worst.middle, 0.04);
    EXPECT_LT(worst.radius, 0.03);
    double length = 0, expected = 0;
    for (std::size_t i = 0; i < 8; ++i)
    {
      length += lengthOf(lines.branches[i]);
      expected += tree.rods()[i].length();
    }
    EXPECT_NEAR(length / expected, 1, 0.005);
  }
}

TEST(Centerlines, OfASpringIsOneOfItsLength)
{
  const Centerlines lines = linesOf(rods::spring(4, 0.12, 0.15, 0.055, 1));
  expectConsistent(lines);
  EXPECT_EQ(countsOf(lines), (std::vector<std::size_t>{ 1, 2 }));
  EXPECT_NEAR(lengthOf(lines.branches[0]) / (8 * rods::pi * std::sqrt(1 + 0.12 * 0.12)), 1, 0.005);
  for (const double radius : lines.branches[0].radii)
  {
    EXPECT_NEAR(radius / 0.15, 1, 0.03);
  }
}

TEST(Centerlines, OfARingCloses)
{
  const Centerlines lines = medial::centerlines(pipelines::of("torus").axis());
  expectConsistent(lines);
  EXPECT_EQ(countsOf(lines), (std::vector<std::size_t>{ 1, 0 }));
  EXPECT_NEAR(lengthOf(lines.branches[0]) / (4 * rods::pi), 1, 0.005);
  for (const Point& point : lines.branches[0].points)
  {
    EXPECT_NEAR(point.head<2>().norm(), 2, 0.01);
    EXPECT_NEAR(point.z(), 0, 0.01);
  }
}

TEST(Centerlines, OfFramesAreTheirEdges)
{
  for (const rods::Frame& frame : { rods::cubeFrame(), rods::tetrahedronFrame() })
  {
    SCOPED_TRACE(testing::Message() << frame.edges.size() << " edges, seed 1");
    const Centerlines lines = linesOf(rods::samples(frame.rods(), 0.07, 1));
    expectConsistent(lines);
    EXPECT_EQ(
      countsOf(lines), (std::vector<std::size_t>{ frame.edges.size(), frame.nodes.size() }));
    const Miss worst = miss(lines, frame.rods());
    EXPECT_LT(worst.middle, 0.1);
    EXPECT_LT(worst.radius, 0.03);
  }
}

TEST(Centerlines, EndInTheMiddleWhereARodIsCutOff)
{
  const Centerlines lines = linesOf(rods::cylinder(0.15, 1));
  ASSERT_EQ(countsOf(lines), (std::vector<std::size_t>{ 1, 2 }));
  for (const CenterlineNode& node : lines.nodes)
  {
    EXPECT_NEAR(node.point.head<2>().norm(), 0, 0.05);
    EXPECT_NEAR(std::abs(node.point.z()), 1, 0.05);
  }
}

TEST(Centerlines, AreOfRodsAlone)
{
  const auto lengthAtWidth = [](double width) {
    double result = 0;
    for (const Centerline& branch : linesOf(rods::ellipticRod(width, 0.4, 0.1, 1)).branches)
    {
      result += lengthOf(branch);
    }
    return result;
  };
  EXPECT_NEAR(lengthAtWidth(0.5), 6, 0.6);
  EXPECT_EQ(lengthAtWidth(0.8), 0);
  EXPECT_EQ(medial::centerlines(pipelines::of("ellipsoid").axis()).branches.size(), 0u);
}

TEST(Centerlines, EndWhereAPlateBegins)
{
  // A plate with a handle.
  Drawing drawing;
  drawing.sheet(Point(-20, -10, 0), Point(1, 0, 0), Point(0, 1, 0), 20, 20);
  for (int i = 0; i < 30; ++i)
  {
    const Index from = drawing.point(i, 0, 0);
    drawing.edge(from, drawing.point(i + 1, 0, 0));
  }
  const Centerlines lines = medial::centerlines(burnt(drawing));
  expectConsistent(lines);
  ASSERT_EQ(countsOf(lines), (std::vector<std::size_t>{ 1, 2 }));
  EXPECT_NEAR(lengthOf(lines.branches[0]), 30, 2);
  EXPECT_EQ(lines.nodes[0].isAtPlate + lines.nodes[1].isAtPlate, 1);
}

TEST(Centerlines, KeepPiecesAndLoops)
{
  forEachShape([](Pipeline& pipeline) {
    const MedialAxis& axis = pipeline.axis();
    const Centerlines lines = medial::centerlines(axis, everywhere);
    expectConsistent(lines);
    const auto points = static_cast<Index>(axis.cells.vertices.size()); // pieces without a line
    EXPECT_EQ(bettiOf(lines), (medial::Betti{ axis.betti[0] - points, axis.betti[1], 0 }));
    EXPECT_EQ(lines.openedVoids, axis.betti[2]);
  });
}

TEST(Centerlines, KeepPiecesAndLoopsOfDrawings)
{
  for (const Drawing& drawing :
    { complexes::cycleWithLoop(), complexes::cycleWithoutLoop(), complexes::bandWithFin(),
      complexes::fourNodesAndSixParts(), complexes::boxAxis(), complexes::closedSheet(3) })
  {
    const MedialAxis axis = burnt(drawing);
    const Centerlines lines = medial::centerlines(axis, everywhere);
    EXPECT_EQ(bettiOf(lines), (medial::Betti{ axis.betti[0], axis.betti[1], 0 }));
    EXPECT_EQ(lines.openedVoids, axis.betti[2]);
  }
}

TEST(Centerlines, AreTheSameOfMovedAndMirroredSamples)
{
  const std::vector<Point> samples = rods::samples(rods::vesselTree().rods(), 0.1, 4);
  std::vector<Point> mirrored = samples;
  for (Point& point : mirrored)
  {
    point.x() = -point.x();
  }
  const auto counts = countsOf(linesOf(samples));
  EXPECT_EQ(countsOf(linesOf(mirrored)), counts);
  EXPECT_EQ(countsOf(linesOf(shapes::rotated(samples, 5))), counts);
  EXPECT_EQ(countsOf(linesOf(shapes::scaled(samples, 1e-4))), counts);
  EXPECT_EQ(countsOf(linesOf(shapes::moved(samples, Point(50, -70, 9)))), counts);
}

TEST(Centerlines, DontDependOnThreads)
{
  const MedialAxis& axis = pipelines::of("two-hole plate").axis();
  EXPECT_EQ(bytesOf(medial::centerlines(axis, everywhere)),
    bytesOf(medial::centerlines(axis, everywhere, pipelines::threaded())));
}

TEST(Centerlines, ReportProgressAndStop)
{
  pipelines::expectProgressAndAbort([](const medial::Execution& execution) {
    medial::centerlines(pipelines::of("knot").axis(), {}, execution);
  });
}

TEST(Centerlines, RefuseWhatTheyCantUse)
{
  MedialAxis axis = pipelines::of("torus").axis();
  for (const double ratio : { -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    EXPECT_THROW(medial::centerlines(axis, { ratio }), medial::InvalidInput);
  }
  axis.erosion.clear();
  EXPECT_THROW(medial::centerlines(axis), medial::InvalidInput);
}

TEST(Centerlines, OfNothingAreNone)
{
  EXPECT_TRUE(medial::centerlines(Drawing().axis()).branches.empty());
  Drawing drawing;
  drawing.vertex(drawing.point(0, 0, 0));
  EXPECT_TRUE(medial::centerlines(drawing.axis()).branches.empty());
}
