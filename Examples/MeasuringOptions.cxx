// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuringOptions.h"

#include "Arguments.h"
#include "Errors.h"
#include "Lines.h"
#include "Morphometry.h"

#include <array>
#include <cmath>
#include <set>

namespace
{
double parseMargin(const std::string& word)
{
  double result = 0;
  if (!parseReal(word, result) || !std::isfinite(result) || result < 0)
  {
    throw UsageError("--margin takes a length from 0 on, not '" + word + "'");
  }
  return result;
}

std::array<double, 6> parseBounds(const std::string& words)
{
  std::array<double, 6> result = {};
  const std::vector<std::string> numbers = split(words, ", ");
  bool isRight = numbers.size() == result.size();
  for (std::size_t i = 0; isRight && i < result.size(); ++i)
  {
    isRight = parseReal(numbers[i], result[i]) && std::isfinite(result[i]) &&
      (i % 2 == 0 || result[i - 1] < result[i]);
  }
  if (!isRight)
  {
    throw UsageError("--bounds takes the least and the largest x, y and z, as in "
                     "--bounds 0,10,0,10,-5,5, not '" +
      words + "'");
  }
  return result;
}

std::string parseUnit(const std::string& word)
{
  for (const char c : word)
  {
    if (static_cast<unsigned char>(c) <= ' ' || c == ',' || c == ';' || c == '"')
    {
      throw UsageError("--unit takes a word without commas, as mm, not '" + word + "'");
    }
  }
  return word;
}

std::string parseTable(const std::string& word)
{
  if (word.empty() || word.back() == '/')
  {
    throw UsageError("--cohort takes the file of the table, as in --cohort table.csv");
  }
  return word;
}
}

std::vector<Option> measuringOptions(Arguments& arguments)
{
  return {
    { "--morphometry", "",
      "also measures the simplified solid, with the names of bone morphometry: morphometry.csv",
      [&](const std::string&) { arguments.morphometry = true; } },
    { "--unit", "WORD", "of the coordinates, as mm: is written into tables and report.html",
      [&](const std::string& value) { arguments.unit = parseUnit(value); } },
    { "--bounds", "X,X,Y,Y,Z,Z",
      "measures what is within these bounds (default: the bounding box of the samples)",
      [&](const std::string& value) { arguments.bounds = parseBounds(value); } },
    { "--margin", "L", "... and farther than L inside them (default: 0)",
      [&](const std::string& value) { arguments.margin = parseMargin(value); } },
    { "--cohort", "TABLE.csv",
      "measures many objects: a row of TABLE.csv for each INPUT. Rows that are done are kept in\n"
      "TABLE.csv.rows and not made again. Under mpirun the processes share the objects.\n"
      "Other results are written only with --output DIR, into DIR/NAME",
      [&](const std::string& value) { arguments.cohort = parseTable(value); } },
  };
}

std::vector<Option> noted(std::vector<Option> options, std::string& settings)
{
  const std::set<std::string> changeNothing = { "--cohort", "--threads", "--quiet", "--help" };
  for (Option& option : options)
  {
    if (changeNothing.count(option.name) == 0)
    {
      option.take = [take = option.take, name = option.name, &settings](const std::string& value) {
        settings += name + '=' + value + '\n';
        take(value);
      };
    }
  }
  return options;
}

void checkMeasuring(const Arguments& arguments)
{
  const bool isCohort = !arguments.cohort.empty();
  if (!isCohort && !arguments.morphometry &&
    ((!arguments.unit.empty() && !arguments.page) || arguments.bounds || arguments.margin > 0))
  {
    throw UsageError(
      "--unit, --bounds and --margin are for --morphometry and --cohort, --unit for --report, too");
  }
  if (isCohort && (arguments.picture || arguments.page) && !arguments.writesResults)
  {
    throw UsageError("--picture and --report need a folder for what they make of a cohort: give "
                     "--output, too");
  }
  std::set<std::string> files, names;
  for (const std::string& input : arguments.inputs)
  {
    if (!files.insert(input).second)
    {
      throw UsageError("'" + input + "' is given twice");
    }
    const bool isNew = names.insert(objectName(input)).second;
    if (isCohort && arguments.writesResults && !isNew)
    {
      throw UsageError("two inputs are called " + objectName(input) +
        ", and would write into one folder; leave out --output, or rename one");
    }
  }
}
