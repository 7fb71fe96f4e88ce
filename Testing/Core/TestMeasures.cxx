// SPDX-License-Identifier: BSD-3-Clause
#include "Pipelines.h"

#include "AxisEdges.h"
#include "Measures.h"

#include <algorithm>

using medial::allMeasures;
using medial::Index;
using medial::Measure;
using medial::MeasureTraits;
using medial::MedialAxis;
using medial::MedialPart;
using medial::None;
using medial::Partition;
using medial::Pruned;
using medial::PruneOptions;
using pipelines::forEachShape;
using pipelines::Pipeline;

namespace
{
Partition partitionOf(const MedialAxis& axis)
{
  return medial::partition(axis.cells, medial::axisEdges(axis.cells));
}

std::vector<double> significance(const MedialAxis& axis, Measure measure)
{
  return medial::PartMeasures(axis).significance(measure, partitionOf(axis));
}
}

TEST(Measures, AreThoseOfTheParts)
{
  forEachShape([](Pipeline& p) {
    const std::vector<MedialPart>& parts = p.parts().parts;
    const auto expectValues = [&](Measure measure, double MedialPart::*value) {
      SCOPED_TRACE(testing::Message() << "measure " << static_cast<int>(measure));
      const std::vector<double> values = significance(p.axis(), measure);
      ASSERT_EQ(values.size(), parts.size());
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        EXPECT_NEAR(values[i], parts[i].*value, 1e-12 * (1 + values[i])) << "part " << i;
      }
    };
    expectValues(Measure::RelativeVolume, &MedialPart::relativeVolume);
    expectValues(Measure::Area, &MedialPart::area);
    expectValues(Measure::MeanRadius, &MedialPart::meanRadius);
    expectValues(Measure::MaximumRadius, &MedialPart::maximumRadius);
  });
}

TEST(Measures, AreFoundByTheirNumbers)
{
  for (const MeasureTraits& traits : allMeasures())
  {
    EXPECT_EQ(medial::findMeasure(static_cast<int>(traits.measure)), &traits);
  }
  EXPECT_EQ(medial::findMeasure(-1), nullptr);
  EXPECT_EQ(medial::findMeasure(77), nullptr);
}

TEST(Measures, DecideInTheSchedule)
{
  Pipeline& p = pipelines::of("box");
  const Partition parts = partitionOf(p.axis());
  for (const MeasureTraits& traits : allMeasures())
  {
    SCOPED_TRACE(traits.name);
    const std::vector<double> values = significance(p.axis(), traits.measure);
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const double threshold = sorted[sorted.size() / 2];
    PruneOptions options;
    options.schedule = { { traits.measure, threshold, 1 } };
    options.removeHair = options.removeBranches = false;
    const Pruned pruned = medial::prune(p.axis(), options);
    EXPECT_EQ(pruned.axis.betti, p.shape.betti);
    EXPECT_GT(pruned.history.at(0).removed, 0);
    for (Index cell = 0; cell < medial::count(pruned.removedInIteration); ++cell)
    {
      if (pruned.removedInIteration[cell] != None)
      {
        EXPECT_LE(values[parts.partOfCell[cell]], threshold);
      }
    }
    options.schedule[0].passes = 0;
    EXPECT_EQ(medial::prune(p.axis(), options).axis.betti, p.shape.betti);
  }
}

TEST(Measures, OfSeveralPartsAddUpOrAreTheLargest)
{
  EXPECT_EQ(medial::together(Measure::Area, 2, 3), 5);
  EXPECT_EQ(medial::together(Measure::MaximumRadius, 2, 3), 3);
}
