// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlatesAndRods.h"

#include "Conversion/Axis.h"
#include "Conversion/PlatesAndRods.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkPlatesAndRods);
medialAbortMacro(vtkPlatesAndRods);

vtkPlatesAndRods::vtkPlatesAndRods()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
}

int vtkPlatesAndRods::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkPlatesAndRods::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkPlatesAndRods::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

int vtkPlatesAndRods::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* surface = vtkPolyData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  vtkPolyData* outputSurface = vtkPolyData::GetData(outputVector, 2);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      const medial::MedialAxis axis = medial::readMedialAxis(input);
      const medial::PlatesAndRods found =
        medial::platesAndRods(axis, { this->PlateRatio, this->NeckRatio }, execution);
      medial::write(found, input, output, table);
      if (surface)
      {
        medial::write(found, axis, surface, outputSurface);
      }
    });
}

void vtkPlatesAndRods::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PlateRatio: " << this->PlateRatio << "\n";
  os << indent << "NeckRatio: " << this->NeckRatio << "\n";
}
