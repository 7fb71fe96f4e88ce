// SPDX-License-Identifier: BSD-3-Clause
#ifndef Messages_h
#define Messages_h

#include <string>
#include <vector>

/// Collects the errors and warnings of VTK's readers, filters and writers, which VTK would print.
namespace messages
{
/// Begins to collect errors and warnings.
/// @param quiet  do not print warnings
void capture(bool quiet);

/// Forgets the errors and warnings so far. If there was no error, it first prints the warnings, one line
/// each, unless they are to be quiet.
/// @param told  warnings that the user reads elsewhere: they are not printed
void clear(const std::vector<std::string>& told = {});

/// The first error since the last clear(), without VTK's file, line and object; "" if there was none.
std::string error();
}

#endif
