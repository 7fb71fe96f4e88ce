// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include "Errors.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace
{
constexpr std::size_t HelpColumn = 25; ///< where the descriptions begin

const Option* find(const std::vector<Option>& options, const std::string& name)
{
  const auto found = std::find_if(options.begin(), options.end(),
    [&](const Option& option) { return option.name == (name == "-h" ? "--help" : name); });
  return found == options.end() ? nullptr : &*found;
}
}

void parse(int argc, char* argv[], const std::string& program, const std::vector<Option>& options,
  const std::function<void(const std::string& word)>& takeOther)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    const bool hasValue = equals != std::string::npos;
    const Option* option = find(options, name);
    if (word.empty() || word[0] != '-')
    {
      takeOther(word);
    }
    else if (!option || (hasValue && option->placeholder.empty()))
    {
      throw UsageError("unknown option '" + word + "'; " + program + " --help lists them");
    }
    else if (option->placeholder.empty())
    {
      option->take("");
    }
    else if (!hasValue && i + 1 == argc)
    {
      throw UsageError(name + " needs a value");
    }
    else
    {
      option->take(hasValue ? word.substr(equals + 1) : argv[++i]);
    }
  }
}

std::string helpOf(const std::vector<Option>& options)
{
  std::string text;
  for (const Option& option : options)
  {
    std::string left = "  " + option.name;
    left += option.placeholder.empty() ? "" : " " + option.placeholder;
    for (const std::string& line : split(option.help, "\n"))
    {
      left.resize(std::max(HelpColumn, left.size() + 1), ' ');
      text += left + line + '\n';
      left.clear();
    }
  }
  return text;
}

std::vector<std::string> split(const std::string& text, const char* separators)
{
  std::vector<std::string> pieces;
  std::size_t begin = text.find_first_not_of(separators);
  while (begin != std::string::npos)
  {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    pieces.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(separators, end);
  }
  return pieces;
}

bool parseNumber(const std::string& text, double& number)
{
  if (text.empty() || text.find_first_not_of("0123456789.") != std::string::npos)
  {
    return false;
  }
  char* end = nullptr;
  number = std::strtod(text.c_str(), &end);
  return *end == '\0' && std::isfinite(number);
}

bool parseCount(const std::string& text, int& number)
{
  double value = 0;
  if (text.find('.') != std::string::npos || !parseNumber(text, value) || value > 2e9)
  {
    return false;
  }
  number = static_cast<int>(value);
  return true;
}
