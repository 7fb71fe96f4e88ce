// SPDX-License-Identifier: BSD-3-Clause
#include "Resolution.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace
{
int exponentOf(std::string_view word)
{
  word.remove_prefix(std::min(word.find_first_of("eE"), word.size() - 1) + 1);
  word.remove_prefix(!word.empty() && word[0] == '+' ? 1 : 0);
  int exponent = 0;
  std::from_chars(word.data(), word.data() + word.size(), exponent);
  return exponent;
}
}

void Resolution::add(std::string_view word)
{
  const std::string_view mantissa = word.substr(0, word.find_first_of("eE"));
  const auto size = static_cast<int>(mantissa.size());
  const int point = static_cast<int>(std::min(mantissa.find('.'), mantissa.size()));
  const std::size_t found = mantissa.find_first_of("123456789");
  if (mantissa.size() == word.size() && point == size)
  {
    return; // a whole number; or NaN
  }
  if (found == mantissa.npos)
  {
    return; // zero
  }
  const int first = static_cast<int>(found);
  const bool isFraction = first > point;
  this->highest = std::max(this->highest, exponentOf(word) + point - first - (isFraction ? 0 : 1));
  this->digits = std::max(this->digits, size - first - (isFraction || point == size ? 0 : 1));
}

double Resolution::value() const
{
  return this->digits == 0 ? 0 : std::pow(10.0, this->highest - this->digits + 1);
}
