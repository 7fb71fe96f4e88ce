// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lines_h
#define Lines_h

#include "Errors.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Reads a text line by line, and tells in each error which line of which file is wrong. A line ends with a
/// line feed, a carriage return, or both. Lines without words are skipped.
class Lines
{
public:
  /// What separates words, and what begins a comment that reaches to the end of the line.
  enum Style
  {
    Blanks,         ///< blanks; no comments: .ply, .stl
    BlanksComments, ///< blanks; comments begin with #: .obj
    Columns         ///< blanks, commas or semicolons; comments begin with #: .xyz, .off
  };

  /// @param file   its name, for errors
  /// @param text   its content, which must outlive this object; a byte order mark is skipped
  /// @param style  how lines are divided
  /// @param begin  byte of the text at which to begin, the first of a line
  /// @param number of the line at `begin`
  /// @throw InputError  the text is in UTF-16
  Lines(const std::string& file, std::string_view text, Style style, std::size_t begin = 0,
    long number = 1);

  /// Goes to the next line with words; false at the end of the text.
  /// @throw InputError  in the style Columns, a number has a decimal comma
  bool next();

  /// Does this line go on in the next one, because it ends with a backslash?
  bool isContinued() const;

  /// Appends the next line to this one, without the backslash.
  void append();

  /// In the style Columns: to be called at the end, unless the file names its columns.
  /// @throw InputError  no number of the file had a decimal point, and a line with only commas between more
  ///                    than three whole numbers, as 1,5,2,5,3,5, may mean either
  void refuseAmbiguousCommas() const;

  const std::vector<std::string_view>& words() const { return this->Words; }

  /// The first byte after this line.
  std::size_t end() const { return this->At; }

  long number() const { return this->Number; }

  /// The word at a place as a number; NaN and infinity are numbers, too.
  /// @throw InputError  there is no such word, or it is something else
  double real(std::size_t place, const char* expected) const;

  /// Three numbers from this word on.
  /// @throw InputError  there are none
  std::array<double, 3> point(std::size_t first, const char* expected) const;

  /// An error of this line.
  InputError error(const std::string& message) const;

  /// An error of this line, which shows what is there instead.
  InputError unexpected(const std::string& expected) const;

private:
  std::string_view takeLine();
  void splitLine(std::string_view line);
  void refuseDecimalCommas(std::string_view line) const;
  void noteCommas(std::string_view line);

  std::string File;
  std::string_view Text;
  Style Division;
  std::size_t At; ///< the first byte of the next line
  long Number;    ///< of the current line
  std::string_view Line;
  std::vector<std::string_view> Words;
  bool HasPoint = false;               ///< in a number so far
  std::optional<InputError> Ambiguous; ///< about the first line whose commas may mean either
};

/// Reads a whole word as a decimal number, NaN or infinity. False if it isn't one.
bool parseReal(std::string_view word, double& number);

/// Reads a whole word of at most 18 digits. False if it isn't one.
bool parseWhole(std::string_view word, long long& number);

/// All bytes of a file.
/// @throw InputError  it can't be read
std::string contentOf(const std::string& file);

#endif
