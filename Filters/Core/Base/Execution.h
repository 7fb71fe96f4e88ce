// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Execution_h
#define medial_Execution_h

#include "Base/Errors.h"
#include "Base/Types.h"

#include <algorithm>
#include <functional>
#include <memory>

namespace medial
{
/// How one long computation reports, is stopped, and uses threads. Results never depend on it.
struct Execution
{
  using Range = std::function<void(Index begin, Index end)>;

  /// Called from the calling thread with what is done, 0 ... 1, never less than before; returns false
  /// to stop.
  std::function<bool(double done)> progress;

  /// Calls body(begin, end) for ranges that together are 0 ... count - 1, in any order, on any
  /// threads. Empty: one call on this thread.
  std::function<void(Index count, const Range& body)> parallelFor;

  /// Reports progress. @throw Aborted  the caller wants to stop
  void report(double done) const
  {
    if (this->progress && !this->raise(done))
    {
      throw Aborted();
    }
  }

  /// For a step that takes long and does not know how long: reports what was reported last again, so
  /// that the caller can stop it. No stretch of work without one may last a second.
  /// @throw Aborted  the caller wants to stop
  void poll() const { this->report(0); }

  /// For turn i of a loop of short turns: polls in some of them.
  void pollAt(Index i) const
  {
    if (i % 4096 == 0)
    {
      this->poll();
    }
  }

  /// Calls body(i) for i in 0 ... count - 1, in any order, on any threads. Polls in between.
  /// @throw Aborted  the caller wants to stop
  template <typename Body>
  void forEach(Index count, const Body& body) const
  {
    constexpr Index chunk =
      4096; // far below a second's work, far above the costs of starting threads
    for (Index first = 0; first < count; first += std::min(chunk, count - first))
    {
      const Range range = [&body, first](Index begin, Index end) {
        for (Index i = first + begin; i < first + end; ++i)
        {
          body(i);
        }
      };
      const Index size = std::min(chunk, count - first);
      if (this->parallelFor)
      {
        this->parallelFor(size, range);
      }
      else
      {
        range(0, size);
      }
      this->poll();
    }
  }

  /// For a step of the work: its progress 0 ... 1 is reported as from ... to of the whole. Example:
  /// `polarBalls(samples, execution.between(0, 0.9))`.
  Execution between(double from, double to) const
  {
    Execution result = *this;
    if (this->progress)
    {
      result.done = std::make_shared<double>(0);
      result.progress = [whole = *this, from, to](
                          double part) { return whole.raise(from + part * (to - from)); };
    }
    return result;
  }

private:
  bool raise(double to) const
  {
    *this->done = std::max(*this->done, to);
    return this->progress(*this->done);
  }

  std::shared_ptr<double> done = std::make_shared<double>(0); ///< what was reported last
};
}

#endif
