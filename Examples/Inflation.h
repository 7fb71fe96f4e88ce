// SPDX-License-Identifier: BSD-3-Clause
#ifndef Inflation_h
#define Inflation_h

#include <ios>
#include <string>

/// Do the gzip or zlib data of a file give so many bytes? Inflates them until they do, and keeps nothing.
/// @param begin  where the data begin in the file
bool inflatesTo(const std::string& file, std::streamoff begin, double bytes);

#endif
