// SPDX-License-Identifier: BSD-3-Clause
#ifndef Html_h
#define Html_h

#include <string>
#include <vector>

// The pieces of an HTML text.

/// A text from elsewhere, as text: markup in it is not markup. Bytes that are no UTF-8, and control characters, become
/// question marks.
std::string escaped(const std::string& text);

/// A number to the fourth digit of `scale`, with all digits before the point; a dash if it is not finite.
std::string rounded(double value, double scale);

/// The same for the reader, and the exact number for programs: <data value="...">.
/// @param scale  the largest number of a column, so that its numbers end at the same digit
std::string measure(double value, double scale);

/// With its own four digits.
std::string rounded(double value);
std::string measure(double value);

/// The same of a whole number, with commas: 1,500.
std::string countOf(double value);

/// <name attributes>content</name>. `tag` has the name and, after a blank, the attributes.
std::string element(const std::string& tag, const std::string& content);

/// Cells of a row; the first one is the row's name.
std::string tableRow(const std::vector<std::string>& cells);

/// @param caption  what it shows; may be empty
/// @param rows     of tableRow()
std::string htmlTable(const std::string& caption, const std::vector<std::string>& columns,
  const std::vector<std::string>& rows);

#endif
