// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Warnings.h"

#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>

namespace medial
{
namespace
{
/// Their place is 0 0 0 where they have none: VTK's readers can't read back what its writers make of a
/// NaN, and lose the whole array, or the file.
void writeWarnings(vtkFieldData* field, const Warnings& warnings)
{
  std::vector<std::string> codes, texts;
  for (const Warning& warning : warnings)
  {
    codes.push_back(warning.code);
    texts.push_back(warning.text);
  }
  addTexts(field, names::WarningCode, codes);
  addTexts(field, names::WarningText, texts);
  add<vtkIdTypeArray>(field, names::WarningCount, warnings, &Warning::count);
  const auto place = [](const Warning& w) { return w.place.value_or(Point(0, 0, 0)); };
  field->AddArray(tuples<vtkDoubleArray>(names::WarningPlace, 3, warnings, place));
  add<vtkUnsignedCharArray>(field, names::WarningHasPlace, warnings,
    [](const Warning& warning) { return warning.place.has_value(); });
  add<vtkUnsignedCharArray>(field, names::WarningDoubtsSolid, warnings, &Warning::doubtsSolid);
}

bool same(const Warning& a, const Warning& b)
{
  return a.code == b.code && a.text == b.text && a.count == b.count && a.place == b.place &&
    a.doubtsSolid == b.doubtsSolid;
}
}

Warnings readWarnings(vtkFieldData* field)
{
  const Arrays arrays(field, "field",
    "take the output of the filter before as it is, or remove all arrays 'Warning...'");
  const auto isThere = [&arrays](const char* name) { return arrays.has(name); };
  const auto all = { names::WarningCode, names::WarningText, names::WarningCount,
    names::WarningPlace, names::WarningHasPlace, names::WarningDoubtsSolid };
  if (std::none_of(all.begin(), all.end(), isThere))
  {
    return {};
  }
  const std::vector<Index> counts = arrays.indices(names::WarningCount, AnyCount, 0, Largest);
  const Index number = count(counts);
  const std::vector<std::string> codes = arrays.texts(names::WarningCode, number);
  const std::vector<std::string> texts = arrays.texts(names::WarningText, number);
  const std::vector<double> places =
    arrays.reals(names::WarningPlace, number, std::numeric_limits<double>::lowest(), 3);
  const std::vector<char> hasPlace = arrays.flags(names::WarningHasPlace, number);
  const std::vector<char> doubtsSolid = arrays.flags(names::WarningDoubtsSolid, number);
  Warnings result;
  for (Index i = 0; i < number; ++i)
  {
    result.push_back({ codes[i], texts[i], counts[i], {}, doubtsSolid[i] != 0 });
    if (hasPlace[i])
    {
      result.back().place = Point(places.data() + 3 * static_cast<std::size_t>(i));
    }
  }
  return result;
}

void addWarnings(vtkFieldData* field, const Warnings& warnings)
{
  Warnings all = readWarnings(field);
  for (const Warning& warning : warnings)
  {
    const auto isIt = [&warning](const Warning& other) { return same(warning, other); };
    if (std::none_of(all.begin(), all.end(), isIt))
    {
      all.push_back(warning);
    }
  }
  if (!all.empty())
  {
    writeWarnings(field, all);
  }
}
}
