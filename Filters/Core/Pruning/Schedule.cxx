// SPDX-License-Identifier: BSD-3-Clause
#include "Pruning/Schedule.h"

#include "Base/Errors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace medial
{
namespace
{
/// The words between blanks, line ends and commas.
std::vector<std::string> split(const std::string& text)
{
  constexpr const char* separators = " \t\r\n,";
  std::vector<std::string> words;
  std::size_t begin = text.find_first_not_of(separators);
  while (begin != std::string::npos)
  {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(separators, end);
  }
  return words;
}

/// What is wrong with a word.
struct Fault
{
  std::string text;
};

/// The whole text as a number, which must be there; independent of the locale.
template <typename Number>
bool isNumber(const std::string& text, Number& value)
{
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// A plain decimal number, digits with at most one point, divided by 100 for per cents. Does not depend
/// on the locale, and is rounded only once.
double parseDecimal(const std::string& digits, bool isPercent)
{
  const bool isPlain = !digits.empty() &&
    digits.find_first_not_of("0123456789.") == std::string::npos &&
    std::count(digits.begin(), digits.end(), '.') <= 1 && digits != ".";
  const std::string number = (digits.front() == '.' ? "0" : "") + digits + (isPercent ? "e-2" : "");
  double value = 0;
  if (!isPlain || !isNumber(number, value) || !std::isfinite(value))
  {
    throw Fault{ "'" + digits + "' is not a number" };
  }
  return value;
}

/// The fewest digits that are read as this number again.
std::string shortest(double value)
{
  char buffer[64];
  return { buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr };
}

std::string withoutBlanks(const std::string& text)
{
  constexpr const char* blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? ""
                                    : text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

/// The threshold '0.05' of RelativeVolume.
std::string thresholdOf(const MeasureTraits& traits, const std::string& threshold)
{
  return "the threshold '" + threshold + "' of " + traits.name;
}

/// The number of passes after an x at the end of a word, which is cut off; 0 without.
int takePasses(std::string& word)
{
  const std::size_t place = word.find('x', 1);
  if (place == std::string::npos)
  {
    return 0;
  }
  const std::string digits = word.substr(place + 1);
  int passes = 0;
  if (!isNumber(digits, passes) || passes < 1)
  {
    throw Fault{ "after x comes a number of passes, as in t5x1" };
  }
  word.resize(place);
  return passes;
}

bool isLengthOrArea(const MeasureTraits& traits)
{
  return traits.unit == Unit::Length || traits.unit == Unit::Area;
}

/// By the last character of a threshold.
LengthUnit unitOfLength(char last)
{
  return last == '%' ? LengthUnit::Diagonal
    : last == 's'    ? LengthUnit::Spacing
                     : LengthUnit::Samples;
}

const MeasureTraits& measureOf(char letter)
{
  for (const MeasureTraits& traits : allMeasures())
  {
    if (traits.letter == letter)
    {
      return traits;
    }
  }
  throw Fault{ std::string("no measure has the letter ") + letter };
}

PruneIteration parseWord(std::string word)
{
  PruneIteration result;
  result.passes = takePasses(word);
  const MeasureTraits& traits = measureOf(word.front());
  const bool isPercent = word.back() == '%';
  const bool isSpacings = word.back() == 's' && isLengthOrArea(traits);
  const std::string digits = word.substr(1, word.size() - (isPercent || isSpacings ? 2 : 1));
  if (digits.empty())
  {
    throw Fault{ "there is no threshold" };
  }
  if (traits.unit == Unit::Share && !isPercent)
  {
    throw Fault{ "a share of the volume is written in per cent" };
  }
  if (isPercent && traits.unit != Unit::Share && traits.unit != Unit::Length)
  {
    throw Fault{ std::string("a threshold of the unit ") + unitName(traits.unit) +
      " is not written in per cent" };
  }
  result.measure = traits.measure;
  result.threshold = parseDecimal(digits, isPercent);
  if (isLengthOrArea(traits))
  {
    result.lengthUnit = unitOfLength(word.back());
  }
  if (traits.unit == Unit::Count && digits.find('.') != std::string::npos)
  {
    throw Fault{ "a count is a whole number" };
  }
  const std::string fault = faultOf(result);
  if (!fault.empty())
  {
    throw Fault{ fault };
  }
  return result;
}

std::string presetNames()
{
  std::string names;
  for (const SchedulePreset& preset : schedulePresets())
  {
    names += (names.empty() ? "" : ", ") + std::string(preset.name);
  }
  return names;
}

/// The digits of a number in scientific notation, d.ddde+dd: the fewest that from_chars reads as this
/// number, or as many as said.
std::string scientific(double value, std::optional<int> digits)
{
  char buffer[64];
  char* const end = buffer + sizeof buffer;
  const auto result = digits
    ? std::to_chars(buffer, end, value, std::chars_format::scientific, *digits - 1)
    : std::to_chars(buffer, end, value, std::chars_format::scientific);
  return { buffer, result.ptr };
}

/// A plain decimal number without an exponent, as parseDecimal reads it.
std::string plainDecimal(double value, bool isPercent, std::optional<int> digitCount)
{
  if (!std::isfinite(value) || value == 0)
  {
    return value == 0 ? "0" : std::to_string(value);
  }
  const std::string text = scientific(value, digitCount);
  const std::size_t e = text.find('e');
  std::string digits = text.substr(0, e);
  digits.erase(std::remove(digits.begin(), digits.end(), '.'), digits.end());
  digits.erase(digits.find_last_not_of('0') + 1);
  // The decimal point is behind so many digits.
  const int point = std::atoi(text.c_str() + e + 1) + 1 + (isPercent ? 2 : 0);
  if (point <= 0)
  {
    return "0." + std::string(-point, '0') + digits;
  }
  const auto length = static_cast<int>(digits.size());
  return point >= length ? digits + std::string(point - length, '0')
                         : digits.substr(0, point) + "." + digits.substr(point);
}

std::string word(const PruneIteration& iteration, std::optional<int> digits)
{
  const MeasureTraits& traits = traitsOf(iteration.measure);
  const bool isPercent = traits.unit == Unit::Share || iteration.lengthUnit == LengthUnit::Diagonal;
  // A part with at most 2.5 triangles has at most 2.
  const double threshold =
    traits.unit == Unit::Count ? std::floor(iteration.threshold) : iteration.threshold;
  return traits.letter + plainDecimal(threshold, isPercent, digits) +
    (isPercent                                        ? "%"
        : iteration.lengthUnit == LengthUnit::Spacing ? "s"
                                                      : "") +
    (iteration.passes > 0 ? "x" + std::to_string(iteration.passes) : "");
}
}

bool operator==(const PruneIteration& a, const PruneIteration& b)
{
  return a.measure == b.measure && a.threshold == b.threshold && a.passes == b.passes &&
    a.lengthUnit == b.lengthUnit;
}

const std::vector<SchedulePreset>& schedulePresets()
{
  static const std::vector<SchedulePreset> all{
    { "noise", "t5 t5 h0.5s a2s",
      "slivers, and what is at most half a sample spacing high or two square spacings large" },
    { "details", "t5 t5 h0.5s h1%", "also what is at most 1 % of the diagonal high" },
    { "features", "t5 t5 h0.5s h5%", "also what is at most 5 % of the diagonal high" },
    { "skeleton", "t5 t5 h100% h100%", "all parts but those that hold pieces, tunnels and voids" },
    { "paper", "t5 t5 v1%", "slivers, and what has at most 1 % of the volume, as in the paper" },
  };
  return all;
}

const char* defaultSchedule()
{
  return schedulePresets().front().words;
}

std::vector<PruneIteration> parseSchedule(const std::string& words)
{
  const std::vector<std::string> all = split(words);
  for (const SchedulePreset& preset : schedulePresets())
  {
    if (all.size() == 1 && all.front() == preset.name)
    {
      return parseSchedule(preset.words);
    }
  }
  std::vector<PruneIteration> schedule;
  for (const std::string& word : all)
  {
    try
    {
      schedule.push_back(parseWord(word));
    }
    catch (const Fault& fault)
    {
      std::string patterns;
      for (const MeasureTraits& traits : allMeasures())
      {
        patterns += (patterns.empty() ? "" : ", ") + wordPattern(traits);
      }
      throw InvalidInput("word ", schedule.size() + 1, " of the schedule, '", word,
        "', is not an iteration: ", fault.text, "; words are ", patterns,
        ", as in \"t5 t5 v1%\"; lengths X may end with s (sample spacings) or % (of the diagonal), "
        "an "
        "area with s (square spacings); or give the one word ",
        presetNames());
    }
  }
  return schedule;
}

PruneIteration parseIteration(
  const std::string& measure, const std::string& threshold, const std::string& passes)
{
  const MeasureTraits* traits = findMeasure(measure);
  if (!traits)
  {
    throw InvalidInput(noMeasure("'" + measure + "'"));
  }
  PruneIteration result{ traits->measure, 0, 0 };
  std::string number = withoutBlanks(threshold);
  const bool mayHaveUnit = traits->unit == Unit::Length ||
    (traits->unit == Unit::Area && !number.empty() && number.back() == 's');
  if (mayHaveUnit && !number.empty())
  {
    result.lengthUnit = unitOfLength(number.back());
    number.resize(number.size() - (result.lengthUnit != LengthUnit::Samples ? 1 : 0));
    number += result.lengthUnit == LengthUnit::Diagonal && !number.empty() ? "e-2" : "";
  }
  if (!isNumber(number, result.threshold))
  {
    throw InvalidInput(thresholdOf(*traits, threshold), " is not a number: write ",
      traits->unit == Unit::Share ? "0.05 for 5% of the volume"
        : traits->unit == Unit::Length
        ? "it with a point, as in 2.5, 1.5s (sample spacings) or 2% (of the diagonal)"
        : traits->unit == Unit::Area ? "it with a point, as in 2.5 or 2s (square sample spacings)"
                                     : "it with a point, as in 2.5");
  }
  if (!isNumber(withoutBlanks(passes), result.passes))
  {
    throw InvalidInput("the number of passes '", passes,
      "' is not a whole number: write 1, or 0 for ", "until nothing changes");
  }
  const std::string fault = faultOf(result);
  if (!fault.empty())
  {
    throw InvalidInput(fault);
  }
  return result;
}

std::string faultOf(const PruneIteration& iteration)
{
  const MeasureTraits& traits = traitsOf(iteration.measure);
  const std::string threshold = thresholdOf(traits, shortest(iteration.threshold));
  const double largest = largestThreshold(traits.unit);
  if (!std::isfinite(iteration.threshold))
  {
    return threshold + " is not a finite number";
  }
  if (iteration.threshold < 0)
  {
    return threshold + " is negative";
  }
  if (iteration.threshold > largest)
  {
    return threshold + " is above " + shortest(largest) +
      (traits.unit == Unit::Share ? ", and there is no more than 100% of the volume"
                                  : ", and no part has more");
  }
  return iteration.passes < 0
    ? "the number of passes " + std::to_string(iteration.passes) + " is negative"
    : "";
}

std::string shortWord(const PruneIteration& iteration)
{
  return word(iteration, 3);
}

std::string scheduleWords(const std::vector<PruneIteration>& schedule)
{
  std::string words;
  for (const PruneIteration& iteration : schedule)
  {
    words += (words.empty() ? "" : " ") + word(iteration, std::nullopt);
  }
  return words;
}

std::string wordPattern(const MeasureTraits& traits)
{
  return traits.letter +
    std::string(traits.unit == Unit::Count ? "N"
        : traits.unit == Unit::Share       ? "P%"
                                           : "X");
}
}
