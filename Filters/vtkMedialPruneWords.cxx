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
}

const char* vtkMedialPrune::GetPresetName(int preset)
{
  const medial::SchedulePreset* found = presetOf(preset);
  return found ? found->name : nullptr;
}

const char* vtkMedialPrune::GetPresetWords(int preset)
{
  const medial::SchedulePreset* found = presetOf(preset);
  return found ? found->words : nullptr;
}

const char* vtkMedialPrune::GetPresetDescription(int preset)
{
  const medial::SchedulePreset* found = presetOf(preset);
  return found ? found->what : nullptr;
}

const char* vtkMedialPrune::GetMeasureName(int measure)
{
  const medial::MeasureTraits* traits = medial::findMeasure(measure);
  return traits ? traits->name : nullptr;
}

const char* vtkMedialPrune::GetMeasureArray(int measure)
{
  const medial::MeasureTraits* traits = medial::findMeasure(measure);
  return traits ? traits->cellArray : nullptr;
}

const char* vtkMedialPrune::GetMeasureDescription(int measure)
{
  const medial::MeasureTraits* traits = medial::findMeasure(measure);
  return traits ? traits->description : nullptr;
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
