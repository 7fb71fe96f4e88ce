// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMedialPartDecomposition.h"

#include "Conversion/Axis.h"
#include "Conversion/Parts.h"
#include "Parts/PartColors.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

vtkStandardNewMacro(vtkMedialPartDecomposition);
medialAbortMacro(vtkMedialPartDecomposition);

vtkMedialPartDecomposition::vtkMedialPartDecomposition()
{
  this->SetNumberOfOutputPorts(4);
}

void vtkMedialPartDecomposition::GetPartColor(vtkIdType part, double rgb[3])
{
  const std::array<double, 3> color = medial::partColor(part);
  std::copy(color.begin(), color.end(), rgb);
}

int vtkMedialPartDecomposition::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkMedialPartDecomposition::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

int vtkMedialPartDecomposition::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  vtkPolyData* contacts = vtkPolyData::GetData(outputVector, 2);
  vtkPolyData* graph = vtkPolyData::GetData(outputVector, 3);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      const medial::MedialAxis axis = medial::readMedialAxis(input);
      const medial::MedialParts parts = medial::decompose(
        axis, this->MaximumLevel, execution, this->SplitAtNecks ? this->NeckRatio : 0);
      medial::write(parts, input, output, table, contacts);
      const medial::Index partCount = medial::count(parts.parts);
      medial::write(medial::topologyGraph(parts.contacts, partCount, axis.points), parts, graph);
    });
}

void vtkMedialPartDecomposition::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "SplitAtNecks: " << (this->SplitAtNecks ? "on" : "off") << "\n";
  os << indent << "NeckRatio: " << this->NeckRatio << "\n";
}
