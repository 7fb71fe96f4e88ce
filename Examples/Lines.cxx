// SPDX-License-Identifier: BSD-3-Clause
#include "Lines.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace
{
constexpr std::string_view White = " \t\f\v";
constexpr std::string_view WhiteOrSemicolon = " \t\f\v;";
constexpr std::string_view WhiteOrMark = " \t\f\v,;";

bool isDigit(char c)
{
  return c >= '0' && c <= '9';
}

/// Calls `take` with each piece between separators.
template <typename Take>
void forEachPiece(std::string_view text, std::string_view separators, const Take& take)
{
  std::size_t begin = text.find_first_not_of(separators);
  while (begin != text.npos)
  {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    take(text.substr(begin, end - begin));
    begin = text.find_first_not_of(separators, end);
  }
}

bool isWhole(std::string_view word)
{
  word.remove_prefix(!word.empty() && (word[0] == '-' || word[0] == '+') ? 1 : 0);
  return !word.empty() && std::all_of(word.begin(), word.end(), isDigit);
}

/// Is it a number with one comma, as 0,5 or -12,25e3?
bool hasDecimalComma(std::string_view word)
{
  const std::size_t comma = word.find(',');
  if (comma == word.npos || !isWhole(word.substr(0, comma)))
  {
    return false;
  }
  const std::string_view fraction = word.substr(comma + 1);
  const std::size_t exponent = std::min(fraction.find_first_of("eE"), fraction.size());
  const std::string_view digits = fraction.substr(0, exponent);
  return isWhole(digits) && isDigit(digits[0]) &&
    (exponent == fraction.size() || isWhole(fraction.substr(exponent + 1)));
}

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text)
{
  const std::size_t begin = std::min(text.find_first_not_of(White), text.size());
  return text.substr(begin, text.find_last_not_of(White) + 1 - begin);
}

std::string quoted(std::string_view text)
{
  std::string shown(text.substr(0, 40));
  std::replace_if(
    shown.begin(), shown.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, ' ');
  shown.erase(shown.find_last_not_of(' ') + 1);
  return '\'' + shown + '\'';
}
}

Lines::Lines(
  const std::string& file, std::string_view text, Style style, std::size_t begin, long number)
  : File(file)
  , Text(text)
  , Division(style)
  , At(begin)
  , Number(number - 1)
{
  const std::string_view start = text.substr(0, 2);
  if (start == "\xFF\xFE" || start == "\xFE\xFF")
  {
    throw InputError(file + ": is text in UTF-16; save it as ASCII or UTF-8");
  }
  if (begin == 0 && text.substr(0, 3) == "\xEF\xBB\xBF")
  {
    this->At = 3;
  }
}

bool Lines::next()
{
  while (this->At < this->Text.size())
  {
    this->Line = this->takeLine();
    this->Words.clear();
    this->splitLine(this->Line);
    if (!this->Words.empty())
    {
      return true;
    }
  }
  return false;
}

bool Lines::isContinued() const
{
  return !this->Words.empty() && this->Words.back().back() == '\\';
}

void Lines::append()
{
  std::string_view& last = this->Words.back();
  last.remove_suffix(1);
  if (last.empty())
  {
    this->Words.pop_back();
  }
  if (this->At < this->Text.size())
  {
    this->splitLine(this->takeLine());
  }
}

std::string_view Lines::takeLine()
{
  ++this->Number;
  const std::size_t begin = this->At;
  const std::size_t end = std::min(this->Text.find_first_of("\r\n", begin), this->Text.size());
  this->At = std::min(end + (this->Text.substr(end, 2) == "\r\n" ? 2 : 1), this->Text.size());
  const std::string_view line = this->Text.substr(begin, end - begin);
  return this->Division == Blanks ? line : line.substr(0, line.find('#'));
}

void Lines::splitLine(std::string_view line)
{
  if (this->Division == Columns)
  {
    this->refuseDecimalCommas(line);
  }
  forEachPiece(line, this->Division == Columns ? WhiteOrMark : White,
    [this](std::string_view word) { this->Words.push_back(word); });
  if (this->Division == Columns)
  {
    this->noteCommas(line);
  }
}

