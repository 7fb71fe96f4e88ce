// SPDX-License-Identifier: BSD-3-Clause
#include "Morphometry.h"

#include "Arguments.h"
#include "Errors.h"
#include "Json.h"
#include "Messages.h"
#include "Verdict.h"

#include <vtkErrorCode.h>
#include <vtkMedialPrune.h>
#include <vtkMorphometry.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSimplifyShape.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVariant.h>

#include <filesystem>

MeasuredObject morphometryOf(vtkSimplifyShape* simplify, const Arguments& arguments)
{
  vtkNew<vtkMorphometry> measure;
  measure->SetInputData(simplify->GetBalls());
  measure->SetAxisData(simplify->GetMedialPrune()->GetOutput());
  measure->SetSurfaceData(simplify->GetOutput());
  measure->SetName(objectName(arguments.input).c_str());
  measure->SetUnit(arguments.unit.c_str());
  measure->SetMargin(arguments.margin);
  if (arguments.bounds)
  {
    measure->UseBoundsOn();
    measure->SetBounds(arguments.bounds->data());
  }
  measure->Update();
  if (measure->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InputError(arguments.input + ": " + messages::error());
  }
  messages::clear();
  return { measure->GetOutput(), vtkTable::SafeDownCast(measure->GetOutputDataObject(1)) };
}

std::string morphometryJson(vtkTable* row)
{
  if (!row)
  {
    return "null";
  }
  const std::string unit = row->GetValueByName(0, "Unit").ToString();
  Members values, units;
  for (int i = 0; vtkMorphometry::GetQuantityName(i); ++i)
  {
    const char* name = vtkMorphometry::GetQuantityName(i);
    values.emplace_back(name, number(row->GetValueByName(0, name).ToDouble()));
    units.emplace_back(name, quoted(vtkMorphometry::GetQuantityUnit(i, unit.c_str())));
  }
  std::vector<std::string> codes;
  for (const Warning& warning : warningsOf(row))
  {
    codes.push_back(quoted(warning.code));
  }
  return inBraces(
    { { "name", quoted(row->GetValueByName(0, "Name").ToString()) }, { "values", inBraces(values) },
      { "units", inBraces(units) }, { "warnings", "[" + joined(codes, ", ") + "]" } });
}

std::vector<std::string> morphometryColumns()
{
  std::vector<std::string> result{ "Name", "Unit" };
  for (int i = 0; vtkMorphometry::GetQuantityName(i); ++i)
  {
    result.emplace_back(vtkMorphometry::GetQuantityName(i));
  }
  for (const char* more :
    { "Betti:0", "Betti:1", "Betti:2", "BettiSolid:0", "BettiSolid:1", "BettiSolid:2", "Verdict" })
  {
    result.emplace_back(more);
  }
  return result;
}

std::string objectName(const std::string& file)
{
  std::filesystem::path path(file);
  path = path.has_filename() ? path.filename() : path.parent_path().filename(); // "series/"
  path = path.extension() == ".gz" ? path.stem() : path;
  return path.stem().string();
}

std::string quantityHelp()
{
  std::string text = "Quantities of --morphometry, with the unit of length --unit mm:\n";
  for (int i = 0; vtkMorphometry::GetQuantityName(i); ++i)
  {
    std::string line = std::string("  ") + vtkMorphometry::GetQuantityName(i);
    line.resize(16, ' ');
    line += vtkMorphometry::GetQuantityUnit(i, "mm");
    line.resize(23, ' ');
    const std::string formula = vtkMorphometry::GetQuantityFormula(i);
    text += line + " " + vtkMorphometry::GetQuantityDescription(i) + '\n';
    text += formula.empty() ? "" : std::string(26, ' ') + formula + '\n';
  }
  return text;
}
