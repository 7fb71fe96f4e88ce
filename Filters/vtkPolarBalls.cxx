// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolarBalls.h"

#include "Balls/PowerShape.h"
#include "Conversion/Balls.h"
#include "Pipeline/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkPolarBalls);

int vtkPolarBalls::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkPolarBalls::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

int vtkPolarBalls::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0]);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      const medial::PolarBalls balls =
        medial::polarBalls(medial::readSamples(input), execution.part(0, 0.9));
      const medial::PowerShape shape = medial::powerShape(balls, execution.part(0.9, 1));
      medial::write(balls, shape.betti, input, output);
    });
}

void vtkPolarBalls::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
