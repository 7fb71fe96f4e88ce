// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolarBalls.h"

#include "Balls/OpenEdges.h"
#include "Conversion/ArrayNames.h"
#include "Conversion/Arrays.h"
#include "Conversion/Balls.h"
#include "Conversion/Surface.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"
#include "Pipeline/ReportWarnings.h"

#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <optional>

vtkStandardNewMacro(vtkPolarBalls);
medialAbortMacro(vtkPolarBalls);

vtkPolarBalls::vtkPolarBalls()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

int vtkPolarBalls::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
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

void vtkPolarBalls::SetSolidConnection(vtkAlgorithmOutput* surface)
{
  this->SetInputConnection(1, surface);
}

void vtkPolarBalls::SetSolidData(vtkPolyData* surface)
{
  this->SetInputData(1, surface);
}

int vtkPolarBalls::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0]);
  vtkPolyData* surface = vtkPolyData::GetData(inputVector[1]);
  vtkUnstructuredGrid* balls = vtkUnstructuredGrid::GetData(outputVector, 0);
  vtkPolyData* samples = vtkPolyData::GetData(outputVector, 1);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      std::optional<medial::Solid> solid;
      if (surface)
      {
        solid.emplace(medial::readSolid(surface, execution.between(0, 0.05)));
      }
      const medial::PolarBallsAndSamples made = medial::polarBallsAndSamples(
        medial::readSamples(input), { this->MergeTolerance, medial::sampleResolution(input) },
        execution, solid ? &solid->tree : nullptr, medial::readNormals(input));
      const medial::Warnings open = medial::openSurfaceWarnings(
        medial::readPolygons(input), made.samples.duplicateOf, made.balls.samples);
      medial::write(made, input, balls, samples);
      if (solid)
      {
        medial::addBetti(balls->GetFieldData(), medial::names::BettiSolid, solid->betti);
      }
      medial::reportWarnings(this, open, { balls, samples });
      medial::reportWarnings(this, made.samples.warnings, { balls, samples });
    });
}

void vtkPolarBalls::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeTolerance: " << this->MergeTolerance << '\n';
}
