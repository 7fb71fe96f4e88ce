// SPDX-License-Identifier: BSD-3-Clause
#include "Arguments.h"

#include "Errors.h"

#include <vtkMedialPrune.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <sstream>

namespace
{
/// The words between any of `separators`.
std::vector<std::string> split(const std::string& text, const char* separators)
{
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

/// Reads a plain decimal number: digits with at most one point.
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

/// Reads a whole number that an int holds.
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

/// How the thresholds of a measure are given.
struct Word
{
  char letter;
  int measure;
  enum
  {
    Count,   ///< a whole number
    Percent, ///< 0% ... 100% of the solid's volume
    Length,  ///< in the unit of the samples, or with % of the diagonal
    Number
  } threshold;
};

constexpr Word words[] = {
  { 't', vtkMedialPrune::TRIANGLE_COUNT, Word::Count },
  { 'v', vtkMedialPrune::RELATIVE_VOLUME, Word::Percent },
  { 'p', vtkMedialPrune::RELATIVE_POLE_VOLUME, Word::Percent },
  { 'a', vtkMedialPrune::AREA, Word::Number },
  { 'm', vtkMedialPrune::MEAN_RADIUS, Word::Length },
  { 'r', vtkMedialPrune::MAXIMUM_RADIUS, Word::Length },
  { 'o', vtkMedialPrune::OBJECT_ANGLE, Word::Number },
  { 'l', vtkMedialPrune::LAMBDA, Word::Length },
  { 'e', vtkMedialPrune::EROSION_THICKNESS, Word::Length },
  { 'h', vtkMedialPrune::HAUSDORFF_DISTANCE, Word::Length },
};

Iteration parseIteration(const std::string& word)
{
  const bool percent = word.back() == '%';
  const std::string digits = word.substr(1, word.size() - (percent ? 2 : 1));
  for (const Word& known : words)
  {
    double number = 0;
    int whole = 0;
    const bool fits = (known.threshold != Word::Count || parseCount(digits, whole)) &&
      (known.threshold != Word::Percent || percent) &&
      (known.threshold == Word::Percent || known.threshold == Word::Length || !percent);
    if (word[0] == known.letter && fits && parseNumber(digits, number) &&
      (known.threshold != Word::Percent || number <= 100))
    {
      return { known.measure, percent ? number / 100 : number,
        percent && known.threshold == Word::Length, word };
    }
  }
  throw UsageError("'" + word + "' in the schedule is not an iteration; write tN for parts of at " +
    "most N triangles or vP% for parts of at most P per cent of the volume, as in \"t5 t5 v1%\"; " +
    "--help lists the other measures");
}

std::vector<Iteration> parseSchedule(const std::string& schedule)
{
  std::vector<Iteration> iterations;
  for (const std::string& word : split(schedule, " \t\n,"))
  {
    iterations.push_back(parseIteration(word));
  }
  return iterations;
}

std::vector<int> parsePartIds(const std::string& list)
{
  std::vector<int> ids;
  for (const std::string& word : split(list, ", "))
  {
    int id = 0;
    if (!parseCount(word, id))
    {
      throw UsageError("'" + word + "' is not a part; --remove-parts takes values of PartId from " +
        "parts.vtp, as in --remove-parts 12,40");
    }
    ids.push_back(id);
  }
  if (ids.empty())
  {
    throw UsageError("--remove-parts names no part; as in --remove-parts 12,40");
  }
  return ids;
}

bool parseTopology(const std::string& word)
{
  if (word != "collapse" && word != "none")
  {
    throw UsageError("--topology is 'collapse' or 'none', not '" + word + "'");
  }
  return word == "collapse";
}

int parseThreads(const std::string& word)
{
  int threads = 0;
  if (!parseCount(word, threads) || threads < 1)
  {
    throw UsageError("--threads takes a number from 1 on, not '" + word + "'");
  }
  return threads;
}

/// What an option does with its value, for the options that have one.
std::map<std::string, std::function<void(const std::string&)>> valueOptions(Arguments& arguments)
{
  return {
    { "--output", [&](const std::string& value) { arguments.output = value; } },
    { "--schedule", [&](const std::string& value) { arguments.schedule = value; } },
    { "--topology",
      [&](const std::string& value) { arguments.keepTopology = parseTopology(value); } },
    { "--remove-parts",
      [&](const std::string& value) { arguments.partsToRemove = parsePartIds(value); } },
    { "--threads", [&](const std::string& value) { arguments.threads = parseThreads(value); } },
  };
}

std::map<std::string, bool*> switches(Arguments& arguments)
{
  return {
    { "--automatic", &arguments.automatic },
    { "--split-at-necks", &arguments.splitAtNecks },
    { "--picture", &arguments.picture },
    { "--strict", &arguments.strict },
    { "--quiet", &arguments.quiet },
    { "--help", &arguments.help },
    { "-h", &arguments.help },
  };
}

void takeInput(Arguments& arguments, const std::string& word)
{
  if (!arguments.input.empty())
  {
    throw UsageError("one input at a time: both '" + arguments.input + "' and '" + word +
      "' are given; a schedule of several words needs quotes");
  }
  arguments.input = word;
}

/// What only the whole command line can tell.
void complete(Arguments& arguments)
{
  if (arguments.help)
  {
    return;
  }
  if (arguments.input.empty())
  {
    throw UsageError("no input is given; SimplifyShape --help tells how to use it");
  }
  if (arguments.output.empty())
  {
    throw UsageError("--output needs a folder");
  }
  if (arguments.automatic && arguments.schedule != Arguments().schedule)
  {
    throw UsageError("--automatic chooses the schedule; leave out --schedule, or --automatic");
  }
  arguments.iterations = parseSchedule(arguments.schedule);
}
}

Arguments parseArguments(int argc, char* argv[])
{
  Arguments arguments;
  const auto withValue = valueOptions(arguments);
  const auto withoutValue = switches(arguments);
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(0, equals);
    if (word.empty() || word[0] != '-')
    {
      takeInput(arguments, word);
    }
    else if (withoutValue.count(word))
    {
      *withoutValue.at(word) = true;
    }
    else if (!withValue.count(name))
    {
      throw UsageError("unknown option '" + word + "'; SimplifyShape --help lists them");
    }
    else if (equals == std::string::npos && i + 1 == argc)
    {
      throw UsageError(name + " needs a value");
    }
    else
    {
      withValue.at(name)(equals == std::string::npos ? argv[++i] : word.substr(equals + 1));
    }
  }
  complete(arguments);
  return arguments;
}

