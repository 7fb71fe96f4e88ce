// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMedialPartDecomposition.h"

#include "Conversion.h"
#include "ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkMedialPartDecomposition);

vtkMedialPartDecomposition::vtkMedialPartDecomposition()
{
  this->SetNumberOfOutputPorts(3);
}

int vtkMedialPartDecomposition::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkMedialPartDecomposition::RequestUpdateExtent(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* vtkNotUsed(outputVector))
{
  return medial::requestWholeInputs(this, inputVector);
}

int vtkMedialPartDecomposition::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* axis = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  vtkPolyData* contacts = vtkPolyData::GetData(outputVector, 2);
  return medial::reportErrors(this, request, outputVector, [&](const medial::Execution& execution) {
    medial::write(medial::decompose(medial::readMedialAxis(axis), this->MaximumLevel, execution),
      axis, output, table, contacts);
  });
}

void vtkMedialPartDecomposition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
}
