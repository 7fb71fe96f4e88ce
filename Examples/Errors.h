// SPDX-License-Identifier: BSD-3-Clause
#ifndef Errors_h
#define Errors_h

#include <stdexcept>

/// The program's exit codes; for those of signals see Signals.h.
enum ExitCode
{
  Done = 0,
  WrongUsage = 1,
  UnusableInput = 2, ///< the input can't be used, or the output can't be written
  NotCertified = 3,  ///< --strict: the axis does not have the topology of the power shape
  SomeFailed = 4     ///< the table of a cohort is written, but some of its objects failed
};

/// The command line is wrong, or names something that does not exist.
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// A file can't be read, used or written.
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

#endif
