// SPDX-License-Identifier: BSD-3-Clause
#include "Json.h"

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

std::string number(double value)
{
  if (!std::isfinite(value))
  {
    return "null";
  }
  std::ostringstream out;
  out << std::setprecision(std::numeric_limits<double>::max_digits10) << value;
  return out.str();
}

std::string seconds(double value)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(3) << value;
  return out.str();
}

std::string truth(bool value)
{
  return value ? "true" : "false";
}

std::string joined(const std::vector<std::string>& items, const char* separator)
{
  std::string text;
  for (const std::string& item : items)
  {
    text += (text.empty() ? "" : separator) + item;
  }
  return text;
}

std::string rowsOf(const std::vector<std::string>& rows)
{
  return rows.empty() ? "[]" : "[\n    " + joined(rows, ",\n    ") + "\n  ]";
}

std::string quoted(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    result += c == '"' || c == '\\' ? std::string{ '\\', c } : std::string{ c };
  }
  return '"' + result + '"';
}

std::string object(const Members& members, const char* separator)
{
  std::vector<std::string> items;
  for (const auto& [key, value] : members)
  {
    items.push_back('"' + std::string(key) + "\": " + value);
  }
  return joined(items, separator);
}

std::string inBraces(const Members& members)
{
  return "{ " + object(members) + " }";
}
