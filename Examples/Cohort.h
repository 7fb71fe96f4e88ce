// SPDX-License-Identifier: BSD-3-Clause
#ifndef Cohort_h
#define Cohort_h

#include "Arguments.h"
#include "Errors.h"

#include <functional>
#include <string>

/// Measures many objects: a row for each in one table, see --cohort in README.md.
///
/// Each object is measured in a child process, so that memory holds one object at a time, and a crash ends
/// that object alone. A finished row, or the reason why there is none, becomes a file in a folder beside the
/// table. Processes of a launcher (see Ranks.h) share the objects: the largest
/// are dealt out first, each to who has least, so that all end at about the same time. Who finds the files of all objects when its own are done writes the table, in the order of the
/// command line. So the table is the same for any number of processes, and a run that was stopped goes on
/// where it was.
///
/// The name of an object's file is made from its path, size, time and the options, so that an object that
/// has changed is measured again. Objects that failed are tried again by the next run, too.
/// @param measure  the header and the row of one object: two lines. Runs in the child process.
/// @return Done; SomeFailed where the table is there, but not all of its rows have values. Processes that
///         leave the table to others return Done: mpirun stops all where one fails.
/// @throw UsageError  the table is another file
/// @throw InputError  the table or the folder can't be written
ExitCode measureCohort(
  const Arguments& arguments, const std::function<std::string(const Arguments&)>& measure);

#endif
