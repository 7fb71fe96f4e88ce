// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileContent_h
#define FileContent_h

#include "Base/Execution.h"

#include <string>

namespace medial
{
/// All bytes of a file.
/// @throw InvalidInput  it can't be read
std::string contentOf(const std::string& file, const Execution& execution);

/// Writes a file, in the place of an older one. Nothing is left of a file that can't be written whole.
/// @throw InvalidInput  it can't be written
void writeContent(const std::string& file, const std::string& content);
}

#endif
