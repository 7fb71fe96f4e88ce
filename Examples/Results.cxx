// SPDX-License-Identifier: BSD-3-Clause
#include "Results.h"

#include "Arguments.h"
#include "Messages.h"
#include "OutputFolder.h"
#include "PartMeshes.h"
#include "Tables.h"

#include <vtkCommand.h>
#include <vtkErrorCode.h>
#include <vtkMedialAxis.h>
#include <vtkMedialMeshWriter.h>
#include <vtkMedialPartDecomposition.h>
#include <vtkMedialPrune.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkSimplifyShape.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <chrono>
#include <utility>

/// Writes files when a stage has run without an error.
class Results::Writing
{
public:
  Writing(Results& results, vtkAlgorithm* stage, std::function<void()> files)
    : Owner(results)
    , Stage(stage)
    , Files(std::move(files))
    , Observer(stage->AddObserver(vtkCommand::EndEvent, this, &Writing::run))
  {
  }
  ~Writing() { this->Stage->RemoveObserver(this->Observer); }
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;

private:
  /// What goes wrong is kept: exceptions can't go through VTK's pipeline.
  void run()
  {
    if (this->Stage->GetErrorCode() != vtkErrorCode::NoError || !messages::error().empty() ||
      this->Stage->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT) == 0)
    {
      return; // it failed, or was stopped
    }
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    try
    {
      this->Files();
    }
    catch (...)
    {
      this->Owner.Error = std::current_exception();
      this->Owner.Simplify->SetAbortExecute(1);
    }
    this->Owner.Seconds += std::chrono::duration<double>(Clock::now() - begin).count();
  }

  Results& Owner;
  vtkSmartPointer<vtkAlgorithm> Stage;
  std::function<void()> Files;
  unsigned long Observer;
};

Results::Results(vtkSimplifyShape* simplify, OutputFolder& folder, const Arguments& arguments)
  : Simplify(simplify)
  , Folder(folder)
  , HasMedialMeshes(arguments.medialMeshes)
  , HasPartMeshes(arguments.exportParts)
{
  simplify->KeepAxisOff();
  this->writeAfter(simplify->GetMedialAxis(), [this] { this->writeAxis(); });
  this->writeAfter(simplify->GetUnprunedPartDecomposition(), [this] { this->writeParts(); });
  this->writeAfter(simplify->GetMedialPrune(), [this] { this->writePruned(); });
}

Results::~Results() = default;

void Results::writeAfter(vtkAlgorithm* stage, const std::function<void()>& files)
{
  this->Writings.push_back(std::make_unique<Writing>(*this, stage, files));
}

void Results::check() const
{
  if (this->Error)
  {
    std::rethrow_exception(this->Error);
  }
}

/// Writes the arrays as text within the XML. By default VTK appends raw data after the XML, which
/// ParaView 5.11 can't read with the expat library of an updated Debian 12.
template <typename Writer>
void Results::write(vtkDataObject* data, const std::string& name)
{
  vtkNew<Writer> writer;
  writer->SetInputData(data);
  writer->SetDataModeToBinary();
  writer->SetCompressor(this->Compression);
  this->Folder.write(writer, name);
}

void Results::writeAxis()
{
  vtkPolyData* axis = this->Simplify->GetMedialAxis()->GetOutput();
  this->AxisTriangles = axis->GetNumberOfPolys();
  this->write<vtkXMLPolyDataWriter>(axis, "axis.vtp");
  this->writeMedialMesh(axis, "axis.ma");
  this->Compression
    ->learnNoMore(); // the parts have all that the axis has; pruning keeps its points
}

void Results::writeParts()
{
  vtkMedialPartDecomposition* parts = this->Simplify->GetUnprunedPartDecomposition();
  this->write<vtkXMLPolyDataWriter>(parts->GetOutput(), "parts.vtp");
  this->Folder.writeText(csv(vtkTable::SafeDownCast(parts->GetOutputDataObject(1))), "parts.csv");
}

void Results::writePruned()
{
  vtkMedialPrune* pruned = this->Simplify->GetMedialPrune();
  this->write<vtkXMLPolyDataWriter>(pruned->GetOutput(), "pruned.vtp");
  this->writeMedialMesh(pruned->GetOutput(), "pruned.ma");
  this->Folder.writeText(
    csv(vtkTable::SafeDownCast(pruned->GetOutputDataObject(1))), "history.csv");
  this->Compression = vtkSmartPointer<Compressor>::New();
  this->Compression->learnNoMore();
}

void Results::writeRest()
{
  this->write<vtkXMLUnstructuredGridWriter>(this->Simplify->GetBalls(), "balls.vtu");
  this->write<vtkXMLPolyDataWriter>(this->Simplify->GetSamples(), "samples.vtp");
  this->write<vtkXMLPolyDataWriter>(this->Simplify->GetOutput(), "surface.vtp");
  this->writeStl(this->Simplify->GetOutput(), "surface.stl");
  if (this->HasPartMeshes)
  {
    this->writePartMeshes();
  }
}

void Results::writeMedialMesh(vtkPolyData* axis, const std::string& name)
{
  if (this->HasMedialMeshes)
  {
    vtkNew<vtkMedialMeshWriter> writer;
    writer->SetInputData(axis);
    this->Folder.write(writer, name);
  }
}

void Results::writeStl(vtkPolyData* triangles, const std::string& name)
{
  vtkNew<vtkSTLWriter> writer;
  writer->SetInputData(triangles);
  writer->SetFileTypeToBinary();
  this->Folder.write(writer, name);
}

void Results::writePartMeshes()
{
  const std::vector<PartMesh> meshes =
    partMeshes(this->Simplify->GetMedialPrune()->GetOutput(), this->Simplify->GetOutput());
  for (const PartMesh& mesh : meshes)
  {
    if (!mesh.file().empty())
    {
      this->writeStl(mesh.patch, mesh.file());
    }
  }
  this->Folder.writeText(csv(tableOf(meshes)), "exported.csv");
}
