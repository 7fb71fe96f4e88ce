// SPDX-License-Identifier: BSD-3-Clause
#ifndef Messages_h
#define Messages_h

#include <string>

/// Keeps what VTK's readers, filters and writers report, in place of VTK's own printing.
namespace messages
{
/// From here on errors are kept, and warnings printed as one line each unless `quiet`.
void capture(bool quiet);

/// Forgets the errors so far.
void clear();

/// The first error since the last clear(), without VTK's file, line and object; "" if none.
std::string firstError();
}

#endif
