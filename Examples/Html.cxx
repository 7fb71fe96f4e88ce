// SPDX-License-Identifier: BSD-3-Clause
#include "Html.h"

#include "Json.h"
#include "Report.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace
{
/// How many bytes the UTF-8 character at a place takes; 0 where there is none, or one that HTML forbids.
std::size_t characterLength(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned first = byte(at);
  if (first < 0x80)
  {
    return (first >= 0x20 && first != 0x7f) || first == '\n' || first == '\t' ? 1 : 0;
  }
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  unsigned code = first & (0xffU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i)
  {
    if ((byte(at + i) & 0xc0U) != 0x80)
    {
      return 0;
    }
    code = code << 6U | (byte(at + i) & 0x3fU);
  }
  constexpr unsigned least[] = { 0, 0, 0xa0, 0x800,
    0x10000 }; // below 0xa0: more control characters
  const bool isAllowed = first >= 0xc2 && first <= 0xf4 && code >= least[length] &&
    code <= 0x10ffff && (code < 0xd800 || code > 0xdfff) && (code & 0xfffeU) != 0xfffe &&
    (code < 0xfdd0 || code > 0xfdef);
  return isAllowed ? length : 0;
}

std::string character(char c)
{
  switch (c)
  {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return { c };
  }
}

std::string data(double value, const std::string& shown)
{
  return std::isfinite(value) ? element("data value=\"" + number(value) + '"', shown) : shown;
}
}

std::string escaped(const std::string& text)
{
  std::string result;
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t length = characterLength(text, at);
    result += length > 1 ? text.substr(at, length) : length == 1 ? character(text[at]) : "?";
    at += std::max<std::size_t>(length, 1);
  }
  return result;
}

std::string rounded(double value, double scale)
{
  if (!std::isfinite(value))
  {
    return "&ndash;";
  }
  const double size = std::abs(scale);
  std::ostringstream out;
  if (!(size >= 1e-4 && size < 1e9) && value != 0)
  {
    out << std::setprecision(4) << value;
    return out.str();
  }
  const int digits = size > 0 ? 3 - static_cast<int>(std::floor(std::log10(size))) : 0;
  if (digits < 0 && value > 0)
  {
    return grouped(std::round(value));
  }
  out << std::fixed << std::setprecision(std::max(digits, 0)) << value;
  return out.str();
}

std::string measure(double value, double scale)
{
  return data(value, rounded(value, scale));
}

std::string rounded(double value)
{
  return rounded(value, value);
}

std::string measure(double value)
{
  return measure(value, value);
}

std::string countOf(double value)
{
  return data(value, grouped(value));
}

std::string element(const std::string& tag, const std::string& content)
{
  return '<' + tag + '>' + content + "</" + tag.substr(0, tag.find(' ')) + '>';
}

std::string tableRow(const std::vector<std::string>& cells)
{
  std::string result = element("th scope=\"row\"", cells.front());
  for (std::size_t i = 1; i < cells.size(); ++i)
  {
    result += element("td", cells[i]);
  }
  return element("tr", result) + '\n';
}

std::string htmlTable(const std::string& caption, const std::vector<std::string>& columns,
  const std::vector<std::string>& rows)
{
  std::string head;
  for (const std::string& column : columns)
  {
    head += element("th scope=\"col\"", column);
  }
  const std::string text = (caption.empty() ? "" : element("caption", caption) + '\n') +
    (columns.empty() ? "" : element("thead", element("tr", head)) + '\n') +
    element("tbody", '\n' + joined(rows, "")) + '\n';
  return element("div class=\"table\"", element("table", '\n' + text)) + '\n';
}
