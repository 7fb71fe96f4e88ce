// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLocalThickness.h"

#include "Axis/MedialAxis.h"
#include "Conversion/Axis.h"
#include "Conversion/Balls.h"
#include "Conversion/Thickness.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <optional>
#include <vector>

vtkStandardNewMacro(vtkLocalThickness);
medialAbortMacro(vtkLocalThickness);

vtkLocalThickness::vtkLocalThickness()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(3);
}

int vtkLocalThickness::FillInputPortInformation(int port, vtkInformation* info)
{
  constexpr const char* types[] = { "vtkUnstructuredGrid", "vtkDataSet", "vtkPolyData" };
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), types[port]);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0 ? 1 : 0);
  return 1;
}

int vtkLocalThickness::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkDataSet" : "vtkTable");
  return 1;
}

int vtkLocalThickness::RequestDataObject(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* places = vtkDataSet::GetData(inputVector[1]);
  vtkDataSet* output = vtkDataSet::GetData(outputVector, 0);
  const char* type = places ? places->GetClassName() : "vtkPolyData";
  if (!output || !output->IsA(type))
  {
    const auto made = vtkSmartPointer<vtkDataSet>::Take(
      places ? places->NewInstance() : static_cast<vtkDataSet*>(vtkPolyData::New()));
    outputVector->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

int vtkLocalThickness::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

int vtkLocalThickness::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputVector[0]);
  vtkDataSet* places = vtkDataSet::GetData(inputVector[1]);
  vtkPolyData* axis = vtkPolyData::GetData(inputVector[2]);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      const medial::PolarBalls balls =
        medial::readPolarBalls(input, medial::CellNeighbors::LeftOut);
      std::optional<std::vector<medial::Point>> at;
      std::optional<medial::MedialAxis> medialAxis;
      if (places)
      {
        at = medial::readPlaces(places);
      }
      if (axis)
      {
        medialAxis = medial::readMedialAxis(axis);
        medial::checkSameBalls(axis, input);
      }
      medial::ThicknessOptions options;
      options.tolerance = this->Tolerance;
      options.separation = this->MeasureSeparation;
      options.points = this->NumberOfPoints;
      options.depth = this->MinimumDepth;
      options.volume.margin = this->Margin;
      if (this->UseBounds)
      {
        options.volume.bounds =
          Eigen::AlignedBox3d(medial::Point(this->Bounds[0], this->Bounds[2], this->Bounds[4]),
            medial::Point(this->Bounds[1], this->Bounds[3], this->Bounds[5]));
      }
      const medial::ThicknessReport report = medial::thicknessReport(
        balls, at ? &*at : nullptr, medialAxis ? &*medialAxis : nullptr, options, execution);
      medial::write(report, balls, input, places, axis, vtkDataSet::GetData(outputVector, 0),
        vtkTable::GetData(outputVector, 1), vtkTable::GetData(outputVector, 2));
    });
}

void vtkLocalThickness::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MeasureSeparation: " << (this->MeasureSeparation ? "on" : "off") << "\n";
  os << indent << "UseBounds: " << (this->UseBounds ? "on" : "off") << "\n";
  os << indent << "Bounds: " << this->Bounds[0] << " " << this->Bounds[1] << " " << this->Bounds[2]
     << " " << this->Bounds[3] << " " << this->Bounds[4] << " " << this->Bounds[5] << "\n";
  os << indent << "Margin: " << this->Margin << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "MinimumDepth: " << this->MinimumDepth << "\n";
}
