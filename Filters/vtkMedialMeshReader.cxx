// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMedialMeshReader.h"

#include "Base/Errors.h"
#include "Conversion/MedialMesh.h"
#include "Exchange/FileContent.h"
#include "Exchange/MedialMeshParser.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkMedialMeshReader);
medialAbortMacro(vtkMedialMeshReader);

vtkMedialMeshReader::vtkMedialMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkMedialMeshReader::~vtkMedialMeshReader()
{
  delete[] this->FileName;
}

int vtkMedialMeshReader::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkMedialMeshReader::RequestData(vtkInformation* request,
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  return medial::reportErrorsOfAllRanks(
    this, outputVector, [&](const medial::Execution& execution) {
      if (!medial::isFirstPiece(request, outputVector))
      {
        return;
      }
      if (!this->FileName || !*this->FileName)
      {
        throw medial::InvalidInput("no file is named: set FileName");
      }
      const std::string text = medial::contentOf(this->FileName, execution);
      const medial::ParsedMedialMesh parsed =
        medial::parsedMedialMesh(this->FileName, text, execution);
      medial::write(parsed.mesh, vtkPolyData::GetData(outputVector));
      if (parsed.tetrahedra > 0)
      {
        vtkWarningMacro(<< this->FileName
                        << ": tetrahedra are left out, since a medial mesh is read as "
                        << "points, edges and triangles: " << parsed.tetrahedra);
      }
      if (parsed.repeated > 0)
      {
        vtkWarningMacro(<< this->FileName
                        << ": edges and triangles that come again are taken once; left out: "
                        << parsed.repeated);
      }
    });
}

void vtkMedialMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
