// SPDX-License-Identifier: BSD-3-Clause
#ifndef Json_h
#define Json_h

#include <string>
#include <utility>
#include <vector>

// The pieces of a JSON text.

/// The members of an object: keys and values as text.
using Members = std::vector<std::pair<const char*, std::string>>;

/// Exact; "null" if it is not finite.
std::string number(double value);

/// To a thousandth.
std::string seconds(double value);

std::string truth(bool value);
std::string joined(const std::vector<std::string>& items, const char* separator);

/// An array with a line for each row.
std::string rowsOf(const std::vector<std::string>& rows);

/// A string. The texts of the filters have no control characters.
std::string quoted(const std::string& text);

/// The members of an object; `separator` stands between them.
std::string object(const Members& members, const char* separator = ", ");

std::string inBraces(const Members& members);

#endif
