// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/RunStage.h"

#include "Base/Errors.h"
#include "Pipeline/ReportErrors.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

namespace medial
{
namespace
{
/// Passes a filter's progress on and stops the filter when asked to. While it listens, VTK does not
/// print the filter's errors.
class Listener
{
public:
  Listener(vtkAlgorithm* stage, const Execution& execution)
    : Stage(stage)
    , Work(execution)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long event, void* self, void*) {
      if (event == vtkCommand::ProgressEvent)
      {
        static_cast<Listener*>(self)->passProgressOn();
      }
    });
    stage->AddObserver(vtkCommand::ProgressEvent, this->Command);
    stage->AddObserver(vtkCommand::ErrorEvent, this->Command);
    stage->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~Listener()
  {
    this->Stage->RemoveObserver(this->Command);
    this->Stage->GetExecutive()->RemoveObserver(this->Command);
  }

  bool Stopped = false;

private:
  void passProgressOn()
  {
    this->Stopped =
      this->Stopped || (this->Work.progress && !this->Work.progress(this->Stage->GetProgress()));
    this->Stage->SetAbortExecute(this->Stopped);
  }

  vtkAlgorithm* Stage;
  const Execution& Work;
  vtkNew<vtkCallbackCommand> Command;
};

void runStage(vtkAlgorithm* stage, const Execution& execution)
{
  const Listener listener(stage, execution);
  stage->Update();
  if (listener.Stopped)
  {
    stage->SetAbortExecute(0);
    stage->Modified(); // its empty output is not the result: run it again at the next update
    throw Aborted();
  }
  if (stage->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InvalidInput(errorMessage(stage));
  }
}
}

void runStages(const std::vector<Stage>& stages, const Execution& execution)
{
  double done = 0;
  for (const Stage& stage : stages)
  {
    runStage(stage.filter, execution.between(done, done + stage.share));
    done += stage.share;
  }
}
}
