// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolarBalls.h"

#include "Balls/OpenEdges.h"
#include "Conversion/Balls.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"
#include "Pipeline/ReportWarnings.h"

#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkPolarBalls);
medialAbortMacro(vtkPolarBalls);

vtkPolarBalls::vtkPolarBalls()
{
  this->SetNumberOfOutputPorts(2);
}

int vtkPolarBalls::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkPolarBalls::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
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
  vtkUnstructuredGrid* balls = vtkUnstructuredGrid::GetData(outputVector, 0);
  vtkPolyData* samples = vtkPolyData::GetData(outputVector, 1);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      const medial::PolarBallsAndSamples made =
        medial::polarBallsAndSamples(medial::readSamples(input),
          { this->MergeTolerance, medial::sampleResolution(input) }, execution);
      const medial::Warnings open = medial::openSurfaceWarnings(
        medial::readPolygons(input), made.samples.duplicateOf, made.balls.samples);
      medial::write(made, input, balls, samples);
      medial::reportWarnings(this, open, { balls, samples });
      medial::reportWarnings(this, made.samples.warnings, { balls, samples });
    });
}

void vtkPolarBalls::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeTolerance: " << this->MergeTolerance << '\n';
}
