// SPDX-License-Identifier: BSD-3-Clause
#ifndef Messages_h
#define Messages_h

#include <string>

/// Keeps what VTK's readers, filters and writers report, in place of VTK's own printing.
namespace messages
{
/// From here on errors and warnings are kept.
void capture(bool quiet);

/// Begins anew. Warnings so far are printed, one line each, unless quiet or followed by an error.
void clear();

/// Why something failed since the last clear(), without VTK's file, line and object; "" if nothing
/// did.
std::string error();
}

#endif
