// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMedialPrune.h"

#include "Base/Errors.h"
#include "Conversion/Axis.h"
#include "Conversion/Parts.h"
#include "Conversion/Pruned.h"
#include "Conversion/SelectedCells.h"
#include "Parts/PartRanks.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"
#include "Pruning/RemovalByHand.h"

#include "vtkCompositeDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSelection.h"
#include "vtkTable.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

static_assert(vtkMedialPrune::COLLAPSE == static_cast<int>(medial::Topology::Collapse) &&
    vtkMedialPrune::NONE == static_cast<int>(medial::Topology::None) &&
    vtkMedialPrune::PAPER_GRAPH == static_cast<int>(medial::Topology::PaperGraph),
  "the property Topology is cast to the core's enum");

struct vtkMedialPrune::vtkLists
{
  std::vector<medial::PruneIteration> Schedule;
  std::string Fault; ///< what is wrong with the schedule; empty: nothing
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
  vtkWeakPointer<vtkCompositeDataSet> Collection; ///< that the input is, or was last
  vtkWeakPointer<vtkPolyData> Input;
  vtkMTimeType Time = 0;
  std::unique_ptr<medial::PrunableAxis> Prepared;
  std::vector<medial::Index> Ranks; ///< of the cells

  medial::PrunableAxis& Of(vtkPolyData* input)
  {
    if (this->Input != input || this->Time != input->GetMTime())
    {
      this->Input = nullptr;
      this->Prepared.reset();
      this->Prepared = std::make_unique<medial::PrunableAxis>(medial::readMedialAxis(input));
      this->Ranks = medial::readRanks(input);
      if (this->Ranks.empty())
      {
        this->Ranks = medial::ranksOfCells(this->Prepared->living, this->Prepared->measures);
      }
      this->Input = input;
      this->Time = input->GetMTime();
    }
    return *this->Prepared;
  }
};

namespace
{
std::string text(const char* characters)
{
  return characters ? characters : "";
}
}

vtkStandardNewMacro(vtkMedialPrune);
medialAbortMacro(vtkMedialPrune);

vtkMedialPrune::vtkMedialPrune()
  : Lists(new vtkLists)
  , Axis(new vtkAxis)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
  this->SetSchedule(medial::defaultSchedule());
}

vtkMedialPrune::~vtkMedialPrune() = default;

void vtkMedialPrune::ForgetAxis()
{
  this->Axis->Input = nullptr;
  this->Axis->Prepared.reset();
}

void vtkMedialPrune::ClearIterations()
{
  this->Lists->Schedule.clear();
  this->Lists->Fault.clear();
  medial::setErrorMessage(this, "");
  this->Modified();
}

void vtkMedialPrune::SetSchedule(const char* words)
{
  try
  {
    std::vector<medial::PruneIteration> schedule = medial::parseSchedule(text(words));
    if (this->Lists->Fault.empty() && schedule == this->Lists->Schedule)
    {
      return;
    }
    this->Lists->Schedule = std::move(schedule);
    this->Lists->Fault.clear();
    medial::setErrorMessage(this, "");
    this->Modified();
  }
  catch (const medial::InvalidInput& error)
  {
    this->RefuseSchedule(error.what());
  }
}

std::string vtkMedialPrune::GetScheduleWords() const
{
  return medial::scheduleWords(this->Lists->Schedule);
}

void vtkMedialPrune::AddIteration(int measure, double threshold, int passes)
{
  const medial::MeasureTraits* traits = medial::findMeasure(measure);
  if (!traits)
  {
    this->RefuseSchedule(medial::noMeasure(std::to_string(measure)));
    return;
  }
  const medial::PruneIteration iteration{ traits->measure, threshold, passes };
  const std::string fault = medial::faultOf(iteration);
  if (!fault.empty())
  {
    this->RefuseSchedule(fault);
    return;
  }
  this->Lists->Schedule.push_back(iteration);
  this->Modified();
}

void vtkMedialPrune::AddIterationByName(const char* measure, double threshold, int passes)
{
  const std::string name = text(measure);
  const medial::MeasureTraits* traits = medial::findMeasure(name);
  if (!traits)
  {
    this->RefuseSchedule(medial::noMeasure("'" + name + "'"));
    return;
  }
  this->AddIteration(static_cast<int>(traits->measure), threshold, passes);
}

void vtkMedialPrune::AddIterationFromText(
  const char* measure, const char* threshold, const char* passes)
{
  try
  {
    this->Lists->Schedule.push_back(
      medial::parseIteration(text(measure), text(threshold), text(passes)));
    this->Modified();
  }
  catch (const medial::InvalidInput& error)
  {
    this->RefuseSchedule(error.what());
  }
}

std::string vtkMedialPrune::GetIterationFault(
  const char* measure, const char* threshold, const char* passes)
{
  try
  {
    medial::parseIteration(text(measure), text(threshold), text(passes));
    return "";
  }
  catch (const medial::InvalidInput& error)
  {
    return error.what();
  }
}

void vtkMedialPrune::RefuseSchedule(const std::string& fault)
{
  this->Lists->Fault = fault;
  medial::setErrorMessage(this, fault);
  vtkErrorMacro(<< fault);
  this->Modified();
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
  // Once, and then for each block, which stands in the place of the collection.
  if (vtkCompositeDataSet* collection = vtkCompositeDataSet::GetData(inputVector[0]))
  {
    this->Axis->Collection = collection;
  }
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
      if (!this->Automatic && !lists.Fault.empty())
      {
        throw medial::InvalidInput(lists.Fault);
      }
      std::vector<vtkIdType>& cells =
        this->SelectionRole == REMOVE ? lists.CellsToRemove : lists.CellsToProtect;
      const vtkIdType block = medial::blockOf(axis, this->Axis->Collection);
      const std::vector<vtkIdType> selected = medial::selectedCells(selection, axis, block);
      cells.insert(cells.end(), selected.begin(), selected.end());
      medial::PruneOptions options;
      options.schedule = lists.Schedule;
      options.automatic = this->Automatic;
      options.topology = static_cast<medial::Topology>(this->Topology);
      options.removeHair = this->RemoveHair;
      options.removeBranches = this->RemoveBranches;
      options.neckRatio = this->SplitAtNecks ? this->NeckRatio : 0;
      options.verifyTopology = this->VerifyTopology;
      options.cellsToRemove =
        medial::readCells(axis, lists.PartsToRemove, lists.CellsToRemove, "removed");
      options.cellsToProtect =
        medial::readCells(axis, lists.PartsToProtect, lists.CellsToProtect, "protected");
      const medial::Pruned pruned = medial::prune(this->Axis->Of(axis), options, execution);
      medial::write(pruned, options.topology, this->Axis->Ranks, axis, output, history, removed);
      const std::string refusals =
        medial::refusals(pruned.fates, options.cellsToRemove, medial::readParts(axis));
      if (!refusals.empty())
      {
        vtkWarningMacro(<< refusals);
      }
    });
}

void vtkMedialPrune::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Schedule: " << this->GetScheduleWords() << "\n";
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
