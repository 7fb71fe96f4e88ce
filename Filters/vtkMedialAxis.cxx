// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMedialAxis.h"

#include "Axis/AxisWarnings.h"
#include "Conversion/Axis.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"
#include "Pipeline/ReportWarnings.h"
#include "Pipeline/SharedBalls.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

static_assert(vtkMedialAxis::COLLAPSE == static_cast<int>(medial::AxisFallback::Collapse) &&
    vtkMedialAxis::NEAREST == static_cast<int>(medial::AxisFallback::Nearest),
  "the property Fallback is cast to the core's enum");

vtkStandardNewMacro(vtkMedialAxis);
medialAbortMacro(vtkMedialAxis);

int vtkMedialAxis::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

int vtkMedialAxis::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

int vtkMedialAxis::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* balls = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      const medial::AxisOptions options{ static_cast<medial::AxisFallback>(this->Fallback),
        this->Trim };
      const auto polarBalls = medial::ballsOf(balls, this->Shared);
      execution.poll();
      const medial::MedialAxis axis = medial::medialAxis(*polarBalls, options, execution);
      medial::write(axis, balls, output);
      medial::reportWarnings(this, medial::axisWarnings(axis), { output });
    });
}

void vtkMedialAxis::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Fallback: " << (this->Fallback == COLLAPSE ? "COLLAPSE" : "NEAREST") << "\n";
  os << indent << "Trim: " << this->Trim << "\n";
}
