// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImageOptions_h
#define ImageOptions_h

#include "Options.h"

#include <string>
#include <vector>

struct Arguments;

/// How the solid in an image is found.
std::vector<Option> imageOptions(Arguments& arguments);

/// Checks the options of images against one input.
/// @throw UsageError  it isn't of the kind that they are for
void checkImageOptions(const Arguments& arguments, const std::string& input);

#endif
