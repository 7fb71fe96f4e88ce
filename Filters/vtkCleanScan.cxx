// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCleanScan.h"

#include "Conversion/Balls.h"
#include "Conversion/Scans.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkCleanScan);
medialAbortMacro(vtkCleanScan);

int vtkCleanScan::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkCleanScan::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

int vtkCleanScan::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      const medial::CleanOptions options{ this->OutlierFactor, this->SmoothingRounds,
        this->Thinning, this->EstimateNormals };
      medial::write(
        medial::cleanScan(medial::readSamples(input), options, execution), input, output);
    });
}

void vtkCleanScan::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutlierFactor: " << this->OutlierFactor << "\n";
  os << indent << "SmoothingRounds: " << this->SmoothingRounds << "\n";
  os << indent << "Thinning: " << this->Thinning << "\n";
  os << indent << "EstimateNormals: " << (this->EstimateNormals ? "on" : "off") << "\n";
}
