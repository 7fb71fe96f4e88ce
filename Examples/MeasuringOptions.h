// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeasuringOptions_h
#define MeasuringOptions_h

#include "Options.h"

#include <string>
#include <vector>

struct Arguments;

/// The options of morphometry and of cohorts.
std::vector<Option> measuringOptions(Arguments& arguments);

/// The same options, which note what they were given, if it can change a row of a cohort.
/// @param settings  must outlive them
std::vector<Option> noted(std::vector<Option> options, std::string& settings);

/// Checks what depends on several words of the command line.
/// @throw UsageError  they contradict each other
void checkMeasuring(const Arguments& arguments);

#endif
