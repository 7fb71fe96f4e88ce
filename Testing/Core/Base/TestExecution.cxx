// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Execution.h"
#include "Executions.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

using medial::Execution;
using medial::Index;
using pipelines::Watch;

TEST(Execution, ReportsStepsAsSharesOfTheWhole)
{
  Watch watch;
  const Execution whole = watch.execution();
  const Execution step = whole.between(0.5, 0.7);
  step.report(0);
  step.report(0.5);
  step.between(0.5, 1).report(0.5);
  ASSERT_EQ(watch.reports.size(), 3u);
  EXPECT_DOUBLE_EQ(watch.reports[0], 0.5);
  EXPECT_DOUBLE_EQ(watch.reports[1], 0.6);
  EXPECT_DOUBLE_EQ(watch.reports[2], 0.65);
}

TEST(Execution, NeverReportsLessThanBefore)
{
  Watch watch;
  const Execution whole = watch.execution();
  whole.report(0.5);
  whole.between(0, 0.4).report(1);
  const Execution step = whole.between(0.5, 1);
  step.report(0.4);
  step.poll();
  step.report(0.2);
  whole.poll();
  whole.report(0.6);
  EXPECT_EQ(watch.reports, (std::vector<double>{ 0.5, 0.5, 0.7, 0.7, 0.7, 0.7, 0.7 }));
}

TEST(Execution, CallsTheBodyOnceForEachNumber)
{
  for (const Index count : { 0, 1, 4095, 4096, 4097, 20000 })
  {
    for (const Execution& execution : { Execution(), pipelines::threaded() })
    {
      std::vector<std::atomic<int>> calls(count);
      execution.forEach(count, [&](Index i) { ++calls[i]; });
      for (const std::atomic<int>& number : calls)
      {
        EXPECT_EQ(number, 1);
      }
    }
  }
}

TEST(Execution, CanBeStoppedInAParallelLoop)
{
  Watch watch;
  Execution execution = watch.execution();
  execution.parallelFor = pipelines::threaded().parallelFor;
  const auto stopLater = execution.progress;
  execution.progress = [&](double done) { return stopLater(done) && watch.reports.size() < 3; };
  std::atomic<Index> calls{ 0 };
  const Index count = 1000000;
  EXPECT_THROW(execution.forEach(count, [&](Index) { ++calls; }), medial::Aborted);
  EXPECT_EQ(watch.reports.size(), 3u);
  EXPECT_LT(calls, count / 10);
}
