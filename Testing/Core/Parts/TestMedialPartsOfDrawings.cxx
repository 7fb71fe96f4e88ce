// SPDX-License-Identifier: BSD-3-Clause
// The parts of small complexes, drawn triangle by triangle, whose parts can be told by looking at them.
#include "Pipelines.h"

#include "Parts/MedialParts.h"

#include <set>
#include <vector>

using complexes::Drawing;
using medial::ContactCurve;
using medial::Edge;
using medial::Index;
using medial::MedialAxis;
using medial::MedialPart;
using medial::MedialParts;
using medial::None;
using medial::Point;

TEST(MedialParts, OfFigure7LeftMeetAlongOneCurve)
{
  const MedialAxis axis = complexes::cycleWithoutLoop().axis();
  const MedialParts parts = medial::decompose(axis);
  ASSERT_EQ(parts.parts.size(), 3u);
  for (Index i = 0; i < 3; ++i)
  {
    EXPECT_EQ(parts.parts[i].level, 1);
    EXPECT_EQ(parts.value(medial::Measure::TriangleCount, i), 18);
    EXPECT_EQ(parts.parts[i].contacts, 1);
  }
  EXPECT_NEAR(parts.value(medial::Measure::Area, 0), 9, 1e-12);
  ASSERT_EQ(parts.contacts.size(), 1u);
  EXPECT_EQ(parts.contacts[0].parts, (std::vector<Index>{ 0, 1, 2 }));
  EXPECT_EQ(parts.contacts[0].points.size(), 4u);
}

TEST(MedialParts, OfFigure7RightMeetAlongThreeCurves)
{
  const MedialAxis axis = complexes::cycleWithLoop().axis();
  const MedialParts parts = medial::decompose(axis);
  ASSERT_EQ(parts.parts.size(), 6u);
  ASSERT_EQ(parts.contacts.size(), 3u);
  std::set<std::vector<Index>> touching;
  for (const ContactCurve& curve : parts.contacts)
  {
    EXPECT_EQ(curve.points.size(), 3u);
    touching.insert(curve.parts);
  }
  EXPECT_EQ(touching, (std::set<std::vector<Index>>{ { 0, 1, 4 }, { 0, 2, 3 }, { 1, 2, 5 } }));
  for (Index i = 0; i < 6; ++i)
  {
    EXPECT_EQ(parts.parts[i].contacts, i < 3 ? 2 : 1) << "part " << i;
    EXPECT_EQ(parts.parts[i].level, 1) << "part " << i;
  }
}

TEST(MedialParts, OfAClosedContactComeBackToItsStart)
{
  // A tube through a plate's hole: they touch along a ring of four edges.
  Drawing drawing;
  const Point x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  for (int side = -1; side <= 0; ++side)
  {
    drawing.sheet(Point(0, 0, side), x, z, 1, 1);
    drawing.sheet(Point(0, 1, side), x, z, 1, 1);
    drawing.sheet(Point(0, 0, side), y, z, 1, 1);
    drawing.sheet(Point(1, 0, side), y, z, 1, 1);
  }
  drawing.sheet(Point(-1, -1, 0), x, y, 3, 1);
  drawing.sheet(Point(-1, 1, 0), x, y, 3, 1);
  drawing.sheet(Point(-1, 0, 0), x, y, 1, 1);
  drawing.sheet(Point(1, 0, 0), x, y, 1, 1);
  const MedialParts parts = medial::decompose(drawing.axis());
  ASSERT_EQ(parts.parts.size(), 3u); // the upper and the lower half of the tube, the plate
  ASSERT_EQ(parts.contacts.size(), 1u);
  EXPECT_EQ(parts.contacts[0].points.size(), 5u);
  EXPECT_EQ(parts.contacts[0].points.front(), parts.contacts[0].points.back());
}

TEST(MedialParts, MayTouchInAPoint)
{
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 1, 1);
  drawing.sheet(Point(1, 1, 0), Point(1, 0, 0), Point(0, 1, 0), 1, 1);
  const Index a = drawing.point(1, 1, 0);
  drawing.edge(a, drawing.point(1, 1, 3));
  const MedialParts parts = medial::decompose(drawing.axis());
  ASSERT_EQ(parts.contacts.size(), 1u);
  EXPECT_EQ(parts.contacts[0].points, std::vector<Index>{ a });
  EXPECT_EQ(parts.contacts[0].parts, (std::vector<Index>{ 0, 1, 2 }));
}

TEST(MedialParts, OfAClosedSheetHaveNoLevel)
{
  const MedialParts parts = medial::decompose(complexes::closedSheet(3).axis());
  ASSERT_EQ(parts.parts.size(), 1u);
  EXPECT_EQ(parts.parts[0].level, 0);
  EXPECT_NEAR(parts.value(medial::Measure::Area, 0), 54, 1e-9);
  EXPECT_TRUE(parts.contacts.empty());
}

