// SPDX-License-Identifier: BSD-3-Clause
#include "Charts.h"

#include "Html.h"
#include "Ramp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iomanip>
#include <numeric>
#include <sstream>

namespace
{
// The drawing area of a histogram within its picture; room is left for numbers and names.
constexpr double Width = 480, Height = 250;
constexpr double Left = 48, Right = 466, Top = 24, Bottom = 204;

std::string fixed(double value, int digits)
{
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << value;
  return out.str();
}

/// A length in the drawing.
std::string at(double value)
{
  return fixed(value, 1);
}

std::string hexadecimal(const double rgb[3])
{
  std::array<char, 8> text;
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", int(std::lround(255 * rgb[0])),
    int(std::lround(255 * rgb[1])), int(std::lround(255 * rgb[2])));
  return text.data();
}

/// The colour of a value between 0 and `top`.
std::string colour(double value, double top)
{
  double rgb[3];
  ramp(0, 1, false)->GetColor(std::min(value / top, 1.0), rgb);
  return hexadecimal(rgb);
}

std::string text(double x, double y, const std::string& anchor, const std::string& content)
{
  return element(
    "text x=\"" + at(x) + "\" y=\"" + at(y) + "\" text-anchor=\"" + anchor + '"', content);
}

std::string line(double x1, double y1, double x2, double y2, const std::string& look)
{
  return element("line x1=\"" + at(x1) + "\" y1=\"" + at(y1) + "\" x2=\"" + at(x2) + "\" y2=\"" +
      at(y2) + "\" class=\"" + look + '"',
    "");
}

std::string rectangle(
  double left, double top, double width, double height, const std::string& colour)
{
  return element("rect x=\"" + at(left) + "\" y=\"" + at(top) + "\" width=\"" + at(width) +
      "\" height=\"" + at(height) + "\" fill=\"" + colour + '"',
    "");
}

struct Tick
{
  double value;
  std::string label;
};

/// Round numbers from 0 up to a bound, at most `most` steps of 1, 2 or 5 times a power of ten.
std::vector<Tick> ticks(double bound, int most)
{
  const double power = std::pow(10, std::floor(std::log10(bound / most)));
  double step = power;
  for (const double factor : { 2.0, 5.0, 10.0 })
  {
    step = step * most < bound ? factor * power : step;
  }
  const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  std::vector<Tick> result;
  for (int i = 0; i * step <= bound * (1 + 1e-9); ++i)
  {
    result.push_back({ i * step, digits > 6 ? rounded(i * step) : fixed(i * step, digits) });
  }
  return result;
}

std::string withUnit(const ChartLabels& labels)
{
  return labels.name + (labels.unit.empty() ? "" : " (" + escaped(labels.unit) + ')');
}

std::string picture(
  double width, double height, const std::string& label, const std::string& content)
{
  return element("svg viewBox=\"0 0 " + at(width) + ' ' + at(height) +
             "\" role=\"img\" aria-label=\"" + label + '"',
           '\n' + content) +
    '\n';
}
}

std::string legend(const std::string& id, double top, const ChartLabels& labels)
{
  constexpr double left = 16, right = 324, height = 14;
  constexpr int stops = 20;
  std::string colours;
  for (int i = 0; i <= stops; ++i)
  {
    colours += element("stop offset=\"" + fixed(double(i) / stops, 2) + "\" stop-color=\"" +
        colour(double(i) / stops, 1) + '"',
      "");
  }
  std::string content = element("defs", element("linearGradient id=\"" + id + '"', colours)) +
    '\n' + rectangle(left, 4, right - left, height, "url(#" + id + ")") + '\n';
  for (const Tick& tick : ticks(top, 5))
  {
    const double x = left + (right - left) * tick.value / top;
    content += line(x, 4 + height, x, 9 + height, "axis") +
      text(x, 25 + height, "middle", tick.label) + '\n';
  }
  content += text((left + right) / 2, 44 + height, "middle", withUnit(labels)) + '\n';
  return picture(340, 62,
    "Legend: " + withUnit(labels) + " from dark blue at 0 over green to yellow at " + rounded(top),
    content);
}

std::string histogram(const std::vector<double>& counts, double largest, double mean, double top,
  const ChartLabels& labels)
{
  const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
  const double highest = 100 * *std::max_element(counts.begin(), counts.end()) / all;
  const auto x = [&](double value) { return Left + (Right - Left) * value / largest; };
  const auto y = [&](double percent) { return Bottom - (Bottom - Top) * percent / highest; };
  std::string content;
  for (const Tick& tick : ticks(highest, 5))
  {
    content += line(Left, y(tick.value), Right, y(tick.value), "grid") +
      text(Left - 6, y(tick.value) + 5, "end", tick.label + '%') + '\n';
  }
  const double width = largest / double(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const double middle = (double(i) + 0.5) * width, upper = y(100 * counts[i] / all);
    content += counts[i] == 0 ? ""
                              : rectangle(x(double(i) * width) + 0.5, upper, x(width) - x(0) - 1,
                                  Bottom - upper, top > 0 ? colour(middle, top) : "#6b7280") +
        '\n';
  }
  content += line(Left, Bottom, Right, Bottom, "axis") + '\n';
  for (const Tick& tick : ticks(largest, 6))
  {
    content += line(x(tick.value), Bottom, x(tick.value), Bottom + 5, "axis") +
      text(x(tick.value), Bottom + 21, "middle", tick.label) + '\n';
  }
  content += line(x(mean), Top - 6, x(mean), Bottom, "mean") +
    text(x(mean), Top - 9,
      mean < largest / 5         ? "start"
        : mean > largest * 4 / 5 ? "end"
                                 : "middle",
      "mean " + rounded(mean)) +
    '\n' + text((Left + Right) / 2, Height - 6, "middle", withUnit(labels)) + '\n';
  return picture(Width, Height,
    "Histogram of the " + labels.name + ": shares of the volume of the " + labels.space +
      ", from 0 to " + rounded(largest) + ", with the mean at " + rounded(mean),
    content);
}
