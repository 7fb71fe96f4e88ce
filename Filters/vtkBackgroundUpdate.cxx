// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBackgroundUpdate.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"

#include <atomic>
#include <thread>

/// One update. The thread sees the filter, and shares with the caller only what is atomic.
struct vtkBackgroundUpdate::vtkRun
{
  explicit vtkRun(vtkAlgorithm* filter)
    : Filter(filter)
  {
    this->Listener->SetClientData(this);
    this->Listener->SetCallback([](vtkObject*, unsigned long event, void* run, void*) {
      if (event == vtkCommand::ProgressEvent)
      {
        static_cast<vtkRun*>(run)->NoteProgress();
      }
    });
    filter->AddObserver(vtkCommand::ProgressEvent, this->Listener);
    this->Silence(filter);
    this->Silence(filter->GetExecutive());
    this->Thread = std::thread([this] {
      this->Filter->Update();
      this->Done = true;
    });
  }

  ~vtkRun()
  {
    this->Stopped = true;
    this->Thread.join();
    this->Filter->RemoveObserver(this->Listener);
    this->Filter->GetExecutive()->RemoveObserver(this->Listener);
  }

  /// VTK prints what nobody listens to.
  void Silence(vtkObject* sender)
  {
    sender->AddObserver(vtkCommand::ErrorEvent, this->Listener);
    sender->AddObserver(vtkCommand::WarningEvent, this->Listener);
  }

  /// Since VTK 9.2 a stopped run reports that it is done.
  void NoteProgress()
  {
    if (this->Stopped)
    {
      this->Filter->SetAbortExecute(1);
      return;
    }
    this->Progress = this->Filter->GetProgress();
  }

  vtkSmartPointer<vtkAlgorithm> Filter;
  vtkNew<vtkCallbackCommand> Listener;
  std::atomic<double> Progress{ 0 };
  std::atomic<bool> Stopped{ false };
  std::atomic<bool> Done{ false };
  std::thread Thread;
};

vtkStandardNewMacro(vtkBackgroundUpdate);

vtkBackgroundUpdate::vtkBackgroundUpdate() = default;
vtkBackgroundUpdate::~vtkBackgroundUpdate() = default;

void vtkBackgroundUpdate::Start(vtkAlgorithm* filter)
{
  if (!filter || this->IsRunning())
  {
    vtkErrorMacro("an update can't begin: " << (filter ? "another one is under way" : "no filter"));
    return;
  }
  this->Run = nullptr;
  this->Run = std::make_unique<vtkRun>(filter);
}

bool vtkBackgroundUpdate::IsRunning()
{
  return this->Run && !this->Run->Done;
}

double vtkBackgroundUpdate::GetProgress()
{
  return this->Run ? this->Run->Progress.load() : 0;
}

void vtkBackgroundUpdate::Stop()
{
  if (this->Run)
  {
    this->Run->Stopped = true;
  }
}

void vtkBackgroundUpdate::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Running: " << (this->IsRunning() ? "yes" : "no") << "\n";
  os << indent << "Progress: " << this->GetProgress() << "\n";
}
