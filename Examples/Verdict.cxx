// SPDX-License-Identifier: BSD-3-Clause
#include "Verdict.h"

#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkStringArray.h>

namespace
{
/// Empty where there is no such array.
std::vector<std::string> texts(vtkDataObject* output, const char* name)
{
  auto* array = vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray(name));
  std::vector<std::string> result;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    result.push_back(array->GetValue(i));
  }
  return result;
}
}

std::vector<Warning> warningsOf(vtkDataObject* output)
{
  std::vector<Warning> result;
  const std::vector<std::string> codes = texts(output, "WarningCode");
  const std::vector<std::string> sentences = texts(output, "WarningText");
  for (std::size_t i = 0; i < codes.size(); ++i)
  {
    const auto value = [&](const char* array, int component = 0) {
      return output->GetFieldData()->GetArray(array)->GetComponent(
        static_cast<vtkIdType>(i), component);
    };
    result.push_back(
      { codes[i], sentences[i], value("WarningCount"), {}, value("WarningDoubtsSolid") != 0 });
    if (value("WarningHasPlace") != 0)
    {
      result.back().place = { value("WarningPlace", 0), value("WarningPlace", 1),
        value("WarningPlace", 2) };
    }
  }
  return result;
}

Verdict verdictOf(vtkDataObject* surface)
{
  const std::vector<std::string> name = texts(surface, "Verdict");
  return { name.empty() ? "not certified" : name.front(), texts(surface, "VerdictReasons") };
}

std::vector<std::string> eventsOf(vtkDataObject* output)
{
  std::vector<std::string> result;
  for (const Warning& warning : warningsOf(output))
  {
    result.push_back(warning.text);
  }
  const Verdict verdict = verdictOf(output);
  std::string sentence = "The surface is " + verdict.name;
  for (std::size_t i = 0; i < verdict.reasons.size(); ++i)
  {
    sentence += (i == 0 ? ": " : "; ") + verdict.reasons[i];
  }
  result.push_back(sentence);
  return result;
}