void Lines::noteCommas(std::string_view line)
{
  double number = 0;
  const auto isReal = [&number](std::string_view word) { return parseReal(word, number); };
  this->HasPoint = this->HasPoint ||
    (line.find('.') != line.npos &&
      std::any_of(this->Words.begin(), this->Words.end(),
        [&](std::string_view word) { return word.find('.') != word.npos && isReal(word); }));
  const bool isMany =
    this->Words.size() > 3 && std::all_of(this->Words.begin(), this->Words.begin() + 4, isReal);
  if (isMany && !this->Ambiguous && line.find(',') != line.npos &&
    trimmed(line).find_first_of(WhiteOrSemicolon) == line.npos)
  {
    this->Ambiguous = this->error(quoted(line) +
      " may be columns with commas between them or numbers with decimal commas; write decimal "
      "points, or name the columns in a first line, as in x,y,z,a,b");
  }
}

void Lines::refuseAmbiguousCommas() const
{
  if (this->Ambiguous && !this->HasPoint)
  {
    throw *this->Ambiguous;
  }
}

/// A comma separates columns, as in 1,2,3 and in "1.5, 2.5, 3.5", unless the numbers are separated
/// without it already, as in "1,5 2,5 3,5", in "1,5, 2,5, 3,5" and in 1,5;2,5;3,5. In 0,05,1,25,2,75 the
/// zero at the beginning of 05 tells.
void Lines::refuseDecimalCommas(std::string_view line) const
{
  if (line.find(',') == line.npos)
  {
    return;
  }
  int place = 0;
  std::string_view found;
  forEachPiece(line, WhiteOrSemicolon, [&](std::string_view piece) {
    piece.remove_suffix(piece.size() > 1 && piece.back() == ',' ? 1 : 0);
    found = ++place <= 3 && hasDecimalComma(piece) ? piece : found;
  });
  std::vector<std::string_view> pieces;
  forEachPiece(line, WhiteOrMark, [&](std::string_view piece) { pieces.push_back(piece); });
  const std::size_t whole =
    std::find_if_not(pieces.begin(), pieces.end(), isWhole) - pieces.begin();
  for (std::size_t i = 1; whole >= 3 && i < whole; ++i)
  {
    found = pieces[i].size() > 1 && pieces[i][0] == '0' ? line : found;
  }
  if (!found.empty())
  {
    throw this->error(quoted(found) +
      " has a decimal comma; write decimal points, as in 0.5, and blanks between the columns");
  }
}

double Lines::real(std::size_t place, const char* expected) const
{
  double value = 0;
  if (place >= this->Words.size() || !parseReal(this->Words[place], value))
  {
    if (place < this->Words.size() && hasDecimalComma(this->Words[place]))
    {
      throw this->error(quoted(this->Words[place]) + " has a decimal comma; write a point");
    }
    throw this->unexpected(expected);
  }
  return value;
}

std::array<double, 3> Lines::point(std::size_t first, const char* expected) const
{
  return { this->real(first, expected), this->real(first + 1, expected),
    this->real(first + 2, expected) };
}

InputError Lines::error(const std::string& message) const
{
  return InputError(
    this->File + ", line " + std::to_string(std::max(this->Number, 1L)) + ": " + message);
}

InputError Lines::unexpected(const std::string& expected) const
{
  return this->error("expected " + expected + ", found " + quoted(this->Line));
}

bool parseReal(std::string_view word, double& number)
{
  word.remove_prefix(word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error == std::errc::result_out_of_range)
  {
    number = std::strtod(std::string(word).c_str(), nullptr); // tells zero from infinity
  }
  return error != std::errc::invalid_argument && end == word.data() + word.size();
}

bool parseWhole(std::string_view word, long long& number)
{
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size() && isDigit(word[0]) &&
    word.size() <= 18;
}

std::string contentOf(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::string content;
  std::vector<char> piece(std::size_t(1) << 20);
  while (
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0)
  {
    content.append(piece.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.is_open() || stream.bad())
  {
    throw InputError(file + ": can't be read: " + std::strerror(errno));
  }
  return content;
}
