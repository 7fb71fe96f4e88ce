// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSimplifyShape.h"

#include "Pipeline/ReportErrors.h"
#include "Pipeline/RunStage.h"
#include "vtkMedialAxis.h"
#include "vtkMedialPartDecomposition.h"
#include "vtkMedialPrune.h"
#include "vtkPolarBalls.h"
#include "vtkPowerCrust.h"

#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkSimplifyShape);

vtkSimplifyShape::vtkSimplifyShape()
{
  this->SetNumberOfOutputPorts(4);
  this->Axis->SetInputConnection(this->Balls->GetOutputPort());
  this->Prune->SetInputConnection(this->Axis->GetOutputPort());
  this->Parts->SetInputConnection(this->Prune->GetOutputPort());
  this->Crust->SetInputConnection(this->Balls->GetOutputPort());
  this->Crust->SetAxisConnection(this->Parts->GetOutputPort());
}

vtkSimplifyShape::~vtkSimplifyShape() = default;

void vtkSimplifyShape::ClearIterations()
{
  this->Prune->ClearIterations();
}

void vtkSimplifyShape::AddIteration(int measure, double threshold, int passes)
{
  this->Prune->AddIteration(measure, threshold, passes);
}

void vtkSimplifyShape::AddIterationByName(const char* measure, double threshold, int passes)
{
  this->Prune->AddIterationByName(measure, threshold, passes);
}

void vtkSimplifyShape::SetAutomatic(bool automatic)
{
  this->Prune->SetAutomatic(automatic);
}

bool vtkSimplifyShape::GetAutomatic()
{
  return this->Prune->GetAutomatic();
}

void vtkSimplifyShape::SetSplitAtNecks(bool split)
{
  this->Prune->SetSplitAtNecks(split);
  this->Parts->SetSplitAtNecks(split);
}

bool vtkSimplifyShape::GetSplitAtNecks()
{
  return this->Prune->GetSplitAtNecks();
}

void vtkSimplifyShape::SetNeckRatio(double ratio)
{
  this->Prune->SetNeckRatio(ratio);
  this->Parts->SetNeckRatio(ratio);
}

double vtkSimplifyShape::GetNeckRatio()
{
  return this->Prune->GetNeckRatio();
}

vtkMedialAxis* vtkSimplifyShape::GetMedialAxis()
{
  return this->Axis;
}

vtkMedialPrune* vtkSimplifyShape::GetMedialPrune()
{
  return this->Prune;
}

vtkPowerCrust* vtkSimplifyShape::GetPowerCrust()
{
  return this->Crust;
}

vtkMTimeType vtkSimplifyShape::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->Axis->GetMTime(), this->Prune->GetMTime(),
    this->Parts->GetMTime(), this->Crust->GetMTime() });
}

int vtkSimplifyShape::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkSimplifyShape::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port >= 2 ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkSimplifyShape::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

/// Only samples that have changed make balls and axis again.
void vtkSimplifyShape::SetSamples(vtkPointSet* input)
{
  if (input->GetMTime() == this->SamplesTime)
  {
    return;
  }
  const auto samples = vtkSmartPointer<vtkPointSet>::Take(input->NewInstance());
  samples->ShallowCopy(input); // a copy has no pipeline behind it
  this->Balls->SetInputData(samples);
  this->SamplesTime = input->GetMTime();
}

int vtkSimplifyShape::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0]);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      this->SetSamples(input);
      medial::runStage(this->Balls, execution.part(0, 0.3));
      medial::runStage(this->Axis, execution.part(0.3, 0.7));
      medial::runStage(this->Prune, execution.part(0.7, 0.8));
      medial::runStage(this->Parts, execution.part(0.8, 0.85));
      medial::runStage(this->Crust, execution.part(0.85, 1));
      vtkDataObject::GetData(outputVector, 0)->ShallowCopy(this->Crust->GetOutput());
      vtkDataObject::GetData(outputVector, 1)->ShallowCopy(this->Parts->GetOutput());
      vtkDataObject::GetData(outputVector, 2)->ShallowCopy(this->Parts->GetOutputDataObject(1));
      vtkDataObject::GetData(outputVector, 3)->ShallowCopy(this->Prune->GetOutputDataObject(1));
    });
}

void vtkSimplifyShape::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MedialAxis:\n";
  this->Axis->PrintSelf(os, indent.GetNextIndent());
  os << indent << "MedialPrune:\n";
  this->Prune->PrintSelf(os, indent.GetNextIndent());
  os << indent << "PowerCrust:\n";
  this->Crust->PrintSelf(os, indent.GetNextIndent());
}
