// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMedialCenterlines.h"

#include "Conversion/Axis.h"
#include "Conversion/Centerlines.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMedialCenterlines);
medialAbortMacro(vtkMedialCenterlines);

vtkMedialCenterlines::vtkMedialCenterlines()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkMedialCenterlines::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

int vtkMedialCenterlines::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* nodes = vtkPolyData::GetData(outputVector, 1);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      const medial::MedialAxis axis = medial::readMedialAxis(input);
      medial::write(
        medial::centerlines(axis, { this->WidthRatio }, execution), input, output, nodes);
    });
}

void vtkMedialCenterlines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "WidthRatio: " << this->WidthRatio << "\n";
}
