// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSimplifyShape.h"

#include "Conversion/Balls.h"
#include "Conversion/Warnings.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"
#include "Pipeline/RunStage.h"
#include "Pipeline/SharedBalls.h"
#include "Samples/ClosedSurface.h"
#include "vtkBoundarySamples.h"
#include "vtkImageBoundary.h"
#include "vtkMedialAxis.h"
#include "vtkMedialPartDecomposition.h"
#include "vtkMedialPrune.h"
#include "vtkPolarBalls.h"
#include "vtkPowerCrust.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkTrivialProducer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkSimplifyShape);
medialAbortMacro(vtkSimplifyShape);

vtkSimplifyShape::vtkSimplifyShape()
{
  this->SetNumberOfOutputPorts(4);
  this->Voxels->SetInputConnection(this->Image->GetOutputPort());
  this->Boundary->SetInputConnection(this->Mesh->GetOutputPort());
  this->Balls->SetInputConnection(this->Points->GetOutputPort());
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

void vtkSimplifyShape::SetWrap(bool wrap)
{
  this->Boundary->SetWrap(wrap);
}

bool vtkSimplifyShape::GetWrap()
{
  return this->Boundary->GetWrap();
}

void vtkSimplifyShape::SetWrapWidth(double width)
{
  this->Boundary->SetWrapWidth(width);
}

double vtkSimplifyShape::GetWrapWidth()
{
  return this->Boundary->GetWrapWidth();
}

void vtkSimplifyShape::SetMergeTolerance(double tolerance)
{
  this->Balls->SetMergeTolerance(tolerance);
}

double vtkSimplifyShape::GetMergeTolerance()
{
  return this->Balls->GetMergeTolerance();
}

void vtkSimplifyShape::SetTrim(double trim)
{
  this->GetMedialAxis()->SetTrim(trim);
}

double vtkSimplifyShape::GetTrim()
{
  return this->GetMedialAxis()->GetTrim();
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

vtkImageBoundary* vtkSimplifyShape::GetImageBoundary()
{
  return this->Voxels;
}

vtkBoundarySamples* vtkSimplifyShape::GetBoundarySamples()
{
  return this->Boundary;
}

vtkPolarBalls* vtkSimplifyShape::GetPolarBalls()
{
  return this->Balls;
}

bool vtkSimplifyShape::TakesSamples()
{
  return this->Axis->GetInputAlgorithm() == this->Boundary;
}

vtkUnstructuredGrid* vtkSimplifyShape::GetBalls()
{
  return this->TakesSamples()
    ? vtkUnstructuredGrid::SafeDownCast(this->Boundary->GetOutputDataObject(2))
    : this->Balls->GetOutput();
}

vtkPolyData* vtkSimplifyShape::GetSamples()
{
  return this->TakesSamples() ? this->Boundary->GetOutput(3)
                              : vtkPolyData::SafeDownCast(this->Balls->GetOutputDataObject(1));
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
  return std::max({ this->Superclass::GetMTime(), this->Voxels->GetMTime(),
    this->Boundary->GetMTime(), this->Balls->GetMTime(), this->Axis->GetMTime(),
    this->Prune->GetMTime(), this->Parts->GetMTime(), this->Crust->GetMTime(),
    this->UnprunedParts->GetMTime(), this->UnprunedCrust->GetMTime() });
}

int vtkSimplifyShape::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
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

/// The input, or the surface of the solid in an image. An image that has not changed keeps its surface.
vtkPointSet* vtkSimplifyShape::MeshOf(vtkDataObject* input, const medial::Execution& execution)
{
  auto* image = vtkImageData::SafeDownCast(input);
  if (!image)
  {
    return vtkPointSet::SafeDownCast(input);
  }
  if (image->GetMTime() != this->ImageTime)
  {
    this->Image->SetOutput(medial::copyOf(image));
    this->ImageTime = image->GetMTime();
  }
  medial::runStages(this, { { this->Voxels, 1 } }, execution);
  return this->Voxels->GetOutput();
}

/// Only an input that has changed is sampled again. It goes to a producer of its own, since an input of
/// the stages would change them and with them, while it works, this filter.
void vtkSimplifyShape::SetInput(vtkPointSet* input)
{
  if (input->GetMTime() != this->InputTime)
  {
    this->Mesh->SetOutput(medial::copyOf(input));
    this->Points->SetOutput(medial::copyOf(input));
    this->NotSolid.clear();
    this->InputTime = input->GetMTime();
  }
}

/// The points of the input are the samples.
/// @param notSolid  why its polygons are not sampled, if that is to be told
void vtkSimplifyShape::TakePoints(vtkPointSet* input, const std::string& notSolid)
{
  if (notSolid != this->NotSolid)
  {
    const auto points = medial::copyOf(input);
    medial::addWarnings(points->GetFieldData(),
      { medial::notASolid(notSolid, static_cast<medial::Index>(input->GetNumberOfCells())) });
    this->Points->SetOutput(points);
    this->NotSolid = notSolid;
  }
  this->TakeBalls(this->Balls->GetOutputPort());
}

void vtkSimplifyShape::TakeBalls(vtkAlgorithmOutput* balls)
{
  this->Axis->SetInputConnection(balls);
  this->Crust->SetInputConnection(balls);
  this->UnprunedCrust->SetInputConnection(balls);
}

/// Makes the balls of samples of the polygons of the input, or of its points.
void vtkSimplifyShape::ReadSource(vtkPointSet* input, const medial::Execution& execution)
{
  this->SetInput(input);
  const bool hasPolygons = this->UseTriangles == ON || medial::readPolygons(input).size() > 0;
  std::string notSolid;
  if (this->UseTriangles != OFF && hasPolygons)
  {
    try
    {
      medial::runStages(this, { { this->Boundary, 1 } }, execution);
      this->TakeBalls(this->Boundary->GetOutputPort(2));
      return;
    }
    catch (const medial::InvalidInput& error)
    {
      if (this->UseTriangles == ON)
      {
        throw;
      }
      notSolid = error.what();
      vtkWarningMacro(<< medial::notASolid(notSolid, 0).text);
    }
  }
  this->TakePoints(input, notSolid);
  medial::runStages(this, { { this->Balls, 1 } }, execution);
}

/// Makes the axis and prunes it. What only this needs goes unless it is to be kept.
void vtkSimplifyShape::PruneAxis(const medial::Execution& execution)
{
  using Stages = std::vector<medial::Stage>;
  const Stages stages = this->MakeUnpruned ? Stages{ { this->Axis, 0.55 },
    { this->UnprunedParts, 0.05 }, { this->UnprunedCrust, 0.2, false }, { this->Prune, 0.2 } }
                                           : Stages{ { this->Axis, 0.75 }, { this->Prune, 0.25 } };
  medial::runStages(this, stages, execution);
  if (!this->KeepAxis)
  {
    medial::releaseOutputs({ this->Axis, this->UnprunedParts, this->UnprunedCrust });
    this->Prune->ForgetAxis();
  }
}

int vtkSimplifyShape::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      this->ReadSource(
        this->MeshOf(vtkDataObject::GetData(inputVector[0]), execution.between(0, 0.02)),
        execution.between(0.02, 0.4));
      const medial::SharedBalls shared(
        { &this->Axis->Shared, &this->UnprunedCrust->Shared, &this->Crust->Shared });
      this->PruneAxis(execution.between(0.4, 0.8));
      // A crust of another axis than that with the parts comes first: it needs the memory.
      const bool readsParts = this->Crust->GetInputAlgorithm(1, 0) == this->Parts;
      const medial::Stage parts{ this->Parts, 0.2 }, crust{ this->Crust, 0.8 };
      medial::runStages(this, { readsParts ? parts : crust, readsParts ? crust : parts },
        execution.between(0.8, 1));
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
  os << indent << "UseTriangles: " << this->UseTriangles << "\n";
  os << indent << "MakeUnpruned: " << (this->MakeUnpruned ? "on" : "off") << "\n";
  os << indent << "KeepAxis: " << (this->KeepAxis ? "on" : "off") << "\n";
  print("ImageBoundary", this->Voxels);
  print("BoundarySamples", this->Boundary);
  print("PolarBalls", this->Balls);
  print("MedialAxis", this->Axis);
  print("MedialPrune", this->Prune);
  print("MedialPartDecomposition", this->Parts);
  print("PowerCrust", this->Crust);
  print("UnprunedPartDecomposition", this->UnprunedParts);
  print("UnprunedPowerCrust", this->UnprunedCrust);
}