const char* usage()
{
  return R"(Simplifies the shape of a solid by pruning its medial axis.

  SimplifyShape INPUT [options]

INPUT is a .ply .stl .obj .vtp .vtu .off or .xyz file. Its points are taken as samples of the
solid's closed boundary; cells are ignored.

  --output DIR           where the results go (default: out)
  --schedule "W W ..."   the iterations of pruning, in order (default: "t5 t5 v1%"):
                           tN   removes parts of at most N triangles
                           vP%  removes parts of at most P per cent of the volume
                           pP%  ... of the volume of its poles alone, as in the paper
                           aX   ... of at most the area X
                           mX   ... of at most the mean radius X
                           rX   ... of at most the maximum radius X
                           oX   ... with a mean object angle of at most X degrees
                           lX   ... with a lambda of at most X: where the surface is near
                           eX   ... of at most the erosion thickness X
                           hX   ... that change the solid by a Hausdorff distance of at most X
                         Lengths and areas are in the unit of the samples; a length with %
                         is in per cent of the diagonal of the samples' bounding box.
                         An empty schedule prunes nothing.
  --automatic            chooses the iterations from the data instead
  --split-at-necks       cuts parts at necks, too, before any pruning; best on clean data
  --topology collapse    removes a part only where tunnels, voids and pieces stay (default)
             none        removes it anyway
  --remove-parts ID,ID   then removes these parts too, by PartId in parts.vtp and parts.csv
  --threads N            uses N threads (default: all; the result is the same)
  --picture              also draws the stages; needs an X server (DISPLAY), see Examples/run
  --strict               fails (exit 3) where the axis is not certified to have the topology of
                         the solid
  --quiet                prints errors only
  --help                 prints this

Results, all or none:
  balls.vtu              polar balls and the dual of their power diagram
  axis.vtp  parts.vtp    medial axis; the same with its parts
  pruned.vtp             what pruning left of it
  surface.vtp  .stl      surface of the simplified solid; .stl in triangles
  parts.csv history.csv  the parts; what each iteration removed
  report.json            counts, Betti numbers, certificate, volumes, times
  samples axis parts pruned surface overview .png with --picture

Exit: 0 done, 1 wrong usage, 2 input or output can't be used, 3 see --strict.
)";
}
