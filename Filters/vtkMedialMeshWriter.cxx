// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMedialMeshWriter.h"

#include "Base/Errors.h"
#include "Conversion/MedialMesh.h"
#include "Exchange/FileContent.h"
#include "Exchange/MedialMeshText.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkMedialMeshWriter);
medialAbortMacro(vtkMedialMeshWriter);

vtkMedialMeshWriter::~vtkMedialMeshWriter()
{
  delete[] this->FileName;
}

int vtkMedialMeshWriter::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkMedialMeshWriter::WriteData()
{
  vtkNew<vtkInformationVector> noOutputs;
  this->OutputString.clear();
  medial::reportErrorsOfAllRanks(this, noOutputs, [this](const medial::Execution& execution) {
    if (!this->WriteToOutputString && (!this->FileName || !*this->FileName))
    {
      throw medial::InvalidInput("no file is named: set FileName");
    }
    const medial::MedialMesh mesh =
      medial::readMedialMesh(vtkPolyData::SafeDownCast(this->GetInput()));
    std::string text = medial::textOf(mesh, execution);
    if (this->WriteToOutputString)
    {
      this->OutputString = std::move(text);
      return;
    }
    medial::writeContent(this->FileName, text);
  });
  if (this->GetInformation()->Get(medial::wasStopped()))
  {
    this->GetInformation()->Set(medial::wasStopped(), 0);
    medial::setErrorCode(this, vtkErrorCode::UserError); // so that Write() tells it
  }
}

void vtkMedialMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "WriteToOutputString: " << (this->WriteToOutputString ? "on" : "off") << "\n";
}
