// SPDX-License-Identifier: BSD-3-Clause
#ifndef Refuse_h
#define Refuse_h

#include "Errors.h"

#include <sstream>

namespace medial
{
/// Throws InvalidInput with a message put together from its pieces.
template <typename... Pieces>
[[noreturn]] void refuse(const Pieces&... pieces)
{
  std::ostringstream message;
  (message << ... << pieces);
  throw InvalidInput(message.str());
}
}

#endif
