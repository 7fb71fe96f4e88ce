// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Errors_h
#define medial_Errors_h

#include <sstream>
#include <stdexcept>
#include <string>

namespace medial
{
/// A text put together from its pieces.
template <typename... Pieces>
std::string text(const Pieces&... pieces)
{
  std::ostringstream stream;
  (stream << ... << pieces);
  return stream.str();
}

/// The input can't be used. The message says what is wrong with it and what to do about it.
class InvalidInput : public std::runtime_error
{
public:
  /// @param pieces  of the message
  template <typename... Pieces>
  explicit InvalidInput(const Pieces&... pieces)
    : std::runtime_error(text(pieces...))
  {
  }
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
