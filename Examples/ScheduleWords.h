// SPDX-License-Identifier: BSD-3-Clause
#ifndef ScheduleWords_h
#define ScheduleWords_h

#include <string>
#include <vector>

/// One word of a schedule: an iteration of decompose - measure - prune.
struct Iteration
{
  int measure; ///< a vtkMedialPrune::MeasureType
  double threshold;
  bool ofDiagonal;  ///< the threshold is a share of the diagonal of the samples' bounding box
  std::string word; ///< as given
};

/// @throw UsageError  says which word is wrong and what is expected instead
std::vector<Iteration> parseSchedule(const std::string& schedule);

/// The lines of --help that describe the words.
extern const char* const scheduleHelp;

#endif
