// SPDX-License-Identifier: BSD-3-Clause
#ifndef ChildProcess_h
#define ChildProcess_h

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

/// What a child process may use.
struct Limits
{
  std::size_t bytes; ///< of memory, on top of what the program has
  double seconds;    ///< of computing
};

/// How a child process ended.
enum class Ending
{
  Returned, ///< the function returned
  Threw,    ///< it threw; the text is that of the exception
  Died      ///< it crashed or went beyond a limit
};

struct ChildResult
{
  Ending ending;
  std::string
    text; ///< what the function returned; how it died, as "was ended by the signal Killed"
};

/// Calls a function in a process of its own, so that the program survives when it crashes, runs away or fills
/// the memory. For code of others that is known to do so on damaged data. Nothing that it prints is seen.
/// @param limits  none: those of the program
/// @throw InputError  no process can be made
ChildResult inChildProcess(
  const std::function<std::string()>& make, const std::optional<Limits>& limits = {});

#endif
