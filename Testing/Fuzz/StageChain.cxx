// SPDX-License-Identifier: BSD-3-Clause
#include "StageChain.h"

#include "FilterTest.h"
#include "Sense.h"

#include "vtkMedialAxis.h"
#include "vtkMedialPartDecomposition.h"
#include "vtkMedialPrune.h"
#include "vtkPolarBalls.h"
#include "vtkPowerCrust.h"

#include <vtkErrorCode.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

namespace fuzz
{
namespace
{
/// Keeps what VTK would print.
class Listener : public vtkOutputWindow
{
public:
  static Listener* New();
  vtkTypeMacro(Listener, vtkOutputWindow);
  void DisplayErrorText(const char* text) override { this->Errors.emplace_back(text); }
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayText(const char*) override {}

  std::vector<std::string> Errors;
};
vtkStandardNewMacro(Listener);

/// Updates a filter that gives an error with empty outputs, or outputs that make sense.
/// @return  the first output; nullptr after an error
vtkSmartPointer<vtkPointSet> updated(vtkAlgorithm* filter, std::string& faults)
{
  vtkNew<Listener> listener;
  vtkOutputWindow::SetInstance(listener);
  const filterTest::ErrorLog log(filter);
  filter->Update();
  vtkOutputWindow::SetInstance(nullptr);
  const std::string name = filter->GetClassName();
  const bool failed = filter->GetErrorCode() != vtkErrorCode::NoError;
  for (const std::string& error : listener->Errors)
  {
    faults += "while " + name + " runs VTK itself complains: " + error + "\n";
  }
  if (log.messages().size() != (failed ? 1u : 0u))
  {
    faults += name + " gives " + std::to_string(log.messages().size()) + " errors\n";
  }
  const auto note = [&](int port, const std::string& fault) {
    faults += fault.empty() ? "" : name + ", output " + std::to_string(port) + ": " + fault + "\n";
  };
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    note(port, failed ? leftOver(output) : nonsense(output));
  }
  if (!failed) // other outputs have arrays of the input, which no stage reads, as they are
  {
    note(0, badMeasures(filter->GetOutputDataObject(0)));
  }
  return failed ? nullptr : vtkPointSet::SafeDownCast(filter->GetOutputDataObject(0));
}

vtkSmartPointer<vtkPointSet> axisOf(vtkPointSet* balls, std::string& faults)
{
  vtkNew<vtkMedialAxis> filter;
  filter->SetInputData(balls);
  return updated(filter, faults);
}

vtkSmartPointer<vtkPointSet> partsOf(vtkPointSet* axis, std::string& faults)
{
  vtkNew<vtkMedialPartDecomposition> filter;
  filter->SetInputData(axis);
  return updated(filter, faults);
}

vtkSmartPointer<vtkPointSet> prunedOf(vtkPointSet* axis, std::string& faults)
{
  vtkNew<vtkMedialPrune> filter;
  filter->SetInputData(axis);
  filter->SetSchedule("t5 v1%");
  return updated(filter, faults);
}

/// The axis as the only block of a collection: which block belongs to the balls is asked before any is
/// checked.
vtkSmartPointer<vtkDataObject> asBlock(vtkPointSet* axis)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, axis);
  return blocks;
}

void makeCrust(vtkPointSet* balls, vtkDataObject* axis, std::string& faults)
{
  vtkNew<vtkPowerCrust> filter;
  filter->SetInputData(balls);
  filter->SetAxisData(axis);
  const vtkSmartPointer<vtkPointSet> surface = updated(filter, faults);
  const std::string fault = surface ? notSolid(vtkPolyData::SafeDownCast(surface)) : "";
  faults += fault.empty() ? "" : "the surface " + fault + "\n";
}
}

const char* kindName(int kind)
{
  const char* const names[] = { "balls", "axis", "parts", "pruned" };
  return names[kind];
}

Stages stagesOf(const std::string& name, const std::vector<medial::Point>& samples)
{
  vtkNew<vtkPolarBalls> balls;
  balls->SetInputData(filterTest::cloud(samples));
  balls->Update();
  Stages result;
  std::string faults;
  result.name = name;
  result.data[Balls] = vtkPointSet::SafeDownCast(balls->GetOutputDataObject(0));
  result.data[Axis] = axisOf(result.data[Balls], faults);
  result.data[Parts] = partsOf(result.data[Axis], faults);
  result.data[Pruned] = prunedOf(result.data[Parts], faults);
  return result;
}

std::string faultsOf(const Stages& stages, int kind)
{
  std::string faults;
  vtkSmartPointer<vtkPointSet> pruned = stages.data[kind];
  makeCrust(stages.data[Balls], asBlock(stages.data[kind == Balls ? Pruned : kind]), faults);
  if (kind == Balls)
  {
    makeCrust(stages.data[Balls], nullptr, faults);
    pruned = axisOf(stages.data[Balls], faults);
  }
  if (pruned && kind != Pruned)
  {
    partsOf(pruned, faults);
  }
  if (pruned)
  {
    makeCrust(stages.data[Balls], pruned, faults);
    pruned = prunedOf(pruned, faults);
  }
  if (pruned)
  {
    makeCrust(stages.data[Balls], pruned, faults);
  }
  return faults;
}
}
