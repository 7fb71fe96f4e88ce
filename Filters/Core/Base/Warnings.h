// SPDX-License-Identifier: BSD-3-Clause
#ifndef medial_Warnings_h
#define medial_Warnings_h

#include "Base/Types.h"

#include <optional>
#include <string>
#include <vector>

namespace medial
{
/// A doubt about the input or a result, in plain words: what was seen, how often, where, and what the
/// user can do about it.
struct Warning
{
  std::string code; ///< names the kind of doubt for programs, such as "noise"; never changes
  std::string text; ///< one or two sentences: what was seen, and the remedy
  Index count = 0;  ///< how many samples, balls, ... it is about
  std::optional<Point> place; ///< one of them, in the samples' unit; none where it is about all
  bool doubtsSolid = false;   ///< the samples don't determine the solid: nothing made from them is
                              ///< certified
};

using Warnings = std::vector<Warning>;
}

#endif
