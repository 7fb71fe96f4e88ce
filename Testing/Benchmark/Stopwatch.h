// SPDX-License-Identifier: BSD-3-Clause
#ifndef Stopwatch_h
#define Stopwatch_h

#include <cstddef>

/// What this process has used until now.
struct Usage
{
  double cpu;  ///< user seconds of all threads
  double wall; ///< seconds
  std::size_t
    memory; ///< the most that was in use since forgetPeak(), kB; 0 where Linux doesn't tell
};

Usage usage();

/// From now on Usage::memory begins at what is in use.
void forgetPeak();

#endif
