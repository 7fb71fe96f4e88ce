// SPDX-License-Identifier: BSD-3-Clause
#include "Conversion/Morphometry.h"

#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Balls.h"
#include "Conversion/Cells.h"
#include "Conversion/Remedies.h"
#include "Measuring/Morphometry.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <optional>

namespace medial
{
namespace
{
/// Of the solid that was sampled, if the surface knows it.
std::optional<Betti> solidBetti(vtkPolyData* surface)
{
  const Arrays field(surface->GetFieldData(), "field", TakePowerCrust);
  return field.has(names::BettiSolid) ? std::optional(field.betti(names::BettiSolid))
                                      : std::nullopt;
}

/// A column for each number, since writers of VTK don't expect tuples that are not numbers.
void addBettiColumns(vtkTable* output, const std::string& column, const std::optional<Betti>& betti)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    addOne<vtkDoubleArray>(output->GetRowData(), (column + ':' + std::to_string(i)).c_str(),
      betti ? double((*betti)[i]) : Unknown);
  }
}

std::string verdictOf(vtkPolyData* surface)
{
  const Arrays field(surface->GetFieldData(), "field", TakePowerCrust);
  return field.has(names::Verdict) ? field.texts(names::Verdict, 1).front() : "";
}

/// A text for each column: its unit, empty for texts.
void addUnits(vtkTable* output, const std::string& length)
{
  std::vector<std::string> units(static_cast<std::size_t>(output->GetNumberOfColumns()));
  for (std::size_t i = 0; i < units.size(); ++i)
  {
    const std::string name = output->GetColumnName(static_cast<vtkIdType>(i));
    for (const Quantity& quantity : allQuantities())
    {
      units[i] = quantity.name == name ? unitOf(quantity, length) : units[i];
    }
  }
  addTexts(output->GetFieldData(), names::ColumnUnits, units);
}
}

SurfaceTriangles readCrust(vtkPolyData* input)
{
  if (input->GetNumberOfVerts() + input->GetNumberOfLines() + input->GetNumberOfStrips() > 0)
  {
    throw InvalidInput("the surface has other cells than triangles: ", TakePowerCrust);
  }
  SurfaceTriangles result;
  result.points = readFinitePoints(input, TakePowerCrust);
  result.triangles = readCells<3>(input->GetPolys(), count(result.points), TakePowerCrust);
  if (result.triangles.empty())
  {
    throw InvalidInput("the surface has no triangles: ", TakePowerCrust);
  }
  const Arrays points(input->GetPointData(), "point", TakePowerCrust);
  const Arrays cells(input->GetCellData(), "cell", TakePowerCrust);
  points.checkLengths(count(result.points));
  cells.checkLengths(count(result.triangles));
  points.indices(names::SampleId, count(result.points), None, Largest);
  return result;
}

bool isSurfaceOf(vtkUnstructuredGrid* balls, vtkPolyData* surface)
{
  vtkDataArray* ids = surface->GetPointData()->GetArray(names::SampleId);
  vtkDataArray* samples = balls->GetFieldData()->GetArray(names::Samples);
  if (!ids || !samples || samples->GetNumberOfComponents() != 3 ||
    ids->GetNumberOfTuples() != surface->GetNumberOfPoints())
  {
    return false;
  }
  bool hasSample = false;
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    const double id = ids->GetComponent(i, 0);
    if (id >= 0)
    {
      if (!(id < static_cast<double>(samples->GetNumberOfTuples())) ||
        Point(surface->GetPoint(i)) != Point(samples->GetTuple3(static_cast<vtkIdType>(id))))
      {
        return false;
      }
      hasSample = true;
    }
  }
  return hasSample;
}

void checkSurfaceOf(vtkUnstructuredGrid* balls, vtkPolyData* surface)
{
  if (!isSurfaceOf(balls, surface))
  {
    throw InvalidInput("the surface was not made from these balls: ", TakePowerCrust);
  }
}

void write(
  const MorphometryRow& row, vtkUnstructuredGrid* balls, vtkPolyData* surface, vtkTable* output)
{
  vtkDataSetAttributes* columns = output->GetRowData();
  addTexts(columns, names::Name, { row.name });
  addTexts(columns, names::Unit, { row.unit });
  const std::vector<Quantity>& quantities = allQuantities();
  for (std::size_t i = 0; i < quantities.size(); ++i)
  {
    addOne<vtkDoubleArray>(columns, quantities[i].name, row.values[i]);
  }
  const Betti betti =
    Arrays(surface->GetFieldData(), "field", TakePowerCrust).betti(names::BettiCrust);
  addBettiColumns(output, names::Betti, betti);
  addBettiColumns(output, names::BettiSolid, solidBetti(surface));
  addTexts(columns, names::Verdict, { verdictOf(surface) });
  passFieldData(balls, output->GetFieldData());
  output->GetFieldData()->PassData(surface->GetFieldData());
  addUnits(output, row.unit);
}
}
