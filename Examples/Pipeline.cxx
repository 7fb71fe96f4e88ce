// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline.h"

#include "Arguments.h"
#include "Errors.h"
#include "Progress.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointSet.h>

namespace
{
void setSchedule(vtkMedialPrune* prune, double diagonal, const Arguments& arguments)
{
  prune->ClearIterations();
  for (const Iteration& iteration : arguments.iterations)
  {
    prune->AddIteration(
      iteration.measure, iteration.threshold * (iteration.ofDiagonal ? diagonal : 1));
  }
  prune->SetAutomatic(arguments.automatic);
  prune->SetSplitAtNecks(arguments.splitAtNecks);
  prune->SetTopology(arguments.keepTopology ? vtkMedialPrune::COLLAPSE : vtkMedialPrune::NONE);
  for (int part : arguments.partsToRemove)
  {
    prune->AddPartToRemove(part);
  }
}

/// @throw UsageError  a part to be removed isn't there
void checkPartsToRemove(vtkDataObject* parts, const Arguments& arguments)
{
  const double count = fieldValue(parts, "NumberOfParts");
  for (int part : arguments.partsToRemove)
  {
    if (part >= count)
    {
      throw UsageError("--remove-parts: there is no part " + std::to_string(part) +
        "; this axis has parts 0 to " + std::to_string(static_cast<vtkIdType>(count) - 1));
    }
  }
}
}

Pipeline::Pipeline(vtkPointSet* samples, const Arguments& arguments)
{
  this->balls->SetInputData(samples);
  this->axis->SetInputConnection(this->balls->GetOutputPort());
  this->parts->SetInputConnection(this->axis->GetOutputPort());
  this->prune->SetInputConnection(this->parts->GetOutputPort());
  this->parts->SetSplitAtNecks(arguments.splitAtNecks);
  setSchedule(this->prune, samples->GetLength(), arguments);
  this->crustBefore->SetInputConnection(this->balls->GetOutputPort());
  this->crust->SetInputConnection(this->balls->GetOutputPort());
  this->crust->SetAxisConnection(this->prune->GetOutputPort());
}

void Pipeline::run(Progress& progress, const Arguments& arguments)
{
  this->seconds.polarBalls = progress.run("polar balls", this->balls);
  this->seconds.medialAxis = progress.run("medial axis", this->axis);
  this->seconds.parts = progress.run("parts", this->parts);
  checkPartsToRemove(this->parts->GetOutput(), arguments);
  this->seconds.prune = progress.run("prune", this->prune);
  this->seconds.crust = progress.run("crust before", this->crustBefore);
  this->seconds.crust += progress.run("crust", this->crust);
}

double fieldValue(vtkDataObject* output, const char* array, int component)
{
  vtkDataArray* values = output->GetFieldData()->GetArray(array);
  if (!values || values->GetNumberOfTuples() == 0)
  {
    throw InputError(std::string("a stage gave no array ") + array);
  }
  return values->GetComponent(0, component);
}
