// SPDX-License-Identifier: BSD-3-Clause
#ifndef Executions_h
#define Executions_h

#include "Base/Errors.h"
#include "Base/Execution.h"
#include "Base/Types.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <thread>
#include <vector>

/// Ways to run a stage: on several threads, watched, or stopped half-way.
namespace pipelines
{
using medial::Index;

/// Ranges of different lengths, taken by several threads in no particular order.
inline medial::Execution threaded(unsigned threadCount = 4)
{
  medial::Execution execution;
  execution.parallelFor = [threadCount](Index count, const medial::Execution::Range& body) {
    std::atomic<Index> next{ 0 };
    const auto work = [&] {
      for (Index step = 1;; step = step % 61 + 7)
      {
        const Index begin = next.fetch_add(step);
        if (begin >= count)
        {
          return;
        }
        body(begin, std::min(count, begin + step));
      }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < threadCount; ++i)
    {
      threads.emplace_back(work);
    }
    work();
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  };
  return execution;
}

/// All that progress said.
struct Watch
{
  std::vector<double> reports;
  double stopAt = 2; ///< where progress says no

  medial::Execution execution()
  {
    medial::Execution execution;
    execution.progress = [this](double done) {
      this->reports.push_back(done);
      return done < this->stopAt;
    };
    return execution;
  }
};

/// The stage reports often, upwards and within 0 ... 1, and stops where it is told to.
inline void expectProgressAndAbort(const std::function<void(const medial::Execution&)>& stage)
{
  Watch watch;
  stage(watch.execution());
  EXPECT_GE(watch.reports.size(), 2u);
  double last = 0;
  for (const double done : watch.reports)
  {
    EXPECT_GE(done, last);
    EXPECT_LE(done, 1);
    last = done;
  }
  for (const double stopAt : { 0.0, 0.3, 0.6, 0.9 })
  {
    SCOPED_TRACE(testing::Message() << "stopped at " << stopAt);
    Watch stopped;
    stopped.stopAt = stopAt;
    const bool everThere = last >= stopAt;
    if (everThere)
    {
      EXPECT_THROW(stage(stopped.execution()), medial::Aborted);
    }
    EXPECT_TRUE(everThere) << "progress ended at " << last;
  }
}
}

#endif
