// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMedialPrune.h"

#include "Base/Errors.h"
#include "Conversion/Axis.h"
#include "Conversion/Parts.h"
#include "Conversion/Pruned.h"
#include "Conversion/SelectedCells.h"
#include "Pipeline/ReportErrors.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkTable.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <string>
#include <vector>

static_assert(vtkMedialPrune::TRIANGLE_COUNT == static_cast<int>(medial::Measure::TriangleCount) &&
    vtkMedialPrune::RELATIVE_VOLUME == static_cast<int>(medial::Measure::RelativeVolume) &&
    vtkMedialPrune::POLE_VOLUME == static_cast<int>(medial::Measure::PoleVolume) &&
    vtkMedialPrune::AREA == static_cast<int>(medial::Measure::Area) &&
    vtkMedialPrune::MEAN_RADIUS == static_cast<int>(medial::Measure::MeanRadius) &&
    vtkMedialPrune::MAXIMUM_RADIUS == static_cast<int>(medial::Measure::MaximumRadius) &&
    vtkMedialPrune::OBJECT_ANGLE == static_cast<int>(medial::Measure::ObjectAngle) &&
    vtkMedialPrune::LAMBDA == static_cast<int>(medial::Measure::Lambda) &&
    vtkMedialPrune::EROSION_THICKNESS == static_cast<int>(medial::Measure::ErosionThickness) &&
    vtkMedialPrune::HAUSDORFF_DISTANCE == static_cast<int>(medial::Measure::HausdorffDistance) &&
    vtkMedialPrune::COLLAPSE == static_cast<int>(medial::Topology::Collapse) &&
    vtkMedialPrune::NONE == static_cast<int>(medial::Topology::None) &&
    vtkMedialPrune::PAPER_GRAPH == static_cast<int>(medial::Topology::PaperGraph),
  "measures and the property Topology are cast to the core's enums");

struct vtkMedialPrune::vtkLists
{
  std::vector<medial::PruneIteration> Schedule;
  std::string Unknown; ///< a measure of the schedule that there isn't, in words; empty: none
  std::vector<vtkIdType> PartsToRemove;
  std::vector<vtkIdType> CellsToRemove;
  std::vector<vtkIdType> PartsToProtect;
  std::vector<vtkIdType> CellsToProtect;

  medial::PruneIteration Iteration(int number) const
  {
    const bool exists = number >= 0 && number < static_cast<int>(this->Schedule.size());
    return exists ? this->Schedule[number] : medial::PruneIteration{ {}, 0, 0 };
  }
};

/// The last input, read and prepared: kept for the next threshold, until it changes.
struct vtkMedialPrune::vtkAxis
{
  vtkWeakPointer<vtkPolyData> Input;
  vtkMTimeType Time = 0;
  std::unique_ptr<medial::PrunableAxis> Prepared;

  medial::PrunableAxis& Of(vtkPolyData* input)
  {
    if (this->Input != input || this->Time != input->GetMTime())
    {
      this->Input = nullptr;
      this->Prepared.reset();
      this->Prepared = std::make_unique<medial::PrunableAxis>(medial::readMedialAxis(input));
      this->Input = input;
      this->Time = input->GetMTime();
    }
    return *this->Prepared;
  }
};

vtkStandardNewMacro(vtkMedialPrune);

vtkMedialPrune::vtkMedialPrune()
  : Lists(new vtkLists)
  , Axis(new vtkAxis)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
  this->AddIteration(TRIANGLE_COUNT, 5);
  this->AddIteration(TRIANGLE_COUNT, 5);
  this->AddIteration(RELATIVE_VOLUME, 0.01);
}

vtkMedialPrune::~vtkMedialPrune() = default;

void vtkMedialPrune::ClearIterations()
{
  this->Lists->Schedule.clear();
  this->Lists->Unknown.clear();
  this->Modified();
}

void vtkMedialPrune::AddIteration(int measure, double threshold, int passes)
{
  if (!GetMeasureName(measure))
  {
    this->RefuseMeasure(std::to_string(measure));
    return;
  }
  this->Lists->Schedule.push_back(
    { static_cast<medial::Measure>(measure), threshold, std::max(0, passes) });
  this->Modified();
}

void vtkMedialPrune::AddIterationByName(const char* measure, double threshold, int passes)
{
  const std::string name = measure ? measure : "";
  const medial::MeasureTraits* traits = medial::findMeasure(name);
  if (!traits)
  {
    this->RefuseMeasure("'" + name + "'");
    return;
  }
  this->AddIteration(static_cast<int>(traits->measure), threshold, passes);
}

void vtkMedialPrune::RefuseMeasure(const std::string& measure)
{
  this->Lists->Unknown =
    "there is no measure " + measure + " for the schedule; use one of " + medial::measureNames();
  vtkErrorMacro(<< this->Lists->Unknown);
  this->Modified();
}

const char* vtkMedialPrune::GetMeasureName(int measure)
{
  const medial::MeasureTraits* traits = medial::findMeasure(measure);
  return traits ? traits->name : nullptr;
}

int vtkMedialPrune::GetNumberOfIterations() const
{
  return static_cast<int>(this->Lists->Schedule.size());
}

int vtkMedialPrune::GetIterationMeasure(int iteration) const
{
  return static_cast<int>(this->Lists->Iteration(iteration).measure);
}

double vtkMedialPrune::GetIterationThreshold(int iteration) const
{
  return this->Lists->Iteration(iteration).threshold;
}

