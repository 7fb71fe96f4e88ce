// SPDX-License-Identifier: BSD-3-Clause
#include "Exchange/TextLines.h"

#include <charconv>

namespace medial
{
namespace
{
constexpr std::string_view Blanks = " \t\f\v";

/// For an error: the beginning of a line, without what can't be printed.
std::string quoted(std::string_view line)
{
  std::string shown(line.substr(0, 40));
  std::replace_if(
    shown.begin(), shown.end(), [](unsigned char c) { return c < ' ' || c > '~'; }, ' ');
  return '\'' + shown + '\'';
}

bool parseReal(std::string_view word, double& number)
{
  word.remove_prefix(word.size() > 1 && word[0] == '+' && word[1] != '-' ? 1 : 0);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error == std::errc::result_out_of_range && word.find_first_of("eE") != word.npos &&
    word.find('-', 1) != word.npos)
  {
    number = 0;
    return end == word.data() + word.size();
  }
  return error == std::errc() && end == word.data() + word.size();
}

template <typename Number>
bool parseWhole(std::string_view word, Number& number)
{
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}
}

TextLines::TextLines(const std::string& name, std::string_view text)
  : Name(name)
  , Text(text)
  , At(text.substr(0, 3) == "\xEF\xBB\xBF" ? 3 : 0)
{
}

bool TextLines::next()
{
  this->Words.clear();
  while (this->Words.empty() && this->At < this->Text.size())
  {
    ++this->Number;
    const std::size_t end = std::min(this->Text.find_first_of("\r\n", this->At), this->Text.size());
    this->Line = this->Text.substr(this->At, end - this->At);
    this->At = std::min(end + (this->Text.substr(end, 2) == "\r\n" ? 2 : 1), this->Text.size());
    this->split(this->Line.substr(0, this->Line.find('#')));
  }
  return !this->Words.empty();
}

double TextLines::share() const
{
  return static_cast<double>(this->At) / static_cast<double>(this->Text.size());
}

Index TextLines::index(std::size_t place, const char* expected) const
{
  const Index result = this->whole(place, expected);
  if (result < 0 || result > MostPoints)
  {
    throw this->unexpected(expected);
  }
  return result;
}

Index TextLines::whole(std::size_t place, const char* expected) const
{
  Index result = None;
  if (!parseWhole(this->Words[place], result))
  {
    throw this->unexpected(expected);
  }
  return result;
}

double TextLines::real(std::size_t place, const char* expected) const
{
  double result = 0;
  if (!parseReal(this->Words[place], result))
  {
    throw this->unexpected(expected);
  }
  return result;
}

bool TextLines::flag(std::size_t place, const char* expected) const
{
  const Index result = this->whole(place, expected);
  if (result != 0 && result != 1)
  {
    throw this->unexpected(expected);
  }
  return result == 1;
}

std::size_t TextLines::size(std::size_t place, const char* expected) const
{
  std::size_t result = 0;
  if (!parseWhole(this->Words[place], result))
  {
    throw this->unexpected(expected);
  }
  return result;
}

InvalidInput TextLines::unexpected(const char* expected) const
{
  return this->error(this->Number, "expected ", expected, ", found ", quoted(this->Line),
    "; correct the line, or write the file again");
}

/// What is more than any line may have isn't looked at, so that a line of nonsense takes no memory; there
/// is one word too many all the same.
void TextLines::split(std::string_view line)
{
  constexpr std::size_t most = 9;
  std::size_t begin = std::min(line.find_first_not_of(Blanks), line.size());
  while (begin < line.size() && this->Words.size() < most)
  {
    const std::size_t end = std::min(line.find_first_of(Blanks, begin), line.size());
    this->Words.push_back(line.substr(begin, end - begin));
    begin = std::min(line.find_first_not_of(Blanks, end), line.size());
  }
}
}