TEST(MedialParts, BehindAFinAreOfLevelTwo)
{
  Drawing drawing = complexes::closedSheet(3);
  drawing.sheet(Point(0, 0, 1), Point(0, 0, 1), Point(-1, -1, 0), 1, 1);
  const MedialParts parts = medial::decompose(drawing.axis());
  ASSERT_EQ(parts.parts.size(), 2u);
  EXPECT_EQ(parts.parts[0].level, 2);
  EXPECT_EQ(parts.parts[1].level, 1);
}

TEST(MedialParts, AboveTheMaximumLevelHaveNone)
{
  Drawing drawing = complexes::closedSheet(3);
  drawing.sheet(Point(0, 0, 1), Point(0, 0, 1), Point(-1, -1, 0), 1, 1);
  const MedialAxis axis = drawing.axis();
  const MedialParts parts = medial::decompose(axis, 1);
  EXPECT_EQ(parts.parts[0].level, 0);
  EXPECT_EQ(parts.parts[1].level, 1);
  EXPECT_EQ(medial::decompose(axis, 2).parts[0].level, 2);
  EXPECT_EQ(parts.partOfCell, medial::decompose(axis).partOfCell);
}

TEST(MedialParts, MayBeChainsOfEdgesAndSinglePoints)
{
  Drawing drawing;
  drawing.sheet(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), 1, 1);
  const Index a = drawing.point(2, 2, 0), b = drawing.point(3, 2, 0);
  drawing.edge(drawing.point(1, 1, 0), a);
  drawing.edge(a, b);
  drawing.vertex(drawing.point(9, 9, 9));
  const MedialParts parts = medial::decompose(drawing.axis());
  ASSERT_EQ(parts.parts.size(), 3u);
  EXPECT_EQ(parts.parts[0].dimension, 2);
  EXPECT_EQ(parts.parts[1].dimension, 1);
  EXPECT_EQ(parts.parts[2].dimension, 0);
  EXPECT_EQ(parts.partOfCell, (std::vector<Index>{ 2, 1, 1, 0, 0 }));
  EXPECT_EQ(parts.value(medial::Measure::TriangleCount, 0), 2);
  EXPECT_EQ(parts.value(medial::Measure::TriangleCount, 1), 2);
  EXPECT_EQ(parts.value(medial::Measure::TriangleCount, 2), 1);
  double sum = 0;
  for (Index i = 0; i < 3; ++i)
  {
    sum += parts.value(medial::Measure::RelativeVolume, i);
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(MedialParts, ABandWithATwistIsOne)
{
  Drawing drawing;
  for (int i = 0; i < 7; ++i)
  {
    const auto at = [&](int k, int row) {
      const bool turned = k >= 7;
      const double t = 2 * M_PI * (k % 7) / 7, v = row != static_cast<int>(turned) ? 0.5 : -0.5;
      const double r = 2 + v * std::cos(t / 2);
      return drawing.point(r * std::cos(t), r * std::sin(t), v * std::sin(t / 2));
    };
    drawing.triangle(at(i, 0), at(i + 1, 0), at(i + 1, 1));
    drawing.triangle(at(i, 0), at(i + 1, 1), at(i, 1));
  }
  const MedialAxis axis = drawing.axis();
  EXPECT_EQ(axis.betti, (medial::Betti{ 1, 1, 0 }));
  const MedialParts parts = medial::decompose(axis);
  ASSERT_EQ(parts.parts.size(), 1u);
  EXPECT_EQ(parts.parts[0].level, 1);
}

TEST(MedialParts, HaveTheLengthsOfTheirBoxes)
{
  Drawing drawing;
  drawing.sheet(Point(5, 6, 7), Point(0, 1, 0), Point(0, 0, 1), 8, 3);
  const medial::Index a = drawing.point(0, 0, 0), b = drawing.point(1, 1, 0);
  drawing.edge(a, b);
  drawing.edge(b, drawing.point(3, 3, 0));
  drawing.vertex(drawing.point(-1, 0, 0));
  const MedialParts parts = medial::decompose(drawing.axis());
  ASSERT_EQ(parts.parts.size(), 3u);
  const auto expectLengths = [&](Index part, const Point& lengths) {
    const Point error = parts.parts[part].principalLengths - lengths;
    EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-6) << "part " << part;
  };
  expectLengths(0, Point(8, 3, 0));
  expectLengths(1, Point(std::sqrt(18), 0, 0));
  expectLengths(2, Point(0, 0, 0));
}

TEST(MedialParts, KnowTheirNeighborsAndTheLoop)
{
  const MedialParts loop = medial::decompose(complexes::cycleWithLoop().axis());
  for (Index part = 0; part < 6; ++part)
  {
    EXPECT_EQ(loop.parts[part].onLoop, part < 3) << "part " << part;
    EXPECT_EQ(loop.parts[part].neighbors, part < 3 ? 4 : 2) << "part " << part;
  }
  for (const MedialPart& part : medial::decompose(complexes::cycleWithoutLoop().axis()).parts)
  {
    EXPECT_FALSE(part.onLoop);
    EXPECT_EQ(part.neighbors, 2);
  }
  EXPECT_EQ(medial::decompose(complexes::closedSheet(3).axis()).parts[0].neighbors, 0);
}
