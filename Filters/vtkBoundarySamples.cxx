// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBoundarySamples.h"

#include "Balls/ProvenSamples.h"
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

#include <algorithm>
#include <optional>

vtkStandardNewMacro(vtkBoundarySamples);
medialAbortMacro(vtkBoundarySamples);

vtkBoundarySamples::vtkBoundarySamples()
{
  this->SetNumberOfOutputPorts(4);
}

int vtkBoundarySamples::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkBoundarySamples::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 2 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

int vtkBoundarySamples::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

int vtkBoundarySamples::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPointSet* input = vtkPointSet::GetData(inputVector[0]);
  vtkPolyData* samples = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* closed = vtkPolyData::GetData(outputVector, 1);
  vtkUnstructuredGrid* balls = vtkUnstructuredGrid::GetData(outputVector, 2);
  vtkPolyData* known = vtkPolyData::GetData(outputVector, 3);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      const medial::ClosedSurface surface = medial::readSurface(input,
        this->Wrap ? std::optional<medial::WrapOptions>({ this->WrapWidth, this->WrapOffset })
                   : std::nullopt,
        execution.between(0, 0.2));
      const medial::SurfaceTree tree(surface.points, surface.triangles);
      const auto most = std::min<vtkIdType>(this->MaximumSamples, medial::Largest);
      const medial::SamplingOptions options{ this->Fineness, this->Spacing, this->Adaptive,
        static_cast<medial::Index>(most), this->SharpAngle };
      const medial::ProvenSamples made = medial::provenSamples(
        surface, tree, options, this->MaximumRounds, execution.between(0.2, 1));
      medial::write(made, surface, input, samples, closed);
      medial::reportWarnings(this, surface.warnings, { samples, closed });
      medial::reportWarnings(this, made.warnings, { samples, closed });
      medial::write(made.balls, samples, balls, known);
      medial::reportWarnings(this, made.balls.samples.warnings, { balls, known });
    });
}

void vtkBoundarySamples::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Fineness: " << this->Fineness << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "Adaptive: " << (this->Adaptive ? "on" : "off") << "\n";
  os << indent << "MaximumSamples: " << this->MaximumSamples << "\n";
  os << indent << "SharpAngle: " << this->SharpAngle << "\n";
  os << indent << "Wrap: " << (this->Wrap ? "on" : "off") << "\n";
  os << indent << "WrapWidth: " << this->WrapWidth << "\n";
  os << indent << "WrapOffset: " << this->WrapOffset << "\n";
  os << indent << "MaximumRounds: " << this->MaximumRounds << "\n";
}
