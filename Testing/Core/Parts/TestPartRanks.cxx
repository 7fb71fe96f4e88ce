// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "Parts/PartRanks.h"

#include <algorithm>
#include <vector>

using medial::Index;
using medial::MedialParts;

namespace
{
/// Parts with these volumes and cells.
MedialParts partsOf(const std::vector<double>& volumes, const std::vector<Index>& partOfCell)
{
  MedialParts result;
  result.partOfCell = partOfCell;
  result.parts.resize(volumes.size());
  for (std::size_t part = 0; part < volumes.size(); ++part)
  {
    result.parts[part].volume = volumes[part];
  }
  return result;
}
}

TEST(PartRanks, GoByFallingVolumeAndThenByNumber)
{
  EXPECT_EQ(medial::partRanks(partsOf({ 1, 5, 3, 5 }, { 0, 1, 2, 3 }), {}),
    (std::vector<Index>{ 3, 0, 2, 1 }));
}

TEST(PartRanks, OfWhatIsJoinedAreTheLowestOnes)
{
  EXPECT_EQ(medial::partRanks(partsOf({ 1, 9 }, { 0, 0, 1, 0 }), { 4, 2, 7, 9 }),
    (std::vector<Index>{ 2, 7 }));
}

TEST(PartRanks, OfAPartThatWasCutStayWithItsLargestPiece)
{
  EXPECT_EQ(medial::partRanks(partsOf({ 1, 2, 9, 1.5 }, { 0, 1, 2, 3 }), { 3, 3, 5, 3 }),
    (std::vector<Index>{ 7, 3, 5, 6 }));
}

TEST(PartRanks, AreUnknownWithoutRanksOfCells)
{
  EXPECT_EQ(
    medial::lowestRanks({ 0, 1, 0 }, 2, {}), (std::vector<Index>{ medial::None, medial::None }));
}

TEST(PartRanks, OfCellsAreThoseOfTheirParts)
{
  pipelines::forEachShape([](pipelines::Pipeline& pipeline) {
    const medial::AxisEdges edges = axisEdges(pipeline.axis().cells);
    const medial::LivingCells living(pipeline.axis().cells, edges);
    const medial::PartMeasures measures(pipeline.axis(), living);
    const MedialParts& parts = pipeline.parts();
    const std::vector<Index> ranks = medial::partRanks(parts, {});
    std::vector<Index> expected;
    for (const Index part : parts.partOfCell)
    {
      expected.push_back(ranks[part]);
    }
    EXPECT_EQ(medial::ranksOfCells(living, measures), expected);
    for (std::size_t part = 0; part < ranks.size(); ++part)
    {
      const double volume = parts.parts[part].volume;
      const auto larger = std::count_if(parts.parts.begin(), parts.parts.end(),
        [volume](const medial::MedialPart& other) { return other.volume > volume; });
      EXPECT_GE(ranks[part], larger);
    }
  });
}
