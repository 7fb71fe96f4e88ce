// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCollectParts.h"

#include "Collections/CollectParts.h"
#include "Pipeline/ReportErrors.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTypes.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

vtkStandardNewMacro(vtkCollectParts);

vtkCollectParts::vtkCollectParts()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

int vtkCollectParts::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkCollectParts::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkTable" : "vtkCompositeDataSet");
  return 1;
}

int vtkCollectParts::RequestDataObject(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto make = [outputVector](int port, const char* type) {
    vtkDataObject* output = vtkDataObject::GetData(outputVector, port);
    if (!output || !output->IsA(type))
    {
      outputVector->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(),
        vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type)));
    }
  };
  vtkDataObject* parts = vtkDataObject::GetData(inputVector[1]);
  make(0, "vtkTable");
  make(1, parts ? parts->GetClassName() : "vtkMultiBlockDataSet");
  return 1;
}

int vtkCollectParts::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::reportErrorsOfAllRanks(this, outputVector, [&](const medial::Execution&) {
    auto* tables = vtkCompositeDataSet::GetData(inputVector[0]);
    auto* parts = vtkCompositeDataSet::GetData(inputVector[1]);
    auto* ranks = vtkMultiProcessController::GetGlobalController();
    const std::vector<vtkIdType> firstParts =
      medial::firstParts(tables, this->UniquePartIds, ranks);
    medial::collectTables(tables, firstParts, ranks, vtkTable::GetData(outputVector, 0));
    medial::renumberParts(parts, firstParts, vtkCompositeDataSet::GetData(outputVector, 1));
  });
}

void vtkCollectParts::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "UniquePartIds: " << (this->UniquePartIds ? "on" : "off") << "\n";
}
