// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Errors_h
#define medial_Errors_h

#include <stdexcept>
#include <string>

namespace medial
{
/// The input can't be used. The message says what is wrong with it and what to do about it.
class InvalidInput : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Execution::progress asked to stop. Not an error; there is no result.
class Aborted : public std::runtime_error
{
public:
  Aborted()
    : std::runtime_error("aborted")
  {
  }
};
}

#endif
