// SPDX-License-Identifier: BSD-3-Clause
#include "Axis/OutsideSearch.h"
#include "CloudSites.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using medial::Index;
using medial::OpenSet;
using medial::SiteTriangulation;

// A cell outside is in one piece of the outside. If it joins the set, what is around it becomes several pieces: each but one
// is a void more.
TEST(OutsideSearch, TellsHowManyVoidsACellMakes)
{
  std::vector<int> voidsMade(4, 0);
  for (unsigned seed = 0; seed < 80; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const SiteTriangulation sites = cloudSites(300, seed);
    std::mt19937 random(seed);
    OpenSet set{ std::vector<char>(sites.mesh.cells.size(), 0) };
    for (char& isIn : set.cells)
    {
      isIn = random() % 60 > seed % 4; // few are outside
    }
    medial::OutsideSearch search(sites);
    for (Index cell = 0; cell < medial::count(set.cells); ++cell)
    {
      if (set.cells[cell])
      {
        continue;
      }
      const Index before = medial::bettiNumbers(sites, set)[2];
      const Index pieces = search.piecesAround(cell, set);
      set.cells[cell] = 1;
      const Index after = medial::bettiNumbers(sites, set)[2];
      set.cells[cell] = 0;
      EXPECT_EQ(after - before, pieces - 1) << "cell " << cell;
      ++voidsMade[std::min(pieces, 3)];
    }
  }
  // None around: a void filled. One, two, three and more.
  EXPECT_GT(voidsMade[0], 10);
  EXPECT_GT(voidsMade[1], 100);
  EXPECT_GT(voidsMade[2], 10);
  EXPECT_GT(voidsMade[3], 0);
}
