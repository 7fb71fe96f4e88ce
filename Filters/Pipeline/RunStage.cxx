// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/RunStage.h"

#include "Base/Errors.h"
#include "Pipeline/Abort.h"
#include "Pipeline/ReportErrors.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkPointSet.h"

namespace medial
{
namespace
{
/// A warning of a stage, with VTK's file, line and object, as one of the filter that it works in.
void warn(vtkAlgorithm* filter, const char* text)
{
  if (filter->HasObserver(vtkCommand::WarningEvent))
  {
    filter->InvokeEvent(vtkCommand::WarningEvent, const_cast<char*>(text));
  }
  else
  {
    vtkOutputWindowDisplayWarningText(text);
  }
}

/// Passes a stage's progress and warnings on and stops the stage when asked to. While it listens, VTK
/// does not print the stage's errors.
class Listener
{
public:
  Listener(vtkAlgorithm* filter, const Stage& stage, const Execution& execution)
    : Filter(filter)
    , Inner(stage)
    , Work(execution)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long event, void* self, void* data) {
      static_cast<Listener*>(self)->receive(event, static_cast<const char*>(data));
    });
    for (const auto event :
      { vtkCommand::ProgressEvent, vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
    {
      this->Inner.filter->AddObserver(event, this->Command);
    }
    this->Inner.filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~Listener()
  {
    this->Inner.filter->RemoveObserver(this->Command);
    this->Inner.filter->GetExecutive()->RemoveObserver(this->Command);
  }

  bool Stopped = false;

private:
  void receive(unsigned long event, const char* text)
  {
    if (event == vtkCommand::ProgressEvent)
    {
      this->passProgressOn();
    }
    else if (event == vtkCommand::WarningEvent && this->Inner.tellsWarnings)
    {
      warn(this->Filter, text);
    }
  }

  void passProgressOn()
  {
    vtkAlgorithm* stage = this->Inner.filter;
    this->Stopped =
      this->Stopped || (this->Work.progress && !this->Work.progress(stage->GetProgress()));
    if (this->Stopped)
    {
      stage->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* Filter;
  const Stage& Inner;
  const Execution& Work;
  vtkNew<vtkCallbackCommand> Command;
};

void runStage(vtkAlgorithm* filter, const Stage& toRun, const Execution& execution)
{
  const Listener listener(filter, toRun, execution);
  vtkAlgorithm* stage = toRun.filter;
  stage->Update();
  if (stage->GetInformation()->Get(wasStopped()))
  {
    throw Aborted();
  }
  if (stage->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InvalidInput(errorMessage(stage));
  }
}
}

void runStages(vtkAlgorithm* filter, const std::vector<Stage>& stages, const Execution& execution)
{
  double done = 0;
  for (const Stage& stage : stages)
  {
    runStage(filter, stage, execution.between(done, done + stage.share));
    done += stage.share;
  }
}

void releaseOutputs(const std::vector<vtkAlgorithm*>& stages)
{
  for (vtkAlgorithm* stage : stages)
  {
    for (int port = 0; port < stage->GetNumberOfOutputPorts(); ++port)
    {
      if (auto* output = vtkPointSet::SafeDownCast(stage->GetOutputDataObject(port)))
      {
        vtkNew<vtkFieldData> field;
        field->ShallowCopy(output->GetFieldData());
        output->ReleaseData();
        output->SetFieldData(field);
      }
    }
  }
}
}
