// SPDX-License-Identifier: BSD-3-Clause
#include "vtkImageBoundary.h"

#include "Conversion/Arrays.h"
#include "Conversion/Images.h"
#include "Imaging/ImageBoundary.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"
#include "Pipeline/ReportWarnings.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkImageBoundary);
medialAbortMacro(vtkImageBoundary);

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkImageBoundary::vtkImageBoundary()
{
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkImageBoundary::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkImageBoundary::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkImageBoundary::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  vtkInformation* mask = outputVector->GetInformationObject(1);
  int extent[6];
  input->Get(Pipeline::WHOLE_EXTENT(), extent);
  medial::padExtent(extent, medial::marginOf(this->Options()));
  mask->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  mask->CopyEntry(input, vtkDataObject::ORIGIN());
  mask->CopyEntry(input, vtkDataObject::SPACING());
  mask->CopyEntry(input, vtkDataObject::DIRECTION());
  vtkDataObject::SetPointDataActiveScalarInfo(mask, VTK_UNSIGNED_CHAR, 1);
  return 1;
}

int vtkImageBoundary::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

static medial::Index toIndex(vtkIdType voxels)
{
  return static_cast<medial::Index>(std::min<vtkIdType>(voxels, medial::Largest));
}

medial::BoundaryOptions vtkImageBoundary::Options() const
{
  return { { toIndex(this->FillCavities), this->Pieces == LARGEST,
             toIndex(this->MinimumPieceVoxels) },
    this->Pad, { this->GaussianRadius, this->SmoothingIterations, this->PassBand } };
}

int vtkImageBoundary::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkPolyData* surface = vtkPolyData::GetData(outputVector, 0);
  vtkImageData* mask = vtkImageData::GetData(outputVector, 1);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      medial::SolidChoice choice{ static_cast<medial::SolidChoice::Kind>(this->Solid),
        this->Solid == LABEL ? this->Label : this->IsoValue };
      medial::VoxelMask voxels =
        medial::readMask(input, this->GetInputArrayToProcess(0, inputVector), choice);
      const medial::ImageBoundary made = medial::imageBoundary(
        this, std::move(voxels), this->Options(), execution.between(0.1, 0.9));
      medial::write(made, choice, input, surface, mask);
      medial::reportWarnings(this, medial::warningsInSpace(made, input), { surface, mask });
    });
}

void vtkImageBoundary::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Solid: " << this->Solid << "\n";
  os << indent << "IsoValue: " << this->IsoValue << "\n";
  os << indent << "Label: " << this->Label << "\n";
  os << indent << "FillCavities: " << this->FillCavities << "\n";
  os << indent << "Pieces: " << this->Pieces << "\n";
  os << indent << "MinimumPieceVoxels: " << this->MinimumPieceVoxels << "\n";
  os << indent << "Pad: " << (this->Pad ? "on" : "off") << "\n";
  os << indent << "GaussianRadius: " << this->GaussianRadius << "\n";
  os << indent << "SmoothingIterations: " << this->SmoothingIterations << "\n";
  os << indent << "PassBand: " << this->PassBand << "\n";
}
