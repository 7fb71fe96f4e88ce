// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSimplifyShape.h"

#include "Pipeline/Abort.h"
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
#include "vtkTrivialProducer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkSimplifyShape);
medialAbortMacro(vtkSimplifyShape);

vtkSimplifyShape::vtkSimplifyShape()
{
  this->SetNumberOfOutputPorts(4);
  this->Balls->SetInputConnection(this->Samples->GetOutputPort());
  this->Axis->SetInputConnection(this->Balls->GetOutputPort());
  this->Prune->SetInputConnection(this->Axis->GetOutputPort());
  this->Parts->SetInputConnection(this->Prune->GetOutputPort());
  this->Crust->SetInputConnection(this->Balls->GetOutputPort());
  this->Crust->SetAxisConnection(this->Parts->GetOutputPort());
  this->UnprunedParts->SetInputConnection(this->Axis->GetOutputPort());
  this->UnprunedCrust->SetInputConnection(this->Balls->GetOutputPort());
  this->UnprunedCrust->SetAxisConnection(this->UnprunedParts->GetOutputPort());
}

vtkSimplifyShape::~vtkSimplifyShape() = default;

void vtkSimplifyShape::SetSchedule(const char* words)
{
  this->Prune->SetSchedule(words);
}

std::string vtkSimplifyShape::GetScheduleWords()
{
  return this->Prune->GetScheduleWords();
}

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

void vtkSimplifyShape::AddIterationFromText(
  const char* measure, const char* threshold, const char* passes)
{
  this->Prune->AddIterationFromText(measure, threshold, passes);
}

void vtkSimplifyShape::SetAutomatic(bool automatic)
{
  this->Prune->SetAutomatic(automatic);
}

bool vtkSimplifyShape::GetAutomatic()
{
  return this->Prune->GetAutomatic();
}

void vtkSimplifyShape::SetMergeTolerance(double tolerance)
{
  this->Balls->SetMergeTolerance(tolerance);
}

double vtkSimplifyShape::GetMergeTolerance()
{
  return this->Balls->GetMergeTolerance();
}

void vtkSimplifyShape::SetSplitAtNecks(bool split)
{
  this->Prune->SetSplitAtNecks(split);
  this->Parts->SetSplitAtNecks(split);
  this->UnprunedParts->SetSplitAtNecks(split);
}

bool vtkSimplifyShape::GetSplitAtNecks()
{
  return this->Prune->GetSplitAtNecks();
}

void vtkSimplifyShape::SetNeckRatio(double ratio)
{
  this->Prune->SetNeckRatio(ratio);
  this->Parts->SetNeckRatio(ratio);
  this->UnprunedParts->SetNeckRatio(ratio);
}

double vtkSimplifyShape::GetNeckRatio()
{
  return this->Prune->GetNeckRatio();
}

void vtkSimplifyShape::SetMakeUnpruned(bool make)
{
  if (make != this->MakeUnpruned)
  {
    this->MakeUnpruned = make;
    this->Prune->SetInputConnection(
      make ? this->UnprunedParts->GetOutputPort() : this->Axis->GetOutputPort());
    this->Modified();
  }
}

vtkPolarBalls* vtkSimplifyShape::GetPolarBalls()
{
  return this->Balls;
}

vtkMedialAxis* vtkSimplifyShape::GetMedialAxis()
{
  return this->Axis;
}

vtkMedialPrune* vtkSimplifyShape::GetMedialPrune()
{
  return this->Prune;
}

vtkMedialPartDecomposition* vtkSimplifyShape::GetMedialPartDecomposition()
{
  return this->Parts;
}

vtkPowerCrust* vtkSimplifyShape::GetPowerCrust()
{
  return this->Crust;
}

vtkMedialPartDecomposition* vtkSimplifyShape::GetUnprunedPartDecomposition()
{
  return this->UnprunedParts;
}

vtkPowerCrust* vtkSimplifyShape::GetUnprunedPowerCrust()
{
  return this->UnprunedCrust;
}

const char* vtkSimplifyShape::GetErrorMessage()
{
  const char* message = medial::errorMessage(this);
  return *message ? message : medial::errorMessage(this->Prune); // of an iteration that it refused
}

vtkMTimeType vtkSimplifyShape::GetMTime()
{
  return std::max({ this->Superclass::GetMTime(), this->Balls->GetMTime(), this->Axis->GetMTime(),
    this->Prune->GetMTime(), this->Parts->GetMTime(), this->Crust->GetMTime(),
    this->UnprunedParts->GetMTime(), this->UnprunedCrust->GetMTime() });
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

/// Only samples that have changed make balls and axis again. They go to a producer of their own, since
/// an input of the balls would change the balls and with them, while it works, this filter.
void vtkSimplifyShape::SetSamples(vtkPointSet* input)
{
  if (input->GetMTime() == this->SamplesTime)
  {
    return;
  }
  const auto samples = vtkSmartPointer<vtkPointSet>::Take(input->NewInstance());
  samples->ShallowCopy(input); // a copy has no pipeline behind it
  this->Samples->SetOutput(samples);
  this->SamplesTime = input->GetMTime();
}

int vtkSimplifyShape::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Stages = std::vector<medial::Stage>;
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0]);
  const Stages stages = this->MakeUnpruned
    ? Stages{ { this->Balls, 0.3 }, { this->Axis, 0.3 }, { this->UnprunedParts, 0.05 },
        { this->Prune, 0.1 }, { this->Parts, 0.05 }, { this->UnprunedCrust, 0.1, false },
        { this->Crust, 0.1 } }
    : Stages{ { this->Balls, 0.3 }, { this->Axis, 0.4 }, { this->Prune, 0.1 },
        { this->Parts, 0.05 }, { this->Crust, 0.15 } };
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      this->SetSamples(input);
      medial::runStages(this, stages, execution);
      vtkDataObject::GetData(outputVector, 0)->ShallowCopy(this->Crust->GetOutput());
      vtkDataObject::GetData(outputVector, 1)->ShallowCopy(this->Parts->GetOutput());
      vtkDataObject::GetData(outputVector, 2)->ShallowCopy(this->Parts->GetOutputDataObject(1));
      vtkDataObject::GetData(outputVector, 3)->ShallowCopy(this->Prune->GetOutputDataObject(1));
    });
}

void vtkSimplifyShape::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, vtkAlgorithm* stage) {
    os << indent << name << ":\n";
    stage->PrintSelf(os, indent.GetNextIndent());
  };
  os << indent << "MakeUnpruned: " << (this->MakeUnpruned ? "on" : "off") << "\n";
  print("PolarBalls", this->Balls);
  print("MedialAxis", this->Axis);
  print("MedialPrune", this->Prune);
  print("MedialPartDecomposition", this->Parts);
  print("PowerCrust", this->Crust);
  print("UnprunedPartDecomposition", this->UnprunedParts);
  print("UnprunedPowerCrust", this->UnprunedCrust);
}
