// SPDX-License-Identifier: BSD-3-Clause
#ifndef TextLines_h
#define TextLines_h

#include "Base/Errors.h"
#include "Base/Types.h"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace medial
{
/// No index of a file may be larger.
constexpr Index MostPoints = std::numeric_limits<Index>::max() - 1;

/// A text line by line, each divided into words at blanks. Lines without words, and what follows a #, are skipped. A line
/// ends with a line feed, a carriage return, or both.
class TextLines
{
public:
  /// @param name  of the file, for errors
  /// @param text  its content, which must outlive this object; a byte order mark is skipped
  TextLines(const std::string& name, std::string_view text);

  /// Goes to the next line with words; false at the end.
  bool next();

  const std::vector<std::string_view>& words() const { return this->Words; }

  /// Number of the line, from 1 on.
  std::size_t number() const { return this->Number; }

  /// How much of the text is behind us, 0 ... 1.
  double share() const;

  /// A word of the line as an index, a whole number of either sign, a number, and 0 or 1. A number too small for
  /// a double is 0.
  /// @param expected  what the line should be, for errors
  /// @throw InvalidInput  the word is something else
  Index index(std::size_t place, const char* expected) const;
  Index whole(std::size_t place, const char* expected) const;
  double real(std::size_t place, const char* expected) const;
  bool flag(std::size_t place, const char* expected) const;

  /// The word as a number of things, which may be larger than an index; as above.
  std::size_t size(std::size_t place, const char* expected) const;

  /// An error of a line.
  template <typename... Pieces>
  InvalidInput error(std::size_t number, const Pieces&... message) const
  {
    return InvalidInput(this->Name, ", line ", std::max<std::size_t>(number, 1), ": ", message...);
  }

  /// An error of this line, which shows what is there instead.
  InvalidInput unexpected(const char* expected) const;

private:
  void split(std::string_view line);

  std::string Name;
  std::string_view Text, Line;
  std::size_t At;
  std::size_t Number = 0;
  std::vector<std::string_view> Words;
};
}

#endif