int vtkMedialPrune::GetIterationPasses(int iteration) const
{
  return this->Lists->Iteration(iteration).passes;
}

void vtkMedialPrune::ClearPartsToRemove()
{
  this->Lists->PartsToRemove.clear();
  this->Modified();
}

void vtkMedialPrune::AddPartToRemove(vtkIdType part)
{
  this->Lists->PartsToRemove.push_back(part);
  this->Modified();
}

vtkIdType vtkMedialPrune::GetNumberOfPartsToRemove() const
{
  return static_cast<vtkIdType>(this->Lists->PartsToRemove.size());
}

void vtkMedialPrune::ClearCellsToRemove()
{
  this->Lists->CellsToRemove.clear();
  this->Modified();
}

void vtkMedialPrune::AddCellToRemove(vtkIdType cell)
{
  this->Lists->CellsToRemove.push_back(cell);
  this->Modified();
}

vtkIdType vtkMedialPrune::GetNumberOfCellsToRemove() const
{
  return static_cast<vtkIdType>(this->Lists->CellsToRemove.size());
}

void vtkMedialPrune::ClearPartsToProtect()
{
  this->Lists->PartsToProtect.clear();
  this->Modified();
}

void vtkMedialPrune::AddPartToProtect(vtkIdType part)
{
  this->Lists->PartsToProtect.push_back(part);
  this->Modified();
}

vtkIdType vtkMedialPrune::GetNumberOfPartsToProtect() const
{
  return static_cast<vtkIdType>(this->Lists->PartsToProtect.size());
}

void vtkMedialPrune::ClearCellsToProtect()
{
  this->Lists->CellsToProtect.clear();
  this->Modified();
}

void vtkMedialPrune::AddCellToProtect(vtkIdType cell)
{
  this->Lists->CellsToProtect.push_back(cell);
  this->Modified();
}

vtkIdType vtkMedialPrune::GetNumberOfCellsToProtect() const
{
  return static_cast<vtkIdType>(this->Lists->CellsToProtect.size());
}

int vtkMedialPrune::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkSelection");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port);
  return 1;
}

int vtkMedialPrune::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 1 ? "vtkTable" : "vtkPolyData");
  return 1;
}

int vtkMedialPrune::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  return medial::requestWholeInputs(this, request, inputVector, outputVector);
}

int vtkMedialPrune::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* axis = vtkPolyData::GetData(inputVector[0]);
  vtkSelection* selection = vtkSelection::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* history = vtkTable::GetData(outputVector, 1);
  vtkPolyData* removed = vtkPolyData::GetData(outputVector, 2);
  return medial::reportErrors(
    this, request, inputVector, outputVector, [&](const medial::Execution& execution) {
      vtkLists lists = *this->Lists;
      if (!this->Automatic && !lists.Unknown.empty())
      {
        throw medial::InvalidInput(lists.Unknown);
      }
      std::vector<vtkIdType>& cells =
        this->SelectionRole == REMOVE ? lists.CellsToRemove : lists.CellsToProtect;
      const std::vector<vtkIdType> selected = medial::selectedCells(selection, axis);
      cells.insert(cells.end(), selected.begin(), selected.end());
      const medial::PruneOptions options{ lists.Schedule, this->Automatic,
        static_cast<medial::Topology>(this->Topology), this->RemoveHair, this->RemoveBranches,
        this->SplitAtNecks ? this->NeckRatio : 0, this->VerifyTopology,
        medial::readCells(axis, lists.PartsToRemove, lists.CellsToRemove, "removed"),
        medial::readCells(axis, lists.PartsToProtect, lists.CellsToProtect, "protected") };
      const medial::Pruned pruned = medial::prune(this->Axis->Of(axis), options, execution);
      medial::write(pruned, axis, output, history, removed);
      const std::string refusals = medial::refusals(pruned, options.cellsToRemove, axis);
      if (!refusals.empty())
      {
        vtkWarningMacro(<< refusals);
      }
    });
}

void vtkMedialPrune::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Schedule: " << this->GetNumberOfIterations() << " iterations\n";
  medial::print(os, indent.GetNextIndent(), this->Lists->Schedule);
  const char* const topologies[] = { "COLLAPSE", "NONE", "PAPER_GRAPH" };
  os << indent << "Topology: " << topologies[this->Topology] << "\n";
  os << indent << "SplitAtNecks: " << (this->SplitAtNecks ? "on" : "off") << "\n";
  os << indent << "NeckRatio: " << this->NeckRatio << "\n";
  os << indent << "Automatic: " << (this->Automatic ? "on" : "off") << "\n";
  os << indent << "VerifyTopology: " << (this->VerifyTopology ? "on" : "off") << "\n";
  os << indent << "RemoveHair: " << (this->RemoveHair ? "on" : "off") << "\n";
  os << indent << "RemoveBranches: " << (this->RemoveBranches ? "on" : "off") << "\n";
  os << indent << "PartsToRemove: " << this->GetNumberOfPartsToRemove() << "\n";
  os << indent << "CellsToRemove: " << this->GetNumberOfCellsToRemove() << "\n";
  os << indent << "PartsToProtect: " << this->GetNumberOfPartsToProtect() << "\n";
  os << indent << "CellsToProtect: " << this->GetNumberOfCellsToProtect() << "\n";
  os << indent << "SelectionRole: " << (this->SelectionRole == REMOVE ? "REMOVE" : "PROTECT")
     << "\n";
}
