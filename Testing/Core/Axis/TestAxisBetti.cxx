// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Axis/AxisBetti.h"

using medial::Betti;
using pipelines::Pipeline;

TEST(AxisBetti, IsThatOfTheRanks)
{
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const medial::MedialAxis axis = complexes::randomComplex(seed).axis();
    EXPECT_EQ(medial::bettiNumbers(axis.cells), pipelines::independentBetti(axis));
  }
}

TEST(AxisBetti, IsThatOfTheRanksForAxesOfShapes)
{
  pipelines::forEachShape([](Pipeline& p) {
    EXPECT_EQ(medial::bettiNumbers(p.axis().cells), pipelines::independentBetti(p.axis()));
  });
}

TEST(AxisBetti, OfNothingIsNone)
{
  EXPECT_EQ(medial::bettiNumbers({}), (Betti{ 0, 0, 0 }));
}

TEST(AxisBetti, CountsPiecesTunnelsAndVoids)
{
  // A vertex; a loop of edges; the surface of a tetrahedron, and one with a wall across.
  EXPECT_EQ(medial::bettiNumbers({ { 7 }, {}, {} }), (Betti{ 1, 0, 0 }));
  EXPECT_EQ(medial::bettiNumbers({ {}, { { 0, 1 }, { 1, 2 }, { 2, 0 } }, {} }), (Betti{ 1, 1, 0 }));
  medial::AxisCells closed{ {}, {}, { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 2, 3 }, { 1, 2, 3 } } };
  EXPECT_EQ(medial::bettiNumbers(closed), (Betti{ 1, 0, 1 }));
  closed.triangles.insert(
    closed.triangles.end(), { { 0, 1, 4 }, { 0, 2, 4 }, { 1, 2, 4 } }); // shares 0, 1, 2
  EXPECT_EQ(medial::bettiNumbers(closed), (Betti{ 1, 0, 2 }));
  closed.vertices = { 9 };
  EXPECT_EQ(medial::bettiNumbers(closed), (Betti{ 2, 0, 2 }));
}
