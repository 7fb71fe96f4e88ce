// SPDX-License-Identifier: BSD-3-Clause
#include "ScheduleWords.h"

#include "Errors.h"
#include "Options.h"

#include <vtkMedialPrune.h>

namespace
{
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
  { 'p', vtkMedialPrune::POLE_VOLUME, Word::Percent },
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

const char* const scheduleHelp = R"(  tN   removes parts of at most N triangles
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
An empty schedule prunes nothing.)";
