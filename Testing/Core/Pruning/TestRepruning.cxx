// SPDX-License-Identifier: BSD-3-Clause
#include "PruningTest.h"

#include <algorithm>
#include <random>

using medial::Index;
using medial::MedialAxis;
using medial::PruneOptions;
using medial::Topology;

TEST(Pruning, AgainIsAsForTheFirstTime)
{
  // With whatever options, where the last schedule began with the same iterations or not.
  const auto expectSame = [](const MedialAxis& axis, std::mt19937& random) {
    medial::PrunableAxis prunable(axis);
    PruneOptions options;
    for (int i = 0; i < 12; ++i)
    {
      SCOPED_TRACE(testing::Message() << "pruning " << i);
      const auto isTime = [&random](unsigned one) { return random() % one == 0; };
      options.automatic = isTime(8);
      options.removeHair = options.removeHair != isTime(4);
      options.removeBranches = options.removeBranches != isTime(4);
      options.neckRatio = isTime(4) ? 0.5 - options.neckRatio : options.neckRatio;
      options.topology = isTime(4) ? static_cast<Topology>(random() % 3) : options.topology;
      if (isTime(4))
      {
        options.cellsToProtect.assign(1, static_cast<Index>(random() % axis.cells.size()));
      }
      options.schedule.resize(random() % (options.schedule.size() + 1));
      const unsigned more = random() % 3; // none: the schedule is the last one or its beginning
      for (unsigned j = 0; j < more; ++j)
      {
        const medial::MeasureTraits& traits =
          medial::allMeasures()[random() % medial::allMeasures().size()];
        const double threshold =
          std::min(random() % 4 * 0.6, medial::largestThreshold(traits.unit));
        options.schedule.push_back({ traits.measure, threshold, static_cast<int>(random() % 3) });
      }
      const unsigned removed = random() % 2;
      options.cellsToRemove.assign(removed, static_cast<Index>(random() % axis.cells.size()));
      options.verifyTopology = axis.cells.size() < 1000 && random() % 4 == 0;
      EXPECT_EQ(pipelines::bytesOf(medial::prune(prunable, options)),
        pipelines::bytesOf(medial::prune(axis, options)));
    }
  };
  for (unsigned seed = 400; seed < 430; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    expectSame(complexes::randomComplex(seed).axis(), random);
    if (seed < 403)
    {
      expectSame(pipelines::of("two-hole plate").axis(), random);
    }
  }
}

TEST(Pruning, AgainWithTheSameScheduleOrItsBeginningGivesTheSameReasons)
{
  // What parts took over in the last iteration decides why they are left.
  PruneOptions options;
  options.schedule = medial::parseSchedule("t5 t5 v1%");
  PruneOptions beginning = options;
  beginning.schedule.pop_back();
  for (const char* name : { "box", "capsule" })
  {
    SCOPED_TRACE(name);
    const MedialAxis& axis = pipelines::of(name).axis();
    medial::PrunableAxis prunable(axis);
    for (const PruneOptions& again : { options, options, beginning })
    {
      EXPECT_EQ(medial::prune(prunable, again).keepReason, medial::prune(axis, again).keepReason);
    }
  }
}
