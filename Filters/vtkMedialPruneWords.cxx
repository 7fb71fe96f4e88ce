// SPDX-License-Identifier: BSD-3-Clause
// What vtkMedialPrune says of its measures and of the schedules with names: from the core's tables.
#include "vtkMedialPrune.h"

#include "Pruning/Schedule.h"

namespace
{
const medial::SchedulePreset* presetOf(int number)
{
  const std::vector<medial::SchedulePreset>& all = medial::schedulePresets();
  return number >= 0 && number < static_cast<int>(all.size()) ? &all[number] : nullptr;
}

/// A text of a row of a table; null without a row.
template <typename Row>
const char* textOf(const Row* row, const char* Row::*text)
{
  return row ? row->*text : nullptr;
}
}

const char* vtkMedialPrune::GetPresetName(int preset)
{
  return textOf(presetOf(preset), &medial::SchedulePreset::name);
}

const char* vtkMedialPrune::GetPresetWords(int preset)
{
  return textOf(presetOf(preset), &medial::SchedulePreset::words);
}

const char* vtkMedialPrune::GetPresetDescription(int preset)
{
  return textOf(presetOf(preset), &medial::SchedulePreset::what);
}

const char* vtkMedialPrune::GetMeasureName(int measure)
{
  return textOf(medial::findMeasure(measure), &medial::MeasureTraits::name);
}

const char* vtkMedialPrune::GetMeasureArray(int measure)
{
  return textOf(medial::findMeasure(measure), &medial::MeasureTraits::cellArray);
}

const char* vtkMedialPrune::GetMeasureDescription(int measure)
{
  return textOf(medial::findMeasure(measure), &medial::MeasureTraits::description);
}

const char* vtkMedialPrune::GetMeasureUnit(int measure)
{
  const medial::MeasureTraits* traits = medial::findMeasure(measure);
  return traits ? medial::unitName(traits->unit) : nullptr;
}

std::string vtkMedialPrune::GetMeasureWord(int measure)
{
  const medial::MeasureTraits* traits = medial::findMeasure(measure);
  return traits ? medial::wordPattern(*traits) : std::string();
}
