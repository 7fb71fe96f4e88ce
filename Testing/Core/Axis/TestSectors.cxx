// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/Sectors.h"
#include "Complexes.h"

#include <gtest/gtest.h>

#include <set>

using complexes::Drawing;
using medial::Index;
using medial::Point;
using medial::Sectors;

TEST(Sectors, HoldEachCornerOnce)
{
  for (unsigned seed = 0; seed < 100; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const medial::MedialAxis axis = complexes::randomComplex(seed).axis();
    const Sectors sectors(axis.cells, medial::count(axis.points));
    std::set<Index> seen;
    std::vector<Index> sectorsAt(axis.points.size(), 0);
    for (Index corner = 0; corner < sectors.cornerCount(); ++corner)
    {
      if (sectors.sectorOf(corner) != corner)
      {
        continue;
      }
      ++sectorsAt[sectors.pointOf(corner)];
      Index last = medial::None;
      sectors.forCornersOf(corner, [&](Index other) {
        EXPECT_EQ(sectors.sectorOf(other), corner);
        EXPECT_EQ(sectors.pointOf(other), sectors.pointOf(corner));
        EXPECT_GE(other, corner);
        EXPECT_TRUE(seen.insert(other).second);
        last = other;
      });
      EXPECT_NE(last, medial::None);
    }
    EXPECT_EQ(medial::count(seen), sectors.cornerCount());
    EXPECT_EQ(sectors.sectorsAt(), sectorsAt);
  }
}

TEST(Sectors, OfASeamAreOneForEachSheet)
{
  const Drawing drawn = complexes::cycleWithoutLoop();
  Drawing drawing = drawn;
  const medial::MedialAxis axis = drawing.axis();
  const Sectors sectors(axis.cells, medial::count(axis.points));
  EXPECT_EQ(sectors.sectorsAt()[drawing.point(0, 0, 1)], 3);
  EXPECT_EQ(sectors.sectorsAt()[drawing.point(1, 0, 1)], 1);
}

TEST(Sectors, OfLinesAreTheirEnds)
{
  Drawing drawing;
  const Index a = drawing.point(0, 0, 0), b = drawing.point(1, 0, 0), c = drawing.point(2, 0, 0);
  drawing.edge(a, b);
  drawing.edge(b, c);
  drawing.triangle(a, drawing.point(0, 1, 0), drawing.point(0, 0, 1));
  const medial::MedialAxis axis = drawing.axis();
  const Sectors sectors(axis.cells, medial::count(axis.points));
  EXPECT_EQ(sectors.sectorsAt()[a], 2); // the triangle and a line
  EXPECT_EQ(sectors.sectorsAt()[b], 2);
  EXPECT_EQ(sectors.sectorsAt()[c], 1);
  std::set<Index> others;
  sectors.forLinesAt(b, [&](Index corner) {
    EXPECT_TRUE(sectors.isOfLine(corner));
    others.insert(sectors.pointOf(sectors.otherEndOfLine(corner)));
  });
  EXPECT_EQ(others, (std::set<Index>{ a, c }));
}
