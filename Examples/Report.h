// SPDX-License-Identifier: BSD-3-Clause
#ifndef Report_h
#define Report_h

#include <string>

struct Arguments;
struct Pipeline;

/// report.json; its keys are in README.md.
/// @param total  seconds from the start to the last stage's end
std::string report(const Pipeline& pipeline, double total);

/// The few lines printed at the end.
std::string summary(const Pipeline& pipeline, const Arguments& arguments, double total);

/// A count with commas between thousands.
std::string grouped(double count);

/// Does the axis have the topology of the power shape?
bool isCertified(const Pipeline& pipeline);

#endif
