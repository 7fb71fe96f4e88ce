// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMorphometry.h"

#include "Collections/Objects.h"
#include "Conversion/Axis.h"
#include "Conversion/Balls.h"
#include "Conversion/Morphometry.h"
#include "Conversion/Thickness.h"
#include "Measuring/Ingredients.h"
#include "Measuring/Morphometry.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"
#include "Pipeline/ReportWarnings.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <optional>

namespace
{
const medial::Quantity* quantityOf(int number)
{
  const auto& all = medial::allQuantities();
  return number >= 0 && number < medial::count(all) ? &all[number] : nullptr;
}
}

vtkStandardNewMacro(vtkMorphometry);
medialAbortMacro(vtkMorphometry);

vtkMorphometry::vtkMorphometry()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

const char* vtkMorphometry::GetQuantityName(int quantity)
{
  const medial::Quantity* found = quantityOf(quantity);
  return found ? found->name : nullptr;
}

std::string vtkMorphometry::GetQuantityUnit(int quantity, const char* length)
{
  const medial::Quantity* found = quantityOf(quantity);
  return found ? medial::unitOf(*found, length ? length : "") : "";
}

const char* vtkMorphometry::GetQuantityDescription(int quantity)
{
  const medial::Quantity* found = quantityOf(quantity);
  return found ? found->description : nullptr;
}

const char* vtkMorphometry::GetQuantityFormula(int quantity)
{
  const medial::Quantity* found = quantityOf(quantity);
  return found ? found->formula : nullptr;
}

const char* vtkMorphometry::GetErrorMessage()
{
  return medial::errorMessage(this);
}

int vtkMorphometry::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  if (port > 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  return 1;
}

int vtkMorphometry::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

int vtkMorphometry::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkDataObject* axes = vtkDataObject::GetData(inputVector[1]);
  vtkDataObject* surfaces = vtkDataObject::GetData(inputVector[2]);
  vtkTable* output = vtkTable::GetData(outputVector);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      vtkPolyData* axisData = medial::axisOf(input, axes);
      vtkPolyData* surfaceData = medial::surfaceOf(input, surfaces);
      const medial::PolarBalls balls =
        medial::readPolarBalls(input, medial::CellNeighbors::LeftOut);
      execution.poll();
      const medial::MedialAxis axis = medial::readMedialAxis(axisData);
      medial::checkSameBalls(axisData, input);
      execution.poll();
      const medial::SurfaceTriangles surface = medial::readCrust(surfaceData);
      medial::checkSurfaceOf(input, surfaceData);
      std::optional<Eigen::AlignedBox3d> bounds;
      if (this->UseBounds)
      {
        const double* b = this->Bounds;
        bounds.emplace(medial::Point(b[0], b[2], b[4]), medial::Point(b[1], b[3], b[5]));
      }
      const medial::MorphometryIngredients ingredients = medial::ingredients(
        { balls, axis, surface.points, surface.triangles }, bounds, this->Margin, execution);
      medial::write(
        { this->Name, this->Unit, medial::morphometry(ingredients) }, input, surfaceData, output);
      medial::writeMeans(ingredients.volume, vtkTable::GetData(outputVector, 1));
      medial::reportWarnings(this, medial::morphometryWarnings(ingredients), { output });
    });
}

void vtkMorphometry::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->Name << "\n";
  os << indent << "Unit: " << this->Unit << "\n";
  os << indent << "UseBounds: " << (this->UseBounds ? "on" : "off") << "\n";
  const double* b = this->Bounds;
  os << indent << "Bounds: " << b[0] << " " << b[1] << " " << b[2] << " " << b[3] << " " << b[4]
     << " " << b[5] << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
}
