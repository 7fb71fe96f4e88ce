// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/RunStage.h"

#include "Base/Errors.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"

#include <string>

namespace medial
{
namespace
{
/// What is heard of a filter while it works.
class Listener
{
public:
  Listener(vtkAlgorithm* stage, const Execution& execution)
    : Stage(stage)
    , Work(execution)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject* sender, unsigned long event, void* self, void* data) {
      static_cast<Listener*>(self)->hear(sender, event, data);
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
  std::string Error;

private:
  void hear(vtkObject* sender, unsigned long event, void* data)
  {
    if (event == vtkCommand::ProgressEvent)
    {
      this->Stopped =
        this->Stopped || (this->Work.progress && !this->Work.progress(this->Stage->GetProgress()));
      this->Stage->SetAbortExecute(this->Stopped);
    }
    else if (sender == this->Stage && this->Error.empty())
    {
      // "ERROR: In file, line number\nclass (address): message\n\n"
      const std::string text = static_cast<const char*>(data);
      const std::size_t begin = text.find("): ");
      this->Error = begin == std::string::npos ? text : text.substr(begin + 3);
      this->Error.erase(this->Error.find_last_not_of('\n') + 1);
    }
  }

  vtkAlgorithm* Stage;
  const Execution& Work;
  vtkNew<vtkCallbackCommand> Command;
};
}

void runStage(vtkAlgorithm* stage, const Execution& execution)
{
  const Listener listener(stage, execution);
  stage->Update();
  if (listener.Stopped)
  {
    stage->SetAbortExecute(0);
    stage->Modified(); // its empty output isn't the answer
    throw Aborted();
  }
  if (stage->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw InvalidInput(listener.Error);
  }
}
}
