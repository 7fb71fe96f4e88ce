// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Axis/AxisBetti.h"
#include "Parts/BettiNumbers.h"

#include <random>

using medial::Index;
using medial::MedialAxis;

TEST(BettiNumbers, AreThoseOfTheAxisAndOfTheRanks)
{
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MedialAxis axis = complexes::randomComplex(seed).axis();
    const medial::AxisEdges edges = medial::axisEdges(axis.cells);
    medial::LivingCells living(axis.cells, edges);
    const medial::Betti betti = medial::bettiNumbers(living, medial::partition(living, 1));
    EXPECT_EQ(betti, medial::bettiNumbers(axis.cells));
    EXPECT_EQ(betti, pipelines::independentBetti(axis));
  }
}

TEST(BettiNumbers, AreThoseOfWhatLives)
{
  int removals = 0;
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const MedialAxis axis = complexes::randomComplex(seed).axis();
    const medial::AxisEdges edges = medial::axisEdges(axis.cells);
    medial::LivingCells living(axis.cells, edges);
    std::mt19937 random(seed);
    medial::Partition partition = medial::partition(living, 1);
    for (int round = 0; round < 3 && partition.cells.size() > 1; ++round)
    {
      const Index part = static_cast<Index>(random() % partition.cells.size());
      living.remove({ partition.cells[part].begin(), partition.cells[part].end() });
      living.join();
      partition = medial::partition(living, 1);
      std::vector<Index> left;
      for (Index cell = 0; cell < axis.cells.size(); ++cell)
      {
        if (living.isLiving(cell))
        {
          left.push_back(cell);
        }
      }
      const MedialAxis rest = medial::withCells(axis, left, {});
      const medial::Betti betti = medial::bettiNumbers(living, partition);
      EXPECT_EQ(betti, medial::bettiNumbers(rest.cells));
      EXPECT_EQ(betti, pipelines::independentBetti(rest));
      ++removals;
    }
  }
  EXPECT_GT(removals, 300);
}
