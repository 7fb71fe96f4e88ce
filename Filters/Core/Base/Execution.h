// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Execution_h
#define medial_Execution_h

#include "Base/Errors.h"
#include "Base/Types.h"

#include <functional>

namespace medial
{
/// How a long computation reports, is stopped, and uses threads. Results never depend on it.
struct Execution
{
  using Range = std::function<void(Index begin, Index end)>;

  /// Called from the calling thread with what is done, 0 ... 1; returns false to stop.
  std::function<bool(double done)> progress;

  /// Calls body(begin, end) for ranges that together are 0 ... count - 1, in any order, on any
  /// threads. Empty: one call on this thread.
  std::function<void(Index count, const Range& body)> parallelFor;

  /// Reports progress. @throw Aborted  the caller wants to stop
  void report(double done) const
  {
    if (this->progress && !this->progress(done))
    {
      throw Aborted();
    }
  }

  /// Calls body(i) for i in 0 ... count - 1, in any order, on any threads.
  template <typename Body>
  void forEach(Index count, const Body& body) const
  {
    const Range range = [&body](Index begin, Index end) {
      for (Index i = begin; i < end; ++i)
      {
        body(i);
      }
    };
    if (this->parallelFor)
    {
      this->parallelFor(count, range);
    }
    else
    {
      range(0, count);
    }
  }

  /// For a step of the work: its progress 0 ... 1 is reported as from ... to of the whole. Example:
  /// `polarBalls(samples, execution.between(0, 0.9))`.
  Execution between(double from, double to) const
  {
    Execution result = *this;
    if (this->progress)
    {
      result.progress = [report = this->progress, from, to](
                          double done) { return report(from + done * (to - from)); };
    }
    return result;
  }
};
}

#endif
